#!/usr/bin/env bash
# robotpy-wpimath 2026.2.2, `TrapezoidProfile`, motion with limited speed and acceleration: an axis that cannot stop at
# its target, or cannot reach the speed of its target, within the way that is left.
#
# Behaviour: the profile jumps, at its beginning or at its end. An axis at 1 m/s and 100 mm before its target, with
# 2 m/s2, needs 250 mm to stop: the profile begins at -13.3 mm with 0.67 m/s, and stops at the target. An axis at rest
# that shall pass the point at 100 mm with 1 m/s is finished after 0.337 s, at 113.3 mm with 0.67 m/s; later calls take
# it to 175 mm, and from there to 100 mm from one call to the next. Nothing is raised or printed. From rest to rest the
# profile is right.
#
# Guess before: the axis passes the target and comes back, or goes back for a run-up.
#
# Source: the documentation of `calculate` states that the current state is at time 0; the class is for references
# that change at any time.
#
# Seen:
#   1 m/s, 100 mm left: at 0 s -13.3 mm and 0.673 m/s, at 0.337 s 100.0 mm and 0.000 m/s, largest jump 13.2 mm
#   run-up to 1 m/s: at 0 s 0.0 mm and 0.000 m/s, at 0.337 s 113.3 mm and 0.673 m/s, largest jump 74.9 mm
#   rest to rest: at 0 s 0.0 mm and 0.000 m/s, at 0.447 s 100.0 mm and 0.000 m/s, largest jump 0.0 mm
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile robotpy-wpimath==2026.2.2 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
from wpimath.trajectory import TrapezoidProfile

State = TrapezoidProfile.State
STEP = 1e-4


def motion(start, goal):
    """Duration in s, states at the beginning and at the end in m and m/s, largest jump of the position in m."""
    profile = TrapezoidProfile(TrapezoidProfile.Constraints(1.0, 2.0))
    start, goal = State(*start), State(*goal)
    profile.calculate(0.0, start, goal)
    duration = profile.totalTime()
    first, last = (profile.calculate(time, start, goal) for time in (0.0, duration))
    places = [start.position] + [profile.calculate(count * STEP, start, goal).position for count in range(10000)]
    jump = max(abs(after - before) - STEP for before, after in zip(places, places[1:]))
    return duration, (first.position, first.velocity), (last.position, last.velocity), max(jump, 0.0)


def near(state, expected):
    return all(abs(value - other) < 1e-4 for value, other in zip(state, expected))


CASES = {"1 m/s, 100 mm left": ((0.0, 1.0), (0.1, 0.0)), "run-up to 1 m/s": ((0.0, 0.0), (0.1, 1.0)),
         "rest to rest": ((0.0, 0.0), (0.1, 0.0))}
found = {}
for name, (start, goal) in CASES.items():
    duration, first, last, jump = found[name] = motion(start, goal)
    print(f"{name}: at 0 s {first[0] * 1e3:.1f} mm and {first[1]:.3f} m/s, at {duration:.3f} s {last[0] * 1e3:.1f} mm "
          f"and {last[1]:.3f} m/s, largest jump {jump * 1e3:.1f} mm")
    assert near(first, start) != (name == "1 m/s, 100 mm left")
    assert near(last, goal) != (name == "run-up to 1 m/s")
assert near(found["1 m/s, 100 mm left"][1], (-0.01334, 0.67332))
assert near(found["run-up to 1 m/s"][2], (0.11334, 0.67332))
assert found["1 m/s, 100 mm left"][3] > 0.013 and found["run-up to 1 m/s"][3] > 0.07 and found["rest to rest"][3] < 1e-6
CHECK
"$folder/env/bin/python" "$folder/check.py"
