#!/usr/bin/env bash
# fastdual 0.3.1: the derivative of an angle that is reduced to one turn, by `%` or `numpy.mod`.
#
# Behaviour: the angle of a crank, 1.5 t modulo a turn, has the derivative 0 with respect to t, by `%` as by
# `numpy.mod`. Its value is right. The same angle by `arctan2` of its sine and cosine has 1.5, and so has the angle
# minus turns by `numpy.floor`. A Newton iteration for a target angle divides by this 0. `HyperDual`, for second
# derivatives, raises TypeError for the same line.
#
# Guess before: 1.5, the derivative of the remainder wherever it is defined, or an error.
#
# Source: the README has "Any function that works with floats works with `Dual`", and "exact derivative" for an
# example. The remainder by a constant differs from its argument by a constant between two turns.
#
# Seen, at t = 5:
#   %: value 1.2168, derivative 0.0
#   numpy.mod: value 1.2168, derivative 0.0
#   numpy.floor: value 1.2168, derivative 1.5
#   numpy.arctan2: value 1.2168, derivative 1.5
#   second derivative by %: TypeError
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile fastdual==0.3.1 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import numpy as np
from fastdual import Dual, autohess, der

TURN, SPEED, TIME = 2 * math.pi, 1.5, 5.0
WAYS = {"%": lambda angle: angle % TURN, "numpy.mod": lambda angle: np.mod(angle, TURN),
        "numpy.floor": lambda angle: angle - TURN * np.floor(angle / TURN),
        "numpy.arctan2": lambda angle: np.arctan2(np.sin(angle), np.cos(angle))}

for name, reduce in WAYS.items():
    time = Dual(TIME)
    angle = reduce(SPEED * time)
    rate = der(angle, time)
    print(f"{name}: value {angle.val:.4f}, derivative {rate:.1f}")
    assert abs(angle.val - SPEED * TIME % TURN) < 1e-12
    assert abs(rate - (0 if name in ("%", "numpy.mod") else SPEED)) < 1e-12
try:
    autohess(lambda time: SPEED * time % TURN)(TIME)
    raise AssertionError("a second derivative")
except TypeError:
    print("second derivative by %: TypeError")
CHECK
"$folder/env/bin/python" "$folder/check.py"
