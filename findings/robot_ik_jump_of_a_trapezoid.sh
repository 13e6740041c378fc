#!/usr/bin/env bash
# robot-ik 0.4.0, trajectories: a trapezoidal profile for a time that is longer than the shortest one.
#
# Behaviour: a stroke of 1 m in 2 s within 1 m/s and 2 m/s^2 turns back before its end, at up to 0.58 m/s, and jumps
# by 84 mm at its last sample. A stroke of 2 m in 5 s jumps by 561 mm. In the shortest time, and for strokes that are
# too short for the full speed, the profile is right. `s_curve_profile` has limits as arguments and uses none of them:
# a stroke of 1 m in 0.5 s reaches 3.75 m/s. Nothing is raised.
#
# Guess before: the stroke is covered without a jump, and a limit that cannot be kept is reported.
#
# Source: the docstring of `trapezoidal_velocity_profile` in trajectory/module.py has "Adjusts peak velocity to match
# the specified duration while respecting limits". The code multiplies the peak by the ratio of both times, and a ramp
# down to rest from that peak ends before the duration. The docstring of `s_curve_profile` has "jerk limitation".
#
# Seen:
#   1 m in 2 s: last step 84.49 mm, lowest speed -0.581 m/s
#   2 m in 5 s: last step 561.00 mm, lowest speed -1.498 m/s
#   1 m in 1.5 s: last step 0.00 mm, lowest speed 0.000 m/s
#   0.4 m in 2 s: last step 0.00 mm, lowest speed 0.000 m/s
#   S-curve of 1 m in 0.5 s: 3.75 m/s within a limit of 1 m/s, 23.1 m/s^2 within 2 m/s^2
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile robot-ik==0.4.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from robot_ik.trajectory import s_curve_profile, trapezoidal_velocity_profile

SPEED, ACCELERATION, JERK = np.array([1.0]), np.array([2.0]), np.array([20.0])

for stroke, duration, jump in ((1, 2, 84.49), (2, 5, 561.0), (1, 1.5, 0.0), (0.4, 2, 0.0)):
    result = trapezoidal_velocity_profile(np.array([0.0]), np.array([float(stroke)]), duration, SPEED, ACCELERATION,
                                          dt=0.001)
    places, speeds = 1000 * result.joint_positions[:, 0], result.joint_velocities[:, 0]
    last, lowest = places[-1] - places[-2], speeds.min()
    print(f"{stroke} m in {duration} s: last step {last:.2f} mm, lowest speed {lowest:.3f} m/s")
    assert abs(last - jump) < 0.01 and (lowest < -0.5) == (jump > 0)
fast = s_curve_profile(np.array([0.0]), np.array([1.0]), 0.5, SPEED, ACCELERATION, JERK, dt=0.001)
speed, acceleration = fast.joint_velocities.max(), fast.joint_accelerations.max()
print(f"S-curve of 1 m in 0.5 s: {speed:.2f} m/s within a limit of 1 m/s, {acceleration:.1f} m/s^2 within 2 m/s^2")
assert abs(speed - 3.75) < 1e-3 and abs(acceleration - 23.09) < 0.01
CHECK
"$folder/env/bin/python" "$folder/check.py"
