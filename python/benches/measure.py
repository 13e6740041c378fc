"""Measures the package against its limits: `python measure.py` prints a table of medians.

Positions of the four-bar K1 of the benchmarks, 1e6 of them on one thread: its tracer point (K1a), the
point with both derivatives (K1b), and with all sensitivities (K1c). Rivals are NumPy with closed
forms, Numba, JAX and CasADi, each if it is installed; all results are compared first. Results go into
arrays that exist, where a rival can do that.

    cargo bench -p linkage-benches --bench engine > macro.txt     # the macro's times, for --macro
    python measure.py --macro macro.txt --wheel FILE --mechanisms 1e8

`--mechanisms` measures two Dask workers against one process, `--wheel` is a built wheel.
"""

import argparse
import importlib.util
import os
import re
import statistics
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

import linkage
import numpy as np

ROOT = Path(__file__).resolve().parents[2]

#: The mechanisms of the benchmarks.
MECHANISMS = ROOT / "benches" / "peers" / "src" / "mechanisms.rs"

KERNELS = {"K1a": "point", "K1b": "motion", "K1c": "accuracy"}

COUNT = 1_000_000


class Limit(NamedTuple):
    """A figure, the most that it may be, the aim, and the figure that was measured."""

    name: str
    most: float
    aim: float
    found: float


def median(work, rounds: int) -> float:
    """Nanoseconds for each position: the median of the processor's time, that of all threads."""
    work()
    times = []
    for _ in range(rounds):
        begin = time.process_time()
        work()
        times.append(time.process_time() - begin)
    return 1e9 * statistics.median(times) / COUNT


#: Dimensions of K1; the arm is given along the coupler and across.
CRANK, COUPLER, ROCKER, FRAME = 50.0, 120.0, 100.0, 140.0
ALONG, ACROSS = 70.0 * np.cos(np.radians(25)), 70.0 * np.sin(np.radians(25))


def tracer(np, phi):
    """The tracer point by a closed form without angles, for any module with NumPy's functions."""
    x, y = CRANK * np.cos(phi), CRANK * np.sin(phi)
    dx, dy = FRAME - x, 0.0 - y
    d2 = dx * dx + dy * dy
    along = 0.5 * (COUPLER * COUPLER - ROCKER * ROCKER + d2)
    across = np.sqrt(COUPLER * COUPLER * d2 - along * along)
    share = 1.0 / (COUPLER * d2)
    u, v = share * (along * dx - across * dy), share * (along * dy + across * dx)
    return x + ALONG * u - ACROSS * v, y + ALONG * v + ACROSS * u


def rivals(phi, right, rounds: int) -> dict[str, float]:
    """Times of the tracer point, by rivals that compute the right one."""
    makers = {"NumPy": ("numpy", _numpy), "Numba": ("numba", _numba)}
    makers |= {"JAX": ("jax", _jax), "CasADi map": ("casadi", _casadi)}
    found = {}
    for name, (module, make) in makers.items():
        if importlib.util.find_spec(module):
            work = make(phi)
            assert np.allclose(np.asarray(work()).reshape(2, -1).T, right, atol=1e-9), name
            found[name] = median(work, rounds)
    return found


def _numpy(phi):
    return lambda: tracer(np, phi)


def _numba(phi):
    import math

    import numba

    @numba.njit(fastmath=True, error_model="numpy")
    def loop(phi, out):
        for k in range(phi.size):
            x, y = CRANK * math.cos(phi[k]), CRANK * math.sin(phi[k])
            dx, dy = FRAME - x, -y
            d2 = dx * dx + dy * dy
            along = 0.5 * (COUPLER * COUPLER - ROCKER * ROCKER + d2)
            across = math.sqrt(COUPLER * COUPLER * d2 - along * along)
            share = 1.0 / (COUPLER * d2)
            u, v = share * (along * dx - across * dy), share * (along * dy + across * dx)
            out[0, k] = x + ALONG * u - ACROSS * v
            out[1, k] = y + ALONG * v + ACROSS * u
        return out

    out = np.empty((2, phi.size))
    return lambda: loop(phi, out)


def _jax(phi):
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    compiled = jax.jit(lambda phi: tracer(jnp, phi))
    given = jnp.asarray(phi)
    return lambda: jax.block_until_ready(compiled(given))


