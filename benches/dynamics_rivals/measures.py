"""Times and errors of a method over its settings."""

import json
import math
import platform
import sys
import time
from importlib.metadata import version

# Runs of a setting are repeated for so many seconds of the processor; the shortest one counts. Times are those of the
# calling thread, so that other programs of the machine do not matter.
SECONDS = 0.3
# Settings that take longer than this, in seconds, end a sweep.
LONGEST = 4.0


def timed(run):
    """The result of a run, and the shortest time of several."""
    begin = time.thread_time()
    result, best = None, math.inf
    while time.thread_time() - begin < SECONDS:
        start = time.thread_time()
        result = run()
        best = min(best, time.thread_time() - start)
        if best > SECONDS:
            break
    return result, best


def sweep(problem, method, settings, prepare):
    """Rows of a method: `prepare(setting)` returns a function that runs it and returns the first coordinate."""
    rows = []
    for setting in settings:
        try:
            result, seconds = timed(prepare(setting))
        except Exception as error:  # Solvers raise what they like where a step is too long.
            print(f"{problem.name}, {method}, {setting}: {type(error).__name__}", file=sys.stderr)
            continue
        error = abs(result - problem.solution)
        print(f"{problem.name}, {method}, {setting}: {error:.2e} {seconds:.2e} s", file=sys.stderr)
        if math.isfinite(error):
            rows.append({"problem": problem.name, "method": method, "setting": str(setting), "error": error,
                         "seconds": seconds})
        if seconds > LONGEST:
            break
    return rows


def is_best(row, rows):
    """No other row of the method is faster and more accurate."""
    same = [other for other in rows if (other["problem"], other["method"]) == (row["problem"], row["method"])]
    return not any(other["error"] <= row["error"] and other["seconds"] < row["seconds"] for other in same)


def report(rows, *packages):
    """Prints the best rows and versions as a line of JSON."""
    versions = {package: version(package) for package in packages}
    best = [row for row in rows if is_best(row, rows)]
    print(json.dumps({"python": platform.python_version(), "versions": versions, "rows": best}))
