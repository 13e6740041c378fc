#!/usr/bin/env bash
# python-fcl 0.7.0.11 and coal 3.0.3, collision libraries: the clearance of a lever, a box of 70 mm, from a roller, a
# cylinder of 10 mm, while the lever turns.
#
# Behaviour: for whole ranges of the angle the distance of FCL is too large by 4.1 mm: 14.2 mm in place of 10.1 mm. With
# lengths in metres 4 % of the angles are concerned, among them 0 to 3 degrees, and with lengths in millimetres a few
# ones. No message is printed, and the next angle can be right to 1e-3 mm. coal, which began as a fork of FCL, is right
# to 2e-3 mm in metres.
#
# A fair guess: the distance of two convex bodies is right to about 1e-6 of their size, in each unit of length.
#
# Source: the documentation of FCL has the exact positive distance for objects that are apart. Its request 321 gave
# spheres and cylinders a formula of their own, since small features had wrong distances.
#
# Seen:
#   FCL in m: 146 of 3600 angles wrong by more than 0.1 mm, at 3.05 degrees 14.26 mm in place of 10.13 mm
#   FCL in mm: 5 of 3600 angles wrong by more than 0.1 mm, at 1.35 degrees 14.22 mm in place of 10.11 mm
#   coal in m: 0 of 3600 angles wrong by more than 0.1 mm, at 152.90 degrees 10.44 mm in place of 10.44 mm
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet python-fcl==0.7.0.11 coal==3.0.3 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import coal
import fcl
import numpy as np

BOX, RADIUS, ROLLER = np.array([70, 15, 10]), 10, np.array([-55, 10, 0])
ANGLES = np.radians(np.arange(3600) * 0.05)


def turned(angle):
    cos, sin = math.cos(angle), math.sin(angle)
    return np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1.0]])


def exact(angle):
    """The clearance in mm of the roller from the lever, which turns about its middle."""
    x, y = np.abs(turned(angle).T @ ROLLER)[:2] - BOX[:2] / 2
    return math.hypot(max(x, 0), max(y, 0)) + min(max(x, y), 0) - RADIUS


def in_fcl(scale, angle):
    lever = fcl.CollisionObject(fcl.Box(*(BOX * scale)), fcl.Transform(turned(angle), np.zeros(3)))
    roller = fcl.CollisionObject(fcl.Cylinder(RADIUS * scale, BOX[2] * scale), fcl.Transform(np.eye(3), ROLLER * scale))
    return fcl.distance(lever, roller, fcl.DistanceRequest(), fcl.DistanceResult()) / scale


def in_coal(scale, angle):
    lever, roller = coal.Box(*(BOX * scale)), coal.Cylinder(RADIUS * scale, BOX[2] * scale)
    poses = coal.Transform3s(turned(angle), np.zeros(3)), coal.Transform3s(np.eye(3), ROLLER * scale)
    return coal.distance(lever, poses[0], roller, poses[1], coal.DistanceRequest(), coal.DistanceResult()) / scale


def report(name, distance, scale):
    """Prints the worst angle, and returns the largest error in mm and the number of angles off by over 0.1 mm."""
    rows = [(abs(distance(scale, angle) - exact(angle)), angle) for angle in ANGLES]
    error, angle = max(rows)
    wrong = sum(row[0] > 0.1 for row in rows)
    print(f"{name}: {wrong} of {len(rows)} angles wrong by more than 0.1 mm, at {math.degrees(angle):.2f} degrees "
          f"{distance(scale, angle):.2f} mm in place of {exact(angle):.2f} mm")
    return error, wrong


assert min(exact(angle) for angle in ANGLES) > 9
error, wrong = report("FCL in m", in_fcl, 1e-3)
assert 4 < error < 5 and 100 < wrong < 200
error, wrong = report("FCL in mm", in_fcl, 1.0)
assert error < 5 and wrong < 20
error, wrong = report("coal in m", in_coal, 1e-3)
assert error < 2e-3 and wrong == 0
CHECK
"$folder/env/bin/python" "$folder/check.py"
