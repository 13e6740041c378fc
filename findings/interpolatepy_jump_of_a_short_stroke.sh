#!/usr/bin/env bash
# interpolatepy 3.3.2, `DoubleSTrajectory`: a stroke with limited jerk whose time is not a multiple of a millisecond.
#
# Behaviour: the position jumps where the deceleration begins, by up to half a millisecond at full speed. A stroke of
# 10 mm within 0.2 m/s jumps forward by 0.1 mm, one of 2 mm jumps back by 0.1 mm, and one of 0.02 mm jumps back by
# 0.116 mm, six times its length. `get_phase_durations` has the exact times of the phases, and their sum differs from
# its own total. A stroke whose time is a multiple of a millisecond has no jump. Nothing is printed.
#
# Guess before: the position is continuous, and its speed is within the limit everywhere.
#
# Source: the docstring of the class promises smooth motion with bounded velocity, acceleration and jerk.
# `_finalize_plan` in motion/_double_s_planner.py, line 240, rounds the total to thousandths, and the deceleration is
# computed from that end.
#
# Seen:
#   10 mm: phases 0.0565 s, total 0.056 s, largest step 0.0997 mm, regular 0.0001 mm
#   2 mm: phases 0.0165 s, total 0.017 s, largest step -0.0995 mm, regular 0.0000 mm
#   0.02 mm: phases 0.0006 s, total 0.001 s, largest step -0.1160 mm, regular 0.0000 mm
#   9.9 mm: phases 0.0560 s, total 0.056 s, largest step 0.0001 mm, regular 0.0001 mm
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile interpolatepy==3.3.2 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from interpolatepy import DoubleSTrajectory, StateParams, TrajectoryBounds

STEPS = 100_000
MACHINE, ACTUATOR = (0.2, 50.0, 2e4), (0.1, 500.0, 1e7)

for stroke, limits, jump in ((10.0, MACHINE, 0.0997), (2.0, MACHINE, -0.0995), (0.02, ACTUATOR, -0.116),
                             (9.9, MACHINE, 0.0)):
    speed, acceleration, jerk = limits
    state = StateParams(q_0=0.0, q_1=stroke / 1000, v_0=0.0, v_1=0.0)
    motion = DoubleSTrajectory(state, TrajectoryBounds(v_bound=speed, a_bound=acceleration, j_bound=jerk))
    parts = motion.get_phase_durations()
    exact = parts["acceleration"] + parts["constant_velocity"] + parts["deceleration"]
    total = motion.get_duration()
    steps = 1000 * np.diff(motion.evaluate(np.linspace(0.0, total, STEPS + 1)))
    largest, regular = steps[np.abs(steps).argmax()], 1000 * speed * total / STEPS
    print(f"{stroke:g} mm: phases {exact:.4f} s, total {total:.3f} s, largest step {largest:.4f} mm, "
          f"regular {regular:.4f} mm")
    assert abs(largest - jump) < 3e-4 and parts["total"] == total and (abs(exact - total) > 1e-4) == (jump != 0)
CHECK
"$folder/env/bin/python" "$folder/check.py"
