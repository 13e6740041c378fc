#!/usr/bin/env bash
# interval-py 1.0.5 (module intervalpy): the absolute value of an interval, as the distance of a lever from its
# middle.
#
# Behaviour: the absolute value of the interval from -3 to 2 mm is 2 to 3 mm, so the lever never comes nearer than 2
# mm to a contact that it passes. That of -1 to 2 mm is 1 to 2 mm. The square of the same interval begins with 0, and
# is right, as are intervals on one side of 0. Nothing is raised.
#
# Guess before: 0 to 3 mm.
#
# Source: `__abs__` in intervalpy/interval.py orders the lengths of both ends if the interval contains 0. The page of
# the package has it as "Interval arithmetic library", and an enclosure of |x| contains 0 wherever x does.
#
# Seen:
#   -3 to 2: absolute value [2.0, 3.0], square [0, 9.0]
#   -1 to 2: absolute value [1.0, 2.0], square [0, 4.0]
#   1 to 2: absolute value [1.0, 2.0], square [1.0, 4.0]
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile interval-py==1.0.5 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
from intervalpy import Interval

for low, high, expected in ((-3.0, 2.0, (2, 3)), (-1.0, 2.0, (1, 2)), (1.0, 2.0, (1, 2))):
    lever = Interval([low, high])
    distance, square = abs(lever), lever**2
    print(f"{low:.0f} to {high:.0f}: absolute value {distance}, square {square}")
    assert (distance[0], distance[1]) == expected
    assert square[0] == (0 if low < 0 else low**2)
CHECK
"$folder/env/bin/python" "$folder/check.py"
