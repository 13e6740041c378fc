#!/usr/bin/env bash
# robot-ik 0.4.0, `DynamicsSolver`: holding torques and inertias of an arm by the recursive Newton-Euler method.
#
# Behaviour: a horizontal bar of 1 kg and 1 m needs 5 Nm to be held, and the solver returns -5 Nm. A chain of two needs
# 20 and 5 Nm, and the solver returns 0 and -15 Nm. In the arm with six joints that the package has as its model, the
# vertical first joint holds -33 Nm of weight, where it carries none, and its inertia is negative. Nothing is raised.
#
# Guess before: 5 Nm, 20 and 5 Nm, no weight on a vertical axis, and a positive inertia.
#
# Source: the docstring of `inverse_dynamics` has "Verified against textbook analytical solutions". `com` of
# `LinkInertia` is in the frame of the link, which is at the far end: the package's own bar of 0.5 m has it at -0.25. In
# dynamics/solver.py the vector to the centre of mass has the rotation of that frame and not its position, and the axis
# of a joint is that of the next frame.
#
# Seen:
#   1 bar: holding torques -5.000
#   2 bars: holding torques 0.000 -15.000
#   six joints: weight on the vertical joint -33.452, its inertia -0.0083, difference across the diagonal 0.621
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile robot-ik==0.4.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from robot_ik.dynamics import DynamicsSolver, LinkInertia, RobotDynamicsModel, six_dof_articulated_dyn

BAR = LinkInertia(mass=1.0, com=np.array([-0.5, 0.0, 0.0]), inertia=np.diag([0.0, 1 / 12, 1 / 12]))

for count, expected in ((1, [-5.0]), (2, [0.0, -15.0])):
    zeros = np.zeros(count)
    chain = DynamicsSolver(RobotDynamicsModel(
        dh_a=np.ones(count), dh_alpha=zeros, dh_d=zeros, links=[BAR] * count,
        gravity=np.array([0.0, -10.0, 0.0]), joint_damping=zeros))
    torques = chain.gravity_torque(zeros)
    print(f"{count} bar{'s' if count > 1 else ''}: holding torques "
          + " ".join(f"{value + 0.0:.3f}" for value in torques))
    assert np.allclose(chain.forward_kinematics_all(zeros)[-1][:3, 3], [count, 0, 0])
    assert np.allclose(torques, expected)
arm = DynamicsSolver(six_dof_articulated_dyn())
weight, inertia = arm.gravity_torque(np.zeros(6))[0], arm.inertia_matrix(np.zeros(6))
difference = np.abs(inertia - inertia.T).max()
print(f"six joints: weight on the vertical joint {weight:.3f}, its inertia {inertia[0, 0]:.4f}, "
      f"difference across the diagonal {difference:.3f}")
assert abs(weight + 33.452) < 1e-3 and inertia[0, 0] < 0 and difference > 0.5
CHECK
"$folder/env/bin/python" "$folder/check.py"
