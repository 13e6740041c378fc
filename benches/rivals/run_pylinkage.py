"""Time to a given error by pylinkage, for the table and the picture of the benchmark beside it.

    python3 -m venv target/pylinkage
    target/pylinkage/bin/pip install -r benches/rivals/requirements.txt
    target/pylinkage/bin/python benches/rivals/run_pylinkage.py

The problem is that of `objective.rs`: five points with their angles, the same bounds, Grashof's condition as a penalty,
the error measured in the same way, from ten seeds, each beginning anew until the time is over, on one thread. Medians
are printed and written to `pylinkage.csv`, which `cargo bench` reads. With arguments, the limit in seconds and the
beginnings of methods' names, as in `run_pylinkage.py 5 swarm`, they are printed only.

Each method has the best form that was found for it: positions by pylinkage's own compiled step, the sum around it
compiled, too, and everything compiled before a clock runs; settings of the optimisers after trying others.
"""

import datetime
import importlib.metadata
import math
import os
import pathlib
import sys
import time

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"

import numpy as np
from numba import njit
from pylinkage.actuators import Crank
from pylinkage.bridge.solver_conversion import linkage_to_solver_data
from pylinkage.components import Ground
from pylinkage.dyads import FixedDyad, RRRDyad
from pylinkage.optimization import (
    differential_evolution_optimization,
    minimize_linkage,
    particle_swarm_optimization,
)
from pylinkage.simulation import Linkage
from pylinkage.solver import step_single

POINTS = np.array([(3.0, 3.0), (2.759, 3.363), (2.372, 3.663), (1.89, 3.862), (1.355, 3.943)])
ANGLES = np.radians([30.0, 45.0, 60.0, 75.0, 90.0])
# Frame, crank, coupler, rocker, and the point's place on the coupler, along it and across.
LOW = np.array([1e-3, 1e-3, 1e-3, 1e-3, -50.0, -50.0])
HIGH = np.full(6, 50.0)
BOUNDS = (LOW.tolist(), HIGH.tolist())
# As in `objective.rs`.
KNOWN = 7.41575130678e-7
PENALTY = 10.0
OPEN = 1e4

SEEDS = 10
# Errors of the table; those of the picture are eight for each power of ten, the largest first.
ERRORS = [1.0, 1e-1, 1e-2, 1e-4, 1e-8]
FINE = [10.0 ** (k / 8) for k in range(8 * 6, -8 * 8 - 1, -1)]


class FourBar(Linkage):
    """A four-bar whose dimensions are the six variables: those of pylinkage's own parts leave the frame out."""

    def __init__(self):
        base, end = Ground(0.0, 0.0), Ground(40.0, 0.0)
        crank = Crank(base, 15.0)
        rocker = RRRDyad(crank.output, end, 35.0, 30.0)
        super().__init__([base, end, crank, rocker, FixedDyad(crank.output, rocker, 22.0, 0.5)])

    def get_constraints(self):
        return [40.0, 15.0, 35.0, 30.0, 20.0, 10.0]


LINKAGE = FourBar()
DATA = linkage_to_solver_data(LINKAGE)
# Places in what pylinkage's step computes with.
END, PIN, JOINT, TRACER = 1, 2, 3, 4
RADIUS, COUPLER, ROCKER, ARM, BEND = 0, 2, 3, 4, 5


@njit
def cost(x, positions, constraints, types, parents, offsets, order):
    """The sum of squares with penalties, and the sum itself if there are none."""
    penalty = 0.0
    for j in range(6):
        outside = max(LOW[j] - x[j], 0.0) - max(x[j] - HIGH[j], 0.0)
        penalty += PENALTY * outside * outside
    for signs in ((1.0, 1.0, -1.0, -1.0), (-1.0, 1.0, 1.0, -1.0), (-1.0, 1.0, -1.0, 1.0)):
        over = max(signs[0] * x[0] + signs[1] * x[1] + signs[2] * x[2] + signs[3] * x[3], 0.0)
        penalty += PENALTY * over * over
    positions[END, 0] = x[0]
    constraints[RADIUS], constraints[COUPLER], constraints[ROCKER] = x[1], x[2], x[3]
    constraints[ARM], constraints[BEND] = math.hypot(x[4], x[5]), math.atan2(x[5], x[4])
    total = 0.0
    for k in range(len(ANGLES)):
        # The step turns the crank by nothing, and takes the joint that is nearest: that on the left of the line from the crank's pin to
        # the rocker's pivot, as in the other methods.
        across, along = x[1] * math.sin(ANGLES[k]), x[1] * math.cos(ANGLES[k])
        positions[PIN, 0], positions[PIN, 1] = along, across
        positions[JOINT, 0], positions[JOINT, 1] = along + 1e3 * across, across + 1e3 * (x[0] - along)
        step_single(positions, constraints, types, parents, offsets, order, 0.0)
        dx, dy = positions[TRACER, 0] - POINTS[k, 0], positions[TRACER, 1] - POINTS[k, 1]
        total += dx * dx + dy * dy
    if not math.isfinite(total):
        return OPEN + penalty, math.inf
    return total + penalty, total if penalty == 0.0 else math.inf


