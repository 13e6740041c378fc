#!/usr/bin/env bash
# spatialmath-python 1.1.18, `Line3.intersects`: the instant centre of a coupler, where the lines of both cranks meet.
#
# Behaviour: `intersects` returns a matrix of 3 by 3 in place of a point, for each pair of lines in the plane z = 0 that
# is tried. If the same bars are 10 mm above that plane, it returns None, as for lines that do not meet, since its test
# depends on the length of the bars. `closest_to_line` has the right point in both planes, at a distance of 0.
#
# Guess before: the point (-80, 60, 0), in the plane z = 10 with this height.
#
# Source: the documentation of `intersects` has a 3D intersection point or None. The expression multiplies a matrix and
# a vector with `*`, which numpy does by elements. The product of the lines, by which they are tested, has the direction
# of one line as a unit vector, and the moment of the other one with the length of its bar.
#
# Seen:
#   z = 0: intersects has the shape (3, 3), closest_to_line (-80.0, 60.0, 0.0) at 0.0
#   z = 10: intersects is None, closest_to_line (-80.0, 60.0, 10.0) at 0.0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile spatialmath-python==1.1.18 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from spatialmath import Line3

CRANK, ROCKER = ((0, 0), (-40, 30)), ((100, 0), (10, 30))
CENTRE = (-80, 60)

for height in (0, 10):
    lines = [Line3.Join([*first, height], [*second, height]) for first, second in (CRANK, ROCKER)]
    met = lines[0].intersects(lines[1])
    nearest, distance = lines[0].closest_to_line(lines[1])
    shown = "is None" if met is None else f"has the shape {np.shape(met)}"
    place = ", ".join(f"{value + 0.0:.1f}" for value in np.round(nearest, 6))
    print(f"z = {height}: intersects {shown}, closest_to_line ({place}) at {abs(float(distance)):.1f}")
    assert np.allclose(nearest, [*CENTRE, height], atol=1e-6) and abs(distance) < 1e-6
    assert met is None if height else np.shape(met) == (3, 3)
CHECK
"$folder/env/bin/python" "$folder/check.py"
