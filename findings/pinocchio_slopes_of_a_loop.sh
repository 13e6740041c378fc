#!/usr/bin/env bash
# pin 4.1.0 (Pinocchio), `computeConstraintDynamicsDerivatives` for a planar loop, compared with differences of
# `constraintDynamics`.
#
# Behaviour: the derivatives of the accelerations with respect to the coordinates are wrong if the point constraint
# closes a loop between two moving bodies. A parallelogram at rest without weight has the same acceleration for the
# same torque all along its motion. The derivative along that motion is (-0.72, 1.74, 0.30) in the frame `LOCAL` and
# (-0.36, 0.36, -0.36) in `LOCAL_WORLD_ALIGNED`, where differences give 0. It is the column of the joint that both
# bodies do not share; the other columns, and the derivatives with respect to speeds and torques, are right to nine
# digits. A constraint between a chain and the world is right in all columns.
#
# Guess before: all derivatives agree with differences, as for a constraint to the world.
#
# Source: the documentation string of the function names the derivatives with respect to q, v and tau, for constraints
# of the model in general. `RigidConstraintModel` is documented as a constraint between two joints.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pin==4.1.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import numpy as np
import pinocchio

SETTINGS = pinocchio.ProximalSettings(1e-14, 1e-14, 1e-10, 50)
TORQUE = np.array([1.0, 0.0, 0.0])


def place(x, y=0.0):
    return pinocchio.SE3(np.eye(3), np.array([x, y, 0.0]))


def largest_errors(parents, places, constraint, q, frame):
    """Derivatives with respect to the coordinates, and the largest error of each column."""
    model = pinocchio.Model()
    model.gravity.linear = np.zeros(3)
    inertia = pinocchio.Inertia(1.0, np.array([0.5, 0.0, 0.0]), 0.1 * np.eye(3))
    for parent, x in zip(parents, places):
        joint = model.addJoint(parent, pinocchio.JointModelRZ(), place(x), f"joint{model.njoints}")
        model.appendBodyToJoint(joint, inertia, pinocchio.SE3.Identity())
    models, states = pinocchio.StdVec_RigidConstraintModel(), pinocchio.StdVec_RigidConstraintData()
    models.append(pinocchio.RigidConstraintModel(pinocchio.ContactType.CONTACT_3D, model, *constraint, frame))
    states.append(models[0].createData())
    data = model.createData()
    pinocchio.initConstraintDynamics(model, data, models, states)

    def accelerations(q):
        return pinocchio.constraintDynamics(model, data, q, np.zeros(3), TORQUE, models, states, SETTINGS).copy()

    accelerations(q)
    pinocchio.computeConstraintDynamicsDerivatives(model, data, models, states, SETTINGS)
    found = data.ddq_dq.copy()
    step = 1e-6
    differences = [(accelerations(q + step * e) - accelerations(q - step * e)) / (2 * step) for e in np.eye(3)]
    return found, abs(found - np.array(differences).T).max(axis=0)


turn = math.radians(60.0)
loop = (2, place(2.0), 3, place(1.0))
closed = np.array([turn, -turn, turn])
for frame in (pinocchio.ReferenceFrame.LOCAL, pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED):
    slopes, errors = largest_errors((0, 1, 0), (0.0, 1.0, 2.0), loop, closed, frame)
    along = slopes @ np.array([1.0, -1.0, 1.0])
    print(frame, "errors of the columns:", errors, "along the loop:", along)
    assert errors[0] > 0.1 and errors[1:].max() < 1e-8 and abs(along).max() > 0.1
# The end of a chain, held by the world.
angles = np.array([turn, -turn - 0.3, 1.0])
x = math.cos(turn) + 2 * math.cos(-0.3) + math.cos(0.7)
y = math.sin(turn) + 2 * math.sin(-0.3) + math.sin(0.7)
_, errors = largest_errors(
    (0, 1, 2), (0.0, 1.0, 2.0), (3, place(1.0), 0, place(x, y)), angles, pinocchio.ReferenceFrame.LOCAL)
print("to the world:", errors)
assert errors.max() < 1e-7
CHECK
"$folder/env/bin/python" "$folder/check.py"