@njit
def costs(columns, positions, constraints, types, parents, offsets, order):
    """Those of all columns, and the least sum among them."""
    found, least = np.empty(columns.shape[1]), math.inf
    for i in range(columns.shape[1]):
        column = np.ascontiguousarray(columns[:, i])
        found[i], total = cost(column, positions, constraints, types, parents, offsets, order)
        least = min(least, total)
    return found, least


class Over(Exception):
    """The time is over."""


class Objective:
    """What pylinkage's optimisers call, with a clock."""

    def __init__(self, limit):
        copied = DATA.copy()
        self.data = (
            copied.positions,
            copied.constraints,
            copied.joint_types,
            copied.parent_indices,
            copied.constraint_offsets,
            copied.solve_order,
        )
        self.improvements = []
        self.least = math.inf
        self.limit = limit
        self.began = time.perf_counter()

    def __call__(self, linkage, x, positions):
        x = np.array(x)
        found, least = costs(x, *self.data) if x.ndim == 2 else cost(x, *self.data)
        elapsed = time.perf_counter() - self.began
        if least < self.least:
            self.least = least
            self.improvements.append((elapsed, least))
        if elapsed > self.limit:
            raise Over
        return found

    def time_to(self, error):
        reached = (at for at, least in self.improvements if least <= KNOWN * (1.0 + error))
        return next(reached, math.inf)


def swarm(objective, random):
    # It takes no seed: its numbers are others in every run. With its own settings it stays farther away.
    particle_swarm_optimization(
        objective, LINKAGE, dimensions=6, bounds=BOUNDS, order_relation=min, verbose=False,
        n_particles=60, inertia=0.7298, leader=1.496, follower=1.496, iterations=1000,
    )


def evolution(objective, random):
    # A population at a time: a call for each member takes twice as long.
    differential_evolution_optimization(
        objective, LINKAGE, bounds=BOUNDS, order_relation=min, verbose=False, seed=int(random.integers(2**31)),
        popsize=7, maxiter=2000, tol=1e-8, mutation=0.8, recombination=0.9, vectorized=True, updating="deferred",
    )


def descents(objective, random):
    # From random starts, spread as those of the other methods that descend are. SLSQP with its differences ends short of the optimum: what
    # is better than before goes on without them.
    lengths = np.exp(random.uniform(np.log(LOW[:4]), np.log(HIGH[:4])))
    start = np.concatenate([lengths, random.uniform(LOW[4:], HIGH[4:])])
    before = objective.least
    found = descend(objective, start, "SLSQP", 1e-20)
    if objective.least < before:
        descend(objective, found[0].dimensions, "Nelder-Mead", 1e-14)


def descend(objective, start, method, tolerance):
    return minimize_linkage(
        objective, LINKAGE, x0=start.tolist(), bounds=BOUNDS, order_relation=min, verbose=False,
        method=method, tol=tolerance, maxiter=2000,
    )


METHODS = {
    "pylinkage, differential evolution": evolution,
    "pylinkage, SLSQP and Nelder-Mead": descents,
    "pylinkage, particle swarm": swarm,
}


def run(method, seed, limit):
    random = np.random.default_rng(seed)
    objective = Objective(limit)
    try:
        while True:
            method(objective, random)
    except Over:
        return objective


def median(objectives, error):
    """The median time to an error, and how many came there."""
    times = sorted(objective.time_to(error) for objective in objectives)
    return times[len(times) // 2], sum(math.isfinite(at) for at in times)


def main():
    limit = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0
    wanted = sys.argv[2:] or [""]
    versions = [f"{name} {importlib.metadata.version(name)}" for name in ("pylinkage", "numba", "numpy", "scipy")]
    about = f"{versions[0]} ({', '.join(versions[1:])}), measured on {datetime.date.today()}"
    print(f"median time in ms to an error; in parentheses how many of {SEEDS} seeds came there within {limit:g} s; {about}")
    print(f"{'method':<48}" + "".join(f"{error:>18.0e}" for error in ERRORS) + f"{'least, median':>18}")
    rows = [f"# {about}", "method;error;seconds;reached"]
    for name, method in METHODS.items():
        if not any(name.removeprefix("pylinkage, ").startswith(part) for part in wanted):
            continue
        # What is compiled on first use is compiled before a clock runs.
        run(method, SEEDS, 0.1)
        found = [run(method, seed, limit) for seed in range(SEEDS)]
        line = f"{name:<48}"
        for error in ERRORS:
            at, reached = median(found, error)
            line += f"{f'{1e3 * at:.2f} ({reached})' if math.isfinite(at) else f'- ({reached})':>18}"
        least = sorted(objective.least for objective in found)[SEEDS // 2]
        print(f"{line}{least / KNOWN - 1.0:>18.2g}", flush=True)
        for error in FINE:
            at, reached = median(found, error)
            rows.append(f"{name};{error:.6g};{at:.6g};{reached}")
    if len(sys.argv) == 1:
        (pathlib.Path(__file__).parent / "pylinkage.csv").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
