"""Beyond one machine: Dask computes mechanisms within their tolerances, and a search for designs.

    python cluster.py                              # 1e8 mechanisms and 1e7 designs on this machine
    python cluster.py --count 1e6 --designs 1e5    # in small
    python cluster.py --scheduler tcp://head:8786  # on a cluster whose workers have the package

Mechanism and design number `k` have the random numbers of counter `k`, whoever computes them. Parts
of a study are united exactly, in any order. So the results are equal to the last bit for every
number of workers and partitions, and after a worker was lost. Rust draws the same mechanisms.
"""

import argparse
from pathlib import Path

import linkage
import numpy as np
from dask.distributed import Client, LocalCluster, as_completed

#: The four-bar.
FILE = Path(__file__).with_name("tracer.mech")

#: Designs of a block, the smallest part of the search.
BLOCK = 100_000

#: The position of the crank.
PHI = 1.2


def uniform(seed: int, first: int, count: int, columns: int) -> np.ndarray:
    """Numbers from 0 to 1 of the mechanisms `first` to `first + count`: a row for each.

    Philox makes 4 numbers from a counter; a mechanism has as many counters as its columns need.
    """
    counters = -(-columns // 4)
    generator = np.random.Generator(np.random.Philox(key=seed, counter=first * counters))
    return generator.random((count, 4 * counters))[:, :columns]


def study_part(m, seed: int, count: int, part: int, of: int):
    """The coordinates of a part of the mechanisms within their tolerances."""
    linkage.set_threads(1)
    return m.monte_carlo("path", PHI, count=count, seed=seed, distribution="uniform", part=(part, of))


def design_blocks(m, seed: int, first: int, last: int, wanted: np.ndarray) -> list[tuple]:
    """The best design of each block: the cost, its number, its dimensions."""
    linkage.set_threads(1)
    low, high = np.array([30.0, 90.0, 80.0, 120.0]), np.array([60.0, 150.0, 130.0, 160.0])
    phi = np.linspace(0.3, 2.0, len(wanted))[:, None]
    found = []
    for start in range(first, last, BLOCK):
        count = min(BLOCK, last - start)
        sets = low + (high - low) * uniform(seed, start, count, 4)
        off = m.path(phi, **dict(zip(m.mechanism.parameters, sets.T))).tracer - wanted[:, None]
        cost = (off * off).sum(axis=(0, 2))
        cost[np.isnan(cost)] = np.inf
        best = int(np.argmin(cost))
        found.append((start, float(cost[best]), start + best, tuple(map(float, sets[best]))))
    return found


def gathered(client, tasks: list, show: bool) -> list:
    """The results of all tasks in their order; shows how many are done."""
    for done, _ in enumerate(as_completed(tasks), 1):
        if show:
            print(f"\r{done} of {len(tasks)} parts", end="", flush=True)
    if show:
        print()
    return client.gather(tasks)


def tolerances(client, m, seed: int, count: int, partitions: int, show: bool = False):
    """The study of all mechanisms, from tasks of its parts."""
    tasks = [
        client.submit(study_part, m, seed, count, part, partitions, pure=False, retries=5)
        for part in range(partitions)
    ]
    first, *others = gathered(client, tasks, show)
    return first.merge(*others)


def designs(client, m, seed: int, count: int, partitions: int, wanted, show: bool = False) -> list:
    """The best design of each block, from tasks of whole blocks."""
    blocks = -(-count // BLOCK)
    ends = [min(count, BLOCK * (blocks * k // partitions)) for k in range(partitions + 1)]
    ends[-1] = count
    tasks = [
        client.submit(design_blocks, m, seed, first, last, wanted, pure=False, retries=5)
        for first, last in zip(ends, ends[1:])
        if last > first
    ]
    return sorted(block for part in gathered(client, tasks, show) for block in part)


def main(arguments=None):
    """Runs both and prints their figures."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--count", type=float, default=1e8, help="mechanisms within their tolerances")
    parser.add_argument("--designs", type=float, default=1e7)
    parser.add_argument("--workers", type=int, default=None)
    parser.add_argument("--partitions", type=int, default=None)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--scheduler", help="the address of a cluster, else one on this machine")
    given = parser.parse_args(arguments)
    m = linkage.load(FILE).assemble()
    wanted = m.path(np.linspace(0.3, 2.0, 6), crank=np.full(6, 48.0)).tracer
    cluster = given.scheduler or LocalCluster(
        n_workers=given.workers, threads_per_worker=1, dashboard_address=None
    )
    with Client(cluster) as client:
        workers = len(client.scheduler_info()["workers"])
        partitions = given.partitions or 16 * workers
        print(tolerances(client, m, given.seed, int(given.count), partitions, show=True))
        best = designs(client, m, given.seed, int(given.designs), partitions, wanted, show=True)
        _, cost, number, dimensions = min(best, key=lambda block: (block[1], block[2]))
        print(f"design {number}: {dimensions}, sum of squares {cost:.6g} mm^2")
    if not given.scheduler:
        cluster.close()


if __name__ == "__main__":
    main()
