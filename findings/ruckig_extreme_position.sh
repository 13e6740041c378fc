#!/usr/bin/env bash
# ruckig 0.19.4, motion laws with limited jerk: the extreme positions of an axis that moves away before it turns back.
#
# Behaviour: `position_extrema` leaves out turning points in a phase of constant acceleration, and returns the position
# at the end of the phase before. An axis at 0.5 m/s that has to go back by 1 m overshoots to 109.2 mm at 0.35 s, and
# the list has 86.7 mm at 0.2 s. An axis that starts backwards to reach a speed of 1 m/s at the target moves back by
# 346.7 mm, and the list has 293.7 mm. Turning points in a phase of changing acceleration are right.
#
# A fair guess: the extreme positions and their times are those of the trajectory, up to rounding.
#
# Source: the README lists `get_position_extrema` with information about the extreme positions and their times. Issue
# 215 of the project, which is open, reports a difference for another trajectory.
#
# Seen:
#   overshoot: 109.17 mm at 0.350 s, listed 86.67 mm at 0.200 s
#   run-up: -346.67 mm at 0.960 s, listed -293.71 mm at 0.730 s
#   small speed: -9.91 mm at 0.273 s, listed -9.91 mm at 0.273 s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet ruckig==0.19.4
cat >"$folder/check.py" <<'CHECK'
from ruckig import InputParameter, Result, Ruckig, Trajectory

SAMPLES = 20000


def compare(name, sign, exact, **values):
    """Prints the extreme position and its time, sampled and listed, in mm and s, and returns the difference in mm."""
    given = InputParameter(1)
    start = {"current_position": 0.0, "current_velocity": 0.0, "current_acceleration": 0.0, "target_velocity": 0.0,
             "target_acceleration": 0.0, "max_velocity": 1.0, "max_acceleration": 2.0, "max_jerk": 10.0}
    for key, value in (start | values).items():
        setattr(given, key, [value])
    trajectory = Trajectory(1)
    assert Ruckig(1, 0.01).calculate(given, trajectory) == Result.Working
    times = [trajectory.duration * index / SAMPLES for index in range(SAMPLES + 1)]
    position, time = max((sign * trajectory.at_time(time)[0][0], time) for time in times)
    bound = trajectory.position_extrema[0]
    listed, listed_time = (bound.max, bound.t_max) if sign > 0 else (bound.min, bound.t_min)
    print(f"{name}: {sign * position * 1e3:.2f} mm at {time:.3f} s, "
          f"listed {listed * 1e3:.2f} mm at {listed_time:.3f} s")
    assert exact is None or abs(sign * position - exact) < 1e-6
    return abs(listed - sign * position) * 1e3


# Slowing down from v needs t = a / j until the deceleration is a, and the speed is v - a * t / 2 there.
SPEED, ACCELERATION, JERK = 0.5, 2.0, 10.0
ramp = ACCELERATION / JERK
rest = SPEED - ACCELERATION * ramp / 2
OVERSHOOT = SPEED * ramp - JERK * ramp**3 / 6 + rest**2 / (2 * ACCELERATION)

assert abs(compare("overshoot", 1, OVERSHOOT, current_velocity=SPEED, target_position=-1.0) - 22.5) < 0.1
assert abs(compare("run-up", -1, None, target_position=0.0, target_velocity=1.0) - 53.0) < 0.1
assert compare("small speed", -1, None, target_position=0.1, target_velocity=0.5) < 0.01
CHECK
"$folder/env/bin/python" "$folder/check.py"