def _casadi(phi):
    import casadi

    x = casadi.SX.sym("phi")
    function = casadi.Function("tracer", [x], list(tracer(casadi, x)))
    mapped = function.map(phi.size)
    given = casadi.DM(phi).T
    return lambda: mapped(given)


def import_time(rounds: int) -> float:
    """Milliseconds of `import linkage`, over those of a bare interpreter."""

    def run(program):
        begin = time.perf_counter()
        subprocess.run([sys.executable, "-c", program], check=True)
        return time.perf_counter() - begin

    pairs = [run("import linkage") - run("pass") for _ in range(rounds)]
    return 1e3 * statistics.median(pairs)


def two_workers(count: int) -> float:
    """The time of two Dask workers over that of one process, for a study of so many mechanisms."""
    sys.path.append(str(ROOT / "python" / "examples"))
    os.environ["PYTHONPATH"] = os.pathsep.join(path for path in sys.path if path)
    import cluster
    from dask.distributed import Client, LocalCluster

    m = linkage.parse(cluster.TEXT).assemble()

    def timed(work):
        begin = time.perf_counter()
        found = work()
        return time.perf_counter() - begin, found

    alone, whole = timed(lambda: cluster.study_part(m, 7, count, 0, 1))
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as local,
        Client(local) as client,
    ):
        cluster.tolerances(client, m, 7, 10_000, 2)
        two, parts = timed(lambda: cluster.tolerances(client, m, 7, count, 8))
    assert parts.to_bytes() == whole.to_bytes()
    print(f"{count:.0e} mechanisms: {alone:.1f} s by one process, {two:.1f} s by two workers")
    return two / alone


def macro_times(file: Path) -> dict[str, float]:
    """Nanoseconds for each of 1e6 positions, from the output of the benchmark of the engine."""
    lines = re.findall(r"^(K\d\w) .* macro at 1e6 ([\d.]+)", file.read_text(encoding="utf-8"), re.MULTILINE)
    return {name: float(number) for name, number in lines}


def sweeps(rounds: int) -> tuple[dict[str, dict[str, float]], dict[str, float]]:
    """Prints and returns the times of interpreter, machine code and rivals."""
    phi = np.linspace(0, 2 * np.pi, COUNT)
    bar = linkage.load(MECHANISMS, "K1")
    both = {"interpreter": bar.assemble(), "compiled": bar.compile().assemble()}
    print("ns for a position    " + "".join(f"{kernel:>10}" for kernel in KERNELS))
    times = {}
    for kind, m in both.items():
        times[kind] = {}
        for kernel, function in KERNELS.items():
            out = m[function](phi)
            times[kind][kernel] = median(lambda: m[function](phi, out=out), rounds)
        print(f"{kind:21}" + "".join(f"{number:10.2f}" for number in times[kind].values()))
    others = rivals(phi, both["compiled"].point(phi).tracer, rounds)
    for name, number in others.items():
        print(f"{name:21}{number:10.2f}")
    return times, others


def main():
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--macro", type=Path)
    parser.add_argument("--wheel", type=Path)
    parser.add_argument("--mechanisms", type=float)
    given = parser.parse_args()
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    linkage.set_threads(1)
    times, others = sweeps(given.rounds)
    limits = []
    if given.macro:
        macro = macro_times(given.macro)
        for kind, most, aim in (("interpreter", 12, 6), ("compiled", 1.3, 1.1)):
            for kernel, number in times[kind].items():
                limits.append(Limit(f"{kernel}, {kind} over the macro", most, aim, number / macro[kernel]))
    best = min(others, key=others.get)
    ratio = times["compiled"]["K1a"] / others[best]
    limits.append(Limit(f"K1a, compiled over {best}, the best rival", 0.5, 0.25, ratio))
    limits.append(Limit("import linkage, ms", 60, 30, import_time(given.rounds)))
    if given.wheel:
        limits.append(Limit("wheel, MB", 12, 6, given.wheel.stat().st_size / 1e6))
    if given.mechanisms:
        limits.append(Limit("two Dask workers over one process", 0.60, 0.53, two_workers(int(given.mechanisms))))
    print(f"\n{'':44}{'at most':>9}{'aim':>9}{'found':>9}")
    for name, most, aim, found in limits:
        print(f"{name:44}{most:9g}{aim:9g}{found:9.3g}{'' if found <= most else '  too much'}")


if __name__ == "__main__":
    main()
