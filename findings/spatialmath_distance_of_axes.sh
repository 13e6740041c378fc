#!/usr/bin/env bash
# spatialmath-python 1.1.18, `Line3.distance`: the distance of the axes of two joints, as for a table of link lengths.
#
# Behaviour: the distance of skew axes depends on the length of the vectors that give their directions. Two axes at a
# distance of 70 mm have 70 for vectors of 1 mm, 7 or 0.7 if one of them is 10 mm long, and 0.07 if both are. For
# parallel axes, as in each planar mechanism, it raises NameError. `closest_to_line` has the right distance of the skew
# axes in all cases.
#
# Guess before: 70 mm, since a line has no length, for skew axes and for parallel ones.
#
# Source: the documentation of `distance` has the minimum distance between two lines, and states that it works for
# parallel, skew and intersecting lines. The product of the lines is divided by the square of a cross product of both
# vectors, and grows itself with one of them only.
#
# Seen:
#   vectors of 1 and 1 mm: distance 70.00, closest_to_line 70.00
#   vectors of 1 and 10 mm: distance 7.00, closest_to_line 70.00
#   vectors of 10 and 1 mm: distance 0.70, closest_to_line 70.00
#   vectors of 10 and 10 mm: distance 0.07, closest_to_line 70.00
#   parallel: NameError
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile spatialmath-python==1.1.18 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
from spatialmath import Line3

GAP = 70.0

for along_x, along_y in ((1, 1), (1, 10), (10, 1), (10, 10)):
    first, second = Line3.Join([0, 0, 0], [along_x, 0, 0]), Line3.Join([0, 0, GAP], [0, along_y, GAP])
    found, right = first.distance(second), first.closest_to_line(second)[1]
    print(f"vectors of {along_x} and {along_y} mm: distance {found:.2f}, closest_to_line {float(right):.2f}")
    assert abs(found - GAP / (along_x ** 2 * along_y)) < 1e-6 and abs(right - GAP) < 1e-6
try:
    Line3.Join([0, 0, 0], [0, 0, 1]).distance(Line3.Join([GAP, 0, 0], [GAP, 0, 1]))
    raise SystemExit("parallel axes have a distance now")
except NameError:
    print("parallel: NameError")
CHECK
"$folder/env/bin/python" "$folder/check.py"
