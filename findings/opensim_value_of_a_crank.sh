#!/usr/bin/env bash
# opensim 4.6, `Coordinate.setValue` for the crank of a closed four-bar.
#
# Behaviour: the crank does not get the value. From a closed pose at 1 rad, `setValue(state, 2.0)` leaves it at 1.390
# rad with the loop closed, as the change is shared with coupler and rocker; `setValue(state, 3.0)` leaves it at 1.817.
# The same call again takes it further, to 2.000 at the twentieth.
# If the loop is closed by a `PointConstraint`, whose equation across the plane is redundant, the crank stays at 1 rad
# for each value. A crank that is set to 1.5 rad without constraints and then locked is at 1.19 rad after
# `Model.assemble`, and still locked. Neither an exception nor a message comes with any of these.
#
# Guess before: the value is held and the other two coordinates are solved for it, or an exception is raised.
#
# Source: the names, as the Python bindings have no texts for `setValue`, `setLocked` and `assemble`. The log at level
# `debug` calls the step tracking, with half the squared distance from the value as its cost, and no failure.
#
# Seen:
#   line: set 1.01, found 1.0037 rad; set 2.0, found 1.3900 rad; set 3.0, found 1.8166 rad
#   point: set 1.01, found 1.0000 rad; set 2.0, found 1.0000 rad; set 3.0, found 1.0000 rad
#   line: set 2.0 twenty times, found 2.0000 rad
#   locked at 1.5: True, after assembly 1.1905 rad
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet opensim==4.6 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import opensim

CRANK, COUPLER, ROCKER, FRAME, PHI = 0.05, 0.12, 0.1, 0.14, 1.0


def closed_pose():
    """The angles of crank, coupler and rocker at `PHI`, as coordinates."""
    pin = CRANK * math.cos(PHI), CRANK * math.sin(PHI)
    distance = math.hypot(FRAME - pin[0], pin[1])
    inner = math.acos((COUPLER**2 + distance**2 - ROCKER**2) / (2 * COUPLER * distance))
    theta = math.atan2(-pin[1], FRAME - pin[0]) + inner
    end = pin[0] + COUPLER * math.cos(theta), pin[1] + COUPLER * math.sin(theta)
    return PHI, theta - PHI, math.atan2(end[1], end[0] - FRAME)


def four_bar(constraint):
    """A model at the closed pose, its state and its three coordinates."""
    model = opensim.Model()
    model.setGravity(opensim.Vec3(0))
    crank, coupler, rocker = (opensim.Body(name, 1.0, opensim.Vec3(0), opensim.Inertia(0.1, 0.1, 0.1, 0, 0, 0))
                              for name in ("crank", "coupler", "rocker"))
    for body in (crank, coupler, rocker):
        model.addBody(body)
    ends = (("a", model.getGround(), 0.0, crank), ("b", crank, CRANK, coupler), ("d", model.getGround(), FRAME, rocker))
    zero = opensim.Vec3(0)
    for (name, parent, x, child), angle in zip(ends, closed_pose()):
        joint = opensim.PinJoint(name, parent, opensim.Vec3(x, 0, 0), zero, child, zero, zero)
        joint.updCoordinate().setDefaultValue(angle)
        model.addJoint(joint)
    far, near = opensim.Vec3(COUPLER, 0, 0), opensim.Vec3(ROCKER, 0, 0)
    if constraint == "line":
        closure = opensim.PointOnLineConstraint(coupler, opensim.Vec3(0, 0, 1), far, rocker, near)
    else:
        closure = opensim.PointConstraint(coupler, far, rocker, near)
    closure.setName("closure")
    model.addConstraint(closure)
    model.finalizeConnections()
    state = model.initSystem()
    return model, state, [model.getCoordinateSet().get(index) for index in range(3)]


def measure(coordinates, state):
    """The angle of the crank and the gap of the loop."""
    phi, turn, psi = (coordinate.getValue(state) for coordinate in coordinates)
    theta = phi + turn
    return phi, math.hypot(CRANK * math.cos(phi) + COUPLER * math.cos(theta) - FRAME - ROCKER * math.cos(psi),
                           CRANK * math.sin(phi) + COUPLER * math.sin(theta) - ROCKER * math.sin(psi))


found = {}
for constraint in ("line", "point"):
    for value in (1.01, 2.0, 3.0):
        model, state, coordinates = four_bar(constraint)
        coordinates[0].setValue(state, value)
        found[constraint, value], gap = measure(coordinates, state)
        print(f"{constraint}: set {value}, found {found[constraint, value]:.4f} rad, gap {gap:.1e} m")
        assert gap < 1e-9
model, state, coordinates = four_bar("line")
for _ in range(20):
    coordinates[0].setValue(state, 2.0)
repeated, gap = measure(coordinates, state)
print(f"line: set 2.0 twenty times, found {repeated:.4f} rad, gap {gap:.1e} m")
assert abs(repeated - 2.0) < 1e-3
model, state, coordinates = four_bar("line")
coordinates[0].setValue(state, 1.5, False)
coordinates[0].setLocked(state, True)
model.assemble(state)
locked, gap = measure(coordinates, state)
print(f"locked at 1.5: {coordinates[0].getLocked(state)}, after assembly {locked:.4f} rad, gap {gap:.1e} m")
assert [round(found["line", value], 2) for value in (1.01, 2.0, 3.0)] == [1.0, 1.39, 1.82]
assert all(abs(found["point", value] - PHI) < 1e-9 for value in (1.01, 2.0, 3.0))
assert coordinates[0].getLocked(state) and abs(locked - 1.5) > 0.2 and gap < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py"
