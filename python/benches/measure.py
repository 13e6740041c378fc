"""Measures the package: `python measure.py [--macro FILE]` prints a table of medians.

Positions of a four-bar, 1e6 of them on one thread: its tracer point (K1a), the point with both
derivatives (K1b), and the rocker with its sensitivities (K1c). Rivals are NumPy with closed forms,
Numba, JAX and CasADi, each if it is installed. Results go into arrays that exist, where a rival can
do that. `--macro` is a file with the macro's times in nanoseconds: a name and a number in each line.
"""

import argparse
import importlib.util
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

import linkage
import numpy as np

TEXT = """
pub struct FourBar {
    unit mm;
    param crank = 50mm +- 12um;
    param coupler = 120mm +- 20um;
    param rocker = 100mm +- 20um;
    param frame = 140mm +- 20um;
    param arm = 70mm +- 15um;
    input phi = 30deg in 0deg..360deg;
    unknown theta = 40deg;
    unknown psi = 80deg;
    let tracer = polar(crank, phi) + polar(arm, theta);
    loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
}
impl FourBar {
    pub fn path(phi) -> Path { tracer }
    pub fn motion(phi) -> Motion { tracer, v: velocity(tracer), a: acceleration(tracer) }
    pub fn accuracy(phi) -> Accuracy { tracer, e: sensitivity(tracer) }
}
"""

KERNELS = {"K1a": "path", "K1b": "motion", "K1c": "accuracy"}

COUNT = 1_000_000


def median(work, rounds: int) -> float:
    """Nanoseconds for each position: the median of the processor's time, that of all threads."""
    work()
    times = []
    for _ in range(rounds):
        begin = time.process_time()
        work()
        times.append(time.process_time() - begin)
    return 1e9 * statistics.median(times) / COUNT


def tracer(np, phi, crank=50.0, coupler=120.0, rocker=100.0, frame=140.0, arm=70.0):
    """The tracer point by a closed form without angles, for any module with NumPy's functions."""
    x, y = crank * np.cos(phi), crank * np.sin(phi)
    dx, dy = frame - x, 0.0 - y
    d2 = dx * dx + dy * dy
    along = 0.5 * (coupler * coupler - rocker * rocker + d2)
    across = np.sqrt(coupler * coupler * d2 - along * along)
    share = arm / (coupler * d2)
    return x + share * (along * dx - across * dy), y + share * (along * dy + across * dx)


def rivals(phi, rounds: int) -> dict[str, float]:
    """Times of the tracer point."""
    found = {"NumPy": median(lambda: tracer(np, phi), rounds)}
    if importlib.util.find_spec("numba"):
        found["Numba"] = median(_numba(phi), rounds)
    if importlib.util.find_spec("jax"):
        found["JAX"] = median(_jax(phi), rounds)
    if importlib.util.find_spec("casadi"):
        found["CasADi map"] = median(_casadi(phi), rounds)
    return found


def _numba(phi):
    import math

    import numba

    @numba.njit(fastmath=True, error_model="numpy")
    def loop(phi, out):
        for k in range(phi.size):
            x, y = 50.0 * math.cos(phi[k]), 50.0 * math.sin(phi[k])
            dx, dy = 140.0 - x, -y
            d2 = dx * dx + dy * dy
            along = 0.5 * (120.0 * 120.0 - 100.0 * 100.0 + d2)
            across = math.sqrt(120.0 * 120.0 * d2 - along * along)
            share = 70.0 / (120.0 * d2)
            out[0, k] = x + share * (along * dx - across * dy)
            out[1, k] = y + share * (along * dy + across * dx)

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


def main():
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--macro", type=Path)
    given = parser.parse_args()
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    linkage.set_threads(1)
    phi = np.linspace(0, 2 * np.pi, COUNT)
    bar = linkage.parse(TEXT)
    both = {"interpreter": bar.assemble(), "compiled": bar.compile().assemble()}
    macro = {}
    if given.macro:
        lines = given.macro.read_text(encoding="utf-8").splitlines()
        macro = {name: float(number) for name, number in map(str.split, lines)}
    print("ns for a position    " + "".join(f"{kernel:>10}" for kernel in KERNELS))
    times = {}
    for kind, m in both.items():
        row = []
        for function in KERNELS.values():
            out = m[function](phi)
            row.append(median(lambda: m[function](phi, out=out), given.rounds))
        times[kind] = row
        print(f"{kind:21}" + "".join(f"{number:10.2f}" for number in row))
        if macro:
            ratios = [number / macro[kernel] for number, kernel in zip(row, KERNELS)]
            print(f"{'  over the macro':21}" + "".join(f"{ratio:10.2f}" for ratio in ratios))
    found = rivals(phi, given.rounds)
    for name, number in found.items():
        print(f"{name:21}{number:10.2f}")
    print(f"compiled over the best rival: {times['compiled'][0] / min(found.values()):.2f}")
    print(f"import linkage: {import_time(given.rounds):.0f} ms")


if __name__ == "__main__":
    main()
