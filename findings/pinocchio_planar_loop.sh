#!/usr/bin/env bash
# pin 4.1.0 (Pinocchio), `constraintDynamics` with its default settings on a planar loop.
#
# Behaviour: a four-bar of three revolute joints is closed by a point constraint, `CONTACT_3D`, as there is none for
# the plane. The third row of the constraint is always satisfied. With the default settings all accelerations are NaN,
# without an exception or a message. With a proximal term of 1e-8 the answer is finite after a single iteration.
#
# Guess before: the redundant row is harmless by default, or refused.
#
# Source: the documentation string of `constraintDynamics` names the proximal settings as optional. Those of the class
# `ProximalSettings` have mu = 0 and one iteration.
#
# Seen: mu = 0, 1 iteration: [nan nan nan]; mu = 1e-8, 1 iteration: finite
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pin==4.1.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import numpy as np
import pinocchio


def place(x):
    return pinocchio.SE3(np.eye(3), np.array([x, 0.0, 0.0]))


model = pinocchio.Model()
inertia = pinocchio.Inertia(1.0, np.array([0.5, 0.0, 0.0]), 0.1 * np.eye(3))
joints = []
for parent, x in ((0, 0.0), (1, 1.0), (0, 2.0)):
    joints.append(model.addJoint(parent, pinocchio.JointModelRZ(), place(x), f"joint{len(joints)}"))
    model.appendBodyToJoint(joints[-1], inertia, pinocchio.SE3.Identity())
constraints, states = pinocchio.StdVec_RigidConstraintModel(), pinocchio.StdVec_RigidConstraintData()
constraints.append(pinocchio.RigidConstraintModel(
    pinocchio.ContactType.CONTACT_3D, model, joints[1], place(2.0), joints[2], place(1.0),
    pinocchio.ReferenceFrame.LOCAL))
states.append(constraints[0].createData())
data = model.createData()
pinocchio.initConstraintDynamics(model, data, constraints, states)
# A parallelogram at 60 degrees: closed, and away from its change points.
turn = math.radians(60.0)
q, v, tau = np.array([turn, -turn, turn]), np.array([1.0, -1.0, 1.0]), np.zeros(3)
default = pinocchio.ProximalSettings()
plain = pinocchio.constraintDynamics(model, data, q, v, tau, constraints, states).copy()
small = pinocchio.ProximalSettings(1e-12, 1e-12, 1e-8, 1)
proximal = pinocchio.constraintDynamics(model, data, q, v, tau, constraints, states, small).copy()
print(f"default, mu = {default.mu}, {default.max_iter} iteration:", plain)
print("mu = 1e-8, 1 iteration:", proximal)
assert np.isnan(plain).all() and np.isfinite(proximal).all()
CHECK
"$folder/env/bin/python" "$folder/check.py"
