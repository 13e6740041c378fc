"""Beyond one machine with Ray: parts of a study by random sampling, united exactly.

`python with_ray.py` draws 1e7 mechanisms on this machine, or on the cluster that Ray is connected to.
"""

from pathlib import Path

import linkage
import ray

#: The four-bar.
FILE = Path(__file__).with_name("tracer.mech")

#: The position of the crank.
PHI = 1.2

#: Parts of the study. Results do not depend on their number.
PARTS = 32


def study_part(m, seed: int, count: int, part: int, of: int):
    """The coordinates of a part of the mechanisms within their tolerances."""
    linkage.set_threads(1)
    return m.monte_carlo("path", PHI, count=count, seed=seed, distribution="uniform", part=(part, of))


def study(count: int, parts: int = PARTS, seed: int = 7):
    """The study of all mechanisms, from tasks of its parts."""
    m = ray.put(linkage.load(FILE).assemble())
    task = ray.remote(study_part)
    first, *others = ray.get([task.remote(m, seed, count, part, parts) for part in range(parts)])
    return first.merge(*others)


def main(count: int = 10_000_000):
    """Prints the figures of the coordinates."""
    print(study(count))


if __name__ == "__main__":
    main()
