#!/usr/bin/env bash
# interpolatepy 3.3.2, `DoubleSTrajectory`: a stroke with limited jerk that is too short for its full speed.
#
# Behaviour: strokes of 5 to 100 mm use 5.05 to 5.45 m/s^2 of the 10 m/s^2 that are allowed, and take 22 to 36 % longer
# than the fastest motion within the same limits. A stroke of 500 mm, which reaches its full speed, uses all of it.
# Nothing is printed.
#
# Guess before: the profile is the fastest one within its limits, as in the textbook, so its acceleration is 10 m/s^2.
#
# Source: `_fit_reduced_acceleration` in motion/_double_s_planner.py searches for a factor of the acceleration by
# bisection between 0.01 and 1. Its first trial, 0.505, is taken if both ramps have a part of constant acceleration.
#
# Seen, limits of 1 m/s, 10 m/s^2 and 1000 m/s^3:
#   5 mm: acceleration 5.05, 0.068 s, fastest 0.056 s
#   20 mm: acceleration 5.05, 0.131 s, fastest 0.100 s
#   100 mm: acceleration 5.05, 0.287 s, fastest 0.210 s
#   500 mm: acceleration 10.00, 0.610 s, fastest 0.610 s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile interpolatepy==3.3.2 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import math

from interpolatepy import DoubleSTrajectory, StateParams, TrajectoryBounds

SPEED, ACCELERATION, JERK = 1.0, 10.0, 1000.0
RAMP = ACCELERATION / JERK


def fastest(stroke):
    """Time of the fastest motion from rest to rest whose ramps have a part of constant acceleration."""
    time = RAMP + math.sqrt(RAMP**2 + 4 * stroke / ACCELERATION)
    if ACCELERATION * (time / 2 - RAMP) <= SPEED:
        return time
    return stroke / SPEED + SPEED / ACCELERATION + RAMP


for stroke, share in ((0.005, 0.505), (0.02, 0.505), (0.1, 0.505), (0.5, 1.0)):
    state = StateParams(q_0=0.0, q_1=stroke, v_0=0.0, v_1=0.0)
    motion = DoubleSTrajectory(state, TrajectoryBounds(v_bound=SPEED, a_bound=ACCELERATION, j_bound=JERK))
    peak = JERK * motion.get_phase_durations()["jerk_acceleration"]
    duration = motion.get_duration()
    print(f"{1000 * stroke:.0f} mm: acceleration {peak:.2f}, {duration:.3f} s, fastest {fastest(stroke):.3f} s")
    assert abs(peak - share * ACCELERATION) < 0.01
    assert (duration > 1.2 * fastest(stroke)) == (share < 1) and duration > 0.999 * fastest(stroke)
CHECK
"$folder/env/bin/python" "$folder/check.py"
