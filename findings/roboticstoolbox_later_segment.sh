#!/usr/bin/env bash
# roboticstoolbox-python 1.5.0: a motion from rest to rest whose time runs from 1 s to 3 s, as the second part of a
# cycle.
#
# Behaviour: `jtraj` begins at 21 % of the stroke with a speed of 0.49 of the stroke per second, where the joint has to
# rest at the start: it divides the time by its last value, and takes the first one for zero. The end is right. For the
# same times `quintic`, `trapezoidal` and `mtraj` begin at rest at the start.
#
# A fair guess: each function of a vector of times moves from the first time to the last one.
#
# Source: the documentation of `jtraj` has q0 and qf as the initial and the final coordinate. A note states that the
# scale of velocity and acceleration assumes times that begin at zero. Positions are not in it.
#
# Seen:
#   jtraj: from 0.210 to 1.000, speed at the start 0.494, largest 0.625
#   quintic: from 0.000 to 1.000, speed at the start 0.000, largest 0.937
#   trapezoidal: from 0.000 to 1.000, speed at the start 0.000, largest 0.750
#   mtraj: from 0.000 to 1.000, speed at the start 0.000, largest 0.937
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet roboticstoolbox-python==1.5.0 spatialmath-python==1.1.18 numpy==2.4.6 \
    scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from roboticstoolbox import jtraj, mtraj, quintic, trapezoidal

TIMES = np.linspace(1, 3, 201)
motions = {"jtraj": jtraj([0.0], [1.0], TIMES), "quintic": quintic(0, 1, TIMES),
           "trapezoidal": trapezoidal(0, 1, TIMES), "mtraj": mtraj(quintic, [0.0], [1.0], TIMES)}
for name, motion in motions.items():
    position, speed = np.ravel(motion.q), np.ravel(motion.qd)
    print(f"{name}: from {position[0]:.3f} to {position[-1]:.3f}, speed at the start {speed[0]:.3f}, "
          f"largest {np.abs(speed).max():.3f}")
    # The motion of `jtraj` begins where a third of its time is over.
    part = 1 / 3 if name == "jtraj" else 0.0
    assert abs(position[0] - (10 * part**3 - 15 * part**4 + 6 * part**5)) < 1e-9
    assert abs(position[-1] - 1) < 1e-9
    assert abs(speed[0] - (30 * part**2 - 60 * part**3 + 30 * part**4) / 3) < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py"
