#!/usr/bin/env bash
# spatialmath-python 1.1.18: the logarithm of a turn in the plane that is larger than a quarter of a turn.
#
# Behaviour: `SO2.log`, `SE2.log` and `Twist2` take the angle of a turn modulo half a turn. A turn by 2 rad has the
# logarithm -1.142 rad, and a bar that a crank carries by 2 rad about (2, 1) comes back from its twist turned by -1.142
# rad about another point, so that a joint of it is 4.5 units away. Turns up to 1.57 rad are right, and so are turns of
# 2 rad in space (`SE3`, `Twist3`), the angle `theta()` and `interp` of the same poses. Nothing is printed.
#
# Guess before: the exponential of the logarithm is the pose, for each turn below half a turn.
#
# Source: the documentation of `trlog2` has the norm of the result as the amount of rotation. The function takes the
# arc tangent of the quotient of sine and cosine, in place of the two.
#
# Seen:
#   1.5 rad: log 1.5000, of the twist 1.5000, in space 1.5000, joint off by 0.00
#   1.6 rad: log -1.5416, of the twist -1.5416, in space 1.6000, joint off by 4.47
#   2.0 rad: log -1.1416, of the twist -1.1416, in space 2.0000, joint off by 4.47
#   3.0 rad: log -0.1416, of the twist -0.1416, in space 3.0000, joint off by 4.47
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile spatialmath-python==1.1.18 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import math

import numpy as np
from spatialmath import SE2, SE3, SO2, Twist2, Twist3

CENTRE, JOINT = (2.0, 1.0), (0.0, 0.0)

for angle in (1.5, 1.6, 2.0, 3.0):
    there, back = SE2(*CENTRE), SE2(*CENTRE).inv()
    carried = there * SE2(0, 0, angle) * back
    twist = Twist2(carried)
    returned = twist.SE2(1)
    logarithm = SO2(angle).log()[1, 0]
    in_space = Twist3(SE3.Rz(angle)).w[2]
    off = np.linalg.norm(returned * JOINT - carried * JOINT)
    print(f"{angle} rad: log {logarithm:.4f}, of the twist {twist.w:.4f}, in space {in_space:.4f}, "
          f"joint off by {off:.2f}")
    expected = angle if angle < math.pi / 2 else angle - math.pi
    assert abs(logarithm - expected) < 1e-9 and abs(twist.w - expected) < 1e-9 and abs(in_space - angle) < 1e-9
    assert abs(carried.theta() - angle) < 1e-9 and abs(SE2().interp(carried, 0.5).theta() - angle / 2) < 1e-9
    assert (off > 3.0) == (angle > math.pi / 2)
CHECK
"$folder/env/bin/python" "$folder/check.py"
