#!/usr/bin/env bash
# toppra 0.6.10, fastest motion along a path: a slide that moves by 1 m with at most 1 m/s and 2 m/s2.
#
# Behaviour: with default settings the acceleration of the returned motion is 13 % above its limit, and a finer grid
# does not help: the peak is 2.263 m/s2 with 100 and 2.267 m/s2 with 2000 intervals. The motion is a cubic spline
# through the points of the grid, which swings where the exact acceleration jumps. With
# `parametrizer="ParametrizeConstAccel"` the limit is held to 1e-6. The duration of 1.5 s is right in both cases.
#
# A fair guess: limits are exceeded by an error of the grid, if at all, which goes to zero with the size of its steps.
#
# Source: the documentation of the constraint has the limits as bounds of the joint's acceleration. Issue 150 of the
# project names the spline as the reason, and the other setting as the remedy. The default has stayed.
#
# Seen:
#   default, 100 intervals: 1.5000 s, peak 2.263 m/s2
#   default, 500 intervals: 1.5000 s, peak 2.265 m/s2
#   default, 2000 intervals: 1.5000 s, peak 2.267 m/s2
#   constant acceleration, 100 intervals: 1.5000 s, peak 2.000 m/s2
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet toppra==0.6.10 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import numpy as np
import toppra
from toppra import SplineInterpolator
from toppra.algorithm import TOPPRA
from toppra.constraint import JointAccelerationConstraint, JointVelocityConstraint

toppra.setup_logging("ERROR")
SPEED, ACCELERATION = 1.0, 2.0
EXACT = 1 / SPEED + SPEED / ACCELERATION


def move(intervals, **settings):
    """The duration in s of the motion and its largest acceleration in m/s2."""
    path = SplineInterpolator([0, 1], np.array([[0.0], [1.0]]))
    limits = [JointVelocityConstraint(np.array([[-SPEED, SPEED]])),
              JointAccelerationConstraint(np.array([[-ACCELERATION, ACCELERATION]]))]
    motion = TOPPRA(limits, path, gridpoints=np.linspace(0, 1, intervals + 1), **settings).compute_trajectory()
    return motion.duration, np.abs(motion(np.linspace(0, motion.duration, 20001), 2)).max()


CONSTANT = {"parametrizer": "ParametrizeConstAccel"}
for name, intervals, settings in (("default", 100, {}), ("default", 500, {}), ("default", 2000, {}),
                                  ("constant acceleration", 100, CONSTANT)):
    duration, peak = move(intervals, **settings)
    print(f"{name}, {intervals} intervals: {duration:.4f} s, peak {peak:.3f} m/s2")
    assert abs(duration - EXACT) < 1e-4
    assert abs(peak - ACCELERATION) < 1e-6 * ACCELERATION if settings else peak > 1.1 * ACCELERATION
CHECK
"$folder/env/bin/python" "$folder/check.py"
