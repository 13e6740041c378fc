"""The number of threads of sweeps."""

from __future__ import annotations

import os

_chosen: int | None = None


def threads() -> int:
    """Returns the number of threads that a sweep uses at most.

    It is the number of `set_threads`, else that of the variable `LINKAGE_THREADS` of the
    environment, else the number of cores that this process may use.
    """
    if _chosen is not None:
        return _chosen
    named = os.environ.get("LINKAGE_THREADS", "")
    if named.isdecimal() and int(named) > 0:
        return int(named)
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def set_threads(count: int | None) -> None:
    """Sets the number of threads of sweeps; `None` returns to the default.

    Results do not depend on it. Workers of a cluster that share a machine should have 1.

    Raises
    ------
    ValueError
        For a number below 1.
    """
    global _chosen
    if count is not None and (isinstance(count, bool) or int(count) != count or count < 1):
        raise ValueError(f"{count!r} threads: a sweep needs a whole number of at least 1")
    _chosen = None if count is None else int(count)
