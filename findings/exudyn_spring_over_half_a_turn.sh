#!/usr/bin/env bash
# exudyn 1.13.6: a wheel on a torsional spring, `ObjectConnectorTorsionalSpringDamper`, that turns by several turns.
#
# Behaviour: the spring forgets whole turns. At half a turn its moment jumps from -pi to +pi times the stiffness, and
# drives the wheel on instead of holding it. A wheel of 1 kg m2 on a spring of 1 N m/rad that starts with 20 rad/s is at
# 19.9 rad after a second, where it is at 20 sin 1 = 16.8 rad. Nothing is printed. With a node of generic data as
# `nodeNumber` the spring counts turns, and the angle is right. The angle of the wheel's node counts turns in both cases.
#
# Guess before: the moment is the stiffness times the angle, as the angle of a body of the plane counts its turns.
#
# Source: the documentation string gives the stiffness "against relative rotation", and the optional `nodeNumber` as a
# node "for continuous rotation reconstruction", mentioned with the measurement of rotations.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet exudyn==1.13.6 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math
import warnings

warnings.simplefilter("ignore", DeprecationWarning)

import exudyn
from exudyn.itemInterface import (
    MarkerBodyRigid,
    NodeGenericData,
    NodeRigidBody2D,
    ObjectConnectorTorsionalSpringDamper,
    ObjectGround,
    ObjectRigidBody2D,
)

SPEED = 20.0


def angle_after_a_second(counts_turns):
    container = exudyn.SystemContainer()
    system = container.AddSystem()
    ground = system.AddObject(ObjectGround())
    node = system.AddNode(NodeRigidBody2D(initialVelocities=[0.0, 0.0, SPEED]))
    wheel = system.AddObject(ObjectRigidBody2D(physicsMass=1.0, physicsInertia=1.0, nodeNumber=node))
    markers = [system.AddMarker(MarkerBodyRigid(bodyNumber=body)) for body in (ground, wheel)]
    options = {}
    if counts_turns:
        options["nodeNumber"] = system.AddNode(NodeGenericData(initialCoordinates=[0.0], numberOfDataCoordinates=1))
    system.AddObject(ObjectConnectorTorsionalSpringDamper(markerNumbers=markers, stiffness=1.0, **options))
    system.Assemble()
    settings = exudyn.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 10_000
    settings.timeIntegration.endTime = 1.0
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    system.SolveDynamic(settings)
    return system.GetNodeOutput(node, exudyn.OutputVariableType.Coordinates)[2]


exact = SPEED * math.sin(1.0)
default, counted = angle_after_a_second(False), angle_after_a_second(True)
print(f"exact {exact:.4f}, default {default:.4f}, with a node {counted:.4f}")
assert abs(default - exact) > 2.0 and abs(counted - exact) < 1e-3
CHECK
cd "$folder"
"$folder/env/bin/python" "$folder/check.py"
