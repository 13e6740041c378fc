#!/usr/bin/env bash
# codac 2.1.2 (interval arithmetic and contractors).
#
# Behaviour: `import codac` sets the rounding of the whole process to "upwards" and leaves it so. Python then reads
# decimals wrongly: `float("0.3")` and `json.loads("0.3")` are one unit in the last place above 0.3, and
# `float(repr(x))` is not `x`. The enclosures rely on that mode: a thread
# that was started before the import rounds to nearest, and its interval for 1/3 does not contain 1/3.
#
# Guess before: an import changes no arithmetic outside of the package, and an enclosure contains its number in every
# thread.
#
# Source: measured. No documentation string of the module and its classes mentions the rounding mode.
#
# Seen with Python 3.11.7 on x86-64 Linux:
#   before: float('0.3') == 0.3: True
#   after: float('0.3'): 0.30000000000000004
#   after: json.loads('0.3'): 0.30000000000000004
#   after: float(repr(x)) == x: False
#   main thread: 1/3 is within its interval: True
#   older thread: 1/3 is within its interval: False
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet codac==2.1.2
cat >"$folder/check.py" <<'CHECK'
import json
import queue
import threading
from fractions import Fraction

work, results = queue.Queue(), queue.Queue()


def serve():
    for task in iter(work.get, None):
        results.put(task())


older = threading.Thread(target=serve)
older.start()
before = float("0.3") == 0.3

import codac


def contains_third():
    third = codac.Interval(1) / codac.Interval(3)
    return Fraction(third.lb()) <= Fraction(1, 3) <= Fraction(third.ub())


work.put(contains_third)
work.put(None)
x = 0.3
seen = {
    "before: float('0.3') == 0.3": before,
    "after: float('0.3')": float("0.3"),
    "after: json.loads('0.3')": json.loads("0.3"),
    "after: float(repr(x)) == x": float(repr(x)) == x,
    "main thread: 1/3 is within its interval": contains_third(),
    "older thread: 1/3 is within its interval": results.get(),
}
older.join()
for name, value in seen.items():
    print(f"{name}: {value!r}")
assert list(seen.values()) == [True, 0.30000000000000004, 0.30000000000000004, False, True, False]
CHECK
"$folder/env/bin/python" "$folder/check.py"
