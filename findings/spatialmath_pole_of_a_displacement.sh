#!/usr/bin/env bash
# spatialmath-python 1.1.18: the pole of a displacement, the point about which a body turns from one pose to another.
#
# Behaviour: `Twist2.pole` and `Twist3.pole` are multiplied by the angle of the turn. A coupler that is turned about
# (2, 1) by 0.3 rad has the pole (0.6, 0.3), and by 1 rad (2, 1). The error is one of the angle alone, so all poles of
# a motion lie on the right lines from the origin. `Twist3.pitch` and the line of `Twist3.line` are right.
#
# Guess before: the pole of a twist is the point that its displacement leaves where it is.
#
# Source: the documentation of `pole` calls it a point on the twist axis, and shows it for the twist of a pose that is
# turned by 0.3 rad. The product of the vectors is divided by the angle, in place of its square.
#
# Seen:
#   0.3 rad: pole 0.600 0.300, in space 0.600 0.300, on the line 2.000 1.000, moved by 0.468
#   1.0 rad: pole 2.000 1.000, in space 2.000 1.000, on the line 2.000 1.000, moved by 0.000
#   1.5 rad: pole 3.000 1.500, in space 3.000 1.500, on the line 2.000 1.000, moved by 1.524
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile spatialmath-python==1.1.18 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from spatialmath import SE2, SE3, Twist2, Twist3

CENTRE = np.array([2.0, 1.0])

for angle in (0.3, 1.0, 1.5):
    moved = SE2(*CENTRE) * SE2(0, 0, angle) * SE2(*CENTRE).inv()
    at = SE3.Trans(*CENTRE, 0)
    twist = Twist3(at * SE3.Rz(angle) * at.inv())
    pole, in_space, on_line = Twist2(moved).pole, twist.pole, twist.line().closest_to_point([0, 0, 0])[0]
    shift = np.linalg.norm((moved * pole).ravel() - pole)
    print(f"{angle} rad: pole {pole[0]:.3f} {pole[1]:.3f}, in space {in_space[0]:.3f} {in_space[1]:.3f}, "
          f"on the line {on_line[0]:.3f} {on_line[1]:.3f}, moved by {shift:.3f}")
    assert np.allclose(moved * CENTRE, CENTRE[:, None]) and np.allclose(on_line[:2], CENTRE)
    assert np.allclose(pole, angle * CENTRE) and np.allclose(in_space[:2], angle * CENTRE)
CHECK
"$folder/env/bin/python" "$folder/check.py"
