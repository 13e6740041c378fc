#!/usr/bin/env bash
# spatialmath-python 1.1.18, `Ellipse`: the ellipse of the velocities of an arm, its radii and its direction.
#
# Behaviour: `theta` is the direction of the short axis, while `radii` has the long one first or second, by its
# direction. An ellipse with the radii 3 and 1 that points to 22.9 degrees has the radii 3 and 1 and the direction -67.1
# degrees; made again from these, it points to 112.9 degrees. With the direction 68.8 degrees the radii come back as 1
# and 3, and make the same ellipse again. The points of all of them are right.
#
# Guess before: an ellipse that is made from the radii and the direction of another one is that one.
#
# Source: the documentation of `theta` has the orientation of the ellipse, and shows it for the radii 1 and 2. A comment
# in its source has the major axis in the second column; the columns are those of the matrix of the ellipse, in which
# the larger number belongs to the shorter axis.
#
# Seen:
#   radii 3 1, theta 22.9: radii 3 1, theta -67.1, farthest point at 22.9, of the copy at 112.9 degrees
#   radii 3 1, theta 68.8: radii 1 3, theta -21.2, farthest point at 68.8, of the copy at 68.8 degrees
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile spatialmath-python==1.1.18 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from spatialmath import Ellipse


def farthest(ellipse):
    """Direction of the long axis in degrees from 0 to 180, by the points of the ellipse."""
    points = ellipse.points(3600)
    x, y = points[:, np.argmax(np.linalg.norm(points, axis=0))]
    return np.degrees(np.arctan2(y, x)) % 180


for theta, same in ((0.4, False), (1.2, True)):
    ellipse = Ellipse(radii=(3, 1), theta=theta)
    copy = Ellipse(radii=ellipse.radii, theta=ellipse.theta)
    radii = " ".join(f"{value:.0f}" for value in ellipse.radii)
    print(f"radii 3 1, theta {np.degrees(theta):.1f}: radii {radii}, theta {np.degrees(ellipse.theta):.1f}, "
          f"farthest point at {farthest(ellipse):.1f}, of the copy at {farthest(copy):.1f} degrees")
    assert abs(farthest(ellipse) - np.degrees(theta)) < 0.2
    assert abs((np.degrees(ellipse.theta) - np.degrees(theta)) % 180 - 90) < 0.01
    assert (abs(farthest(copy) - farthest(ellipse)) < 0.2) == same
CHECK
"$folder/env/bin/python" "$folder/check.py"
