#!/usr/bin/env bash
# py-slvs 1.0.6, the solver of SolveSpace: a crank driven by the angle to a fixed line.
#
# Behaviour: the angle is not signed. In steps of 20 degrees from 10 the crank turns to 170, then stays there for 190,
# and turns back: for 350 it is at 10. Each step returns 0, the code of success. In steps of 5 degrees, which meet 180,
# it goes on and turns fully: the solver stops a little short of 180, and the next step finds the other side.
#
# Guess before: the crank follows the angle, at least in steps much smaller than half a turn.
#
# Source: exposed/DOC.txt in SolveSpace's repository states the equation of `SLVS_C_ANGLE` by a cosine, and that the
# angle is therefore not unambiguous. The signature of `addAngle` has any angle in degrees.
#
# Seen:
#   steps of 20 degrees: largest 170.0, last for 350 degrees: 10.0
#   steps of 5 degrees: largest 355.0, last for 355 degrees: 355.0, for 180 degrees: 179.9998
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet py-slvs==1.0.6
cat >"$folder/check.py" <<'CHECK'
import math

from py_slvs import slvs


def crank(angle, start):
    """The code of the solver, and the pin of a crank of length 1 that turns about the origin."""
    system = slvs.System()
    origin = system.addPoint3dV(0.0, 0.0, 0.0, group=1)
    plane = system.addWorkplane(origin, system.addNormal3dV(1.0, 0.0, 0.0, 0.0, group=1), group=1)
    pivot, right = (system.addPoint2dV(plane, x, 0.0, group=1) for x in (0.0, 1.0))
    x, y = (system.addParamV(value, group=2) for value in start)
    pin = system.addPoint2d(plane, x, y, group=2)
    frame, link = system.addLineSegment(pivot, right, group=1), system.addLineSegment(pivot, pin, group=2)
    system.addPointsDistance(1.0, pivot, pin, plane, group=2)
    system.addAngle(angle, False, frame, link, plane, group=2)
    code = system.solve(group=2)
    return code, (system.getParam(x).val, system.getParam(y).val)


def turn(step):
    """The directions of the crank for each angle, from 10 degrees on; the last pin is the next guess."""
    pin, found = (math.cos(math.radians(10)), math.sin(math.radians(10))), {}
    for angle in range(10, 360, step):
        code, pin = crank(float(angle), pin)
        assert code == 0
        found[angle] = round(math.degrees(math.atan2(pin[1], pin[0])) % 360, 4)
    return found


wide, narrow = turn(20), turn(5)
print(f"steps of 20 degrees: largest {max(wide.values())}, last for 350 degrees: {wide[350]}")
print(f"steps of 5 degrees: largest {max(narrow.values())}, last for 355 degrees: {narrow[355]}, "
      f"for 180 degrees: {narrow[180]}")
assert all(abs(found - min(angle, 360 - angle)) < 1e-3 for angle, found in wide.items())
assert all(abs(found - angle) < 1e-3 for angle, found in narrow.items())
CHECK
"$folder/env/bin/python" "$folder/check.py"
