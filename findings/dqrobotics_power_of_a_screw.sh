#!/usr/bin/env bash
# dqrobotics 26.4.0a7 (DQ Robotics): powers of a displacement, as for a motion along a screw.
#
# Behaviour: half of a displacement, `pow(x, 0.5)`, has half of its angle and half of its translation. Two such halves
# are not the whole. A lever that turns by 2 rad about a fixed pin at (2, 1) is 1.8 off after two halves, and the pin
# itself moves by up to 1.03 on the way. The errors are 0 if the pin is at the origin. `exp(log(x))` is `x` again.
#
# Guess before: the power follows the screw of the displacement, so `pow(x, 0.5) * pow(x, 0.5)` is `x`, as for unit
# quaternions.
#
# Source: the docstring of `pow` has "Returns `dq` raised to the power of `a`". The dual part of `log` is half of the
# translation itself, and not the moment of the screw.
#
# Seen:
#   pin at 2 1: two halves off by 1.804, pin moved by 0.000 0.766 1.028 0.766 0.000
#   pin at 0 0: two halves off by 0.000, pin moved by 0.000 0.000 0.000 0.000 0.000
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile dqrobotics==26.4.0a7 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import numpy as np
from dqrobotics import DQ, E_, exp, log, pow, translation, vec3

ANGLE = 2.0


def shift(point):
    return 1 + 0.5 * E_ * DQ([0, *point, 0])


for pin, error, largest in (((2, 1), 1.804, 1.028), ((0, 0), 0.0, 0.0)):
    turn = DQ([math.cos(ANGLE / 2), 0, 0, math.sin(ANGLE / 2)])
    whole = shift(pin) * turn * shift((-pin[0], -pin[1]))
    half = pow(whole, 0.5)
    off = np.linalg.norm(vec3(translation(half * half)) - vec3(translation(whole)))
    places = [vec3(translation(pow(whole, share) * shift(pin))) for share in (0, 0.25, 0.5, 0.75, 1)]
    moved = [np.linalg.norm(place - [*pin, 0]) for place in places]
    print(f"pin at {pin[0]} {pin[1]}: two halves off by {off:.3f}, pin moved by "
          + " ".join(f"{value:.3f}" for value in moved))
    assert abs(off - error) < 1e-3 and abs(max(moved) - largest) < 1e-3
    assert np.abs((exp(log(whole)) - whole).vec8()).max() < 1e-12
CHECK
"$folder/env/bin/python" "$folder/check.py"
