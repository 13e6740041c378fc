#!/usr/bin/env bash
# pymunk 7.3.1: a lever with a torsion spring and stops, and the sign of the angle between two bodies.
#
# Behaviour: the rest angle of `DampedRotarySpring(a, b)` is the angle of the first body relative to the second, and
# the limits of `RotaryLimitJoint(a, b)` and the phase of `GearJoint(a, b)` are of the second relative to the first. A
# lever with a spring at rest at 0.5 rad goes to -0.5 rad. With stops at -0.2 and 1 rad, which contain the rest angle,
# the spring presses it against the stop at -0.2.
#
# Guess before: one convention for all constraints of angles, so the lever rests at 0.5 rad.
#
# Source: the documentation of `rest_angle` has "The relative angle in radians that the bodies want to have", and the
# one of the limit joint "Constrains the relative rotations of two bodies". Both have the same order of bodies.
#
# Seen, angle of the lever relative to the frame:
#   spring alone, rest at 0.5: -0.500
#   spring, rest at 0.5, and stops at -0.2 and 1: -0.200
#   gear of ratio 1 with the phase 0.5: 0.500
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile pymunk==7.3.1
cat >"$folder/check.py" <<'CHECK'
import pymunk


def settle(*constraints):
    """The angle of a lever on a frame after 20 s, with constraints between frame and lever."""
    space = pymunk.Space()
    frame, lever = space.static_body, pymunk.Body(mass=1, moment=1)
    space.add(lever, pymunk.PivotJoint(frame, lever, (0, 0)))
    space.add(*(kind(frame, lever, *values) for kind, *values in constraints))
    for _ in range(20_000):
        space.step(0.001)
    return lever.angle


SPRING, STOPS = (pymunk.DampedRotarySpring, 0.5, 5.0, 3.0), (pymunk.RotaryLimitJoint, -0.2, 1.0)
for name, angle, expected in (("spring alone, rest at 0.5", settle(SPRING), -0.5),
                              ("spring, rest at 0.5, and stops at -0.2 and 1", settle(SPRING, STOPS), -0.2),
                              ("gear of ratio 1 with the phase 0.5", settle((pymunk.GearJoint, 0.5, 1.0)), 0.5)):
    print(f"{name}: {angle:.3f}")
    assert abs(angle - expected) < 0.005
CHECK
"$folder/env/bin/python" "$folder/check.py"
