#!/usr/bin/env bash
# mujoco 4.0.0: `mj_inverse` for a four-bar at rest, closed by a `connect` constraint.
#
# Behaviour: for accelerations that satisfy the loop exactly, here zero, the force of the loop is zero. The result is
# the torques of the open tree: 31.88 N m on the crank, and 19.62 and 2.45 N m on the two joints that have no motor. By
# virtual work a crank torque of 14.715 N m alone holds the mechanism. With this torque `mj_forward` loads the loop and
# leaves small accelerations, and only for those `mj_inverse` returns 14.715, 0 and 0. The harder the constraint, the
# smaller the accelerations that separate both answers: 0.65 rad/s2 by default, 6e-4 with a `solimp` of 0.9999.
#
# Guess before: 14.715 N m on the crank and zero on the other joints, since the loop carries the rest.
#
# Source: the page "Computation" of the documentation makes the constraint force of the inverse a function of the
# accelerations. The force is proportional to their difference from a reference, which is zero for an exact motion.
#
# Seen:
#   default: inverse at 0: [31.8825 19.62 2.4525]; held with at most 6.5e-01 rad/s2, inverse there: [14.715 0. 0.]
#   0.9999: inverse at 0: [31.8825 19.62 2.4525]; held with at most 6.0e-04 rad/s2, inverse there: [14.715 0. 0.]
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import mujoco
import numpy as np


def body(name, mass, x, turn, length, inner=""):
    return (f'<body name="{name}" pos="{x} 0 0" euler="0 {-turn} 0"><joint axis="0 -1 0"/>'
            f'<inertial pos="{length / 2} 0 0" mass="{mass}" diaginertia="0.1 0.1 0.1"/>'
            f'<site name="{name}" pos="{length} 0 0"/>{inner}</body>')


# A parallelogram at 60 degrees: cranks of 1 m and 1 kg, coupler of 2 m and 2 kg, gravity along -z.
BODIES = body("crank", 1, 0, 60, 1, body("coupler", 2, 1, -60, 2)) + body("rocker", 1, 2, 60, 1)
# The coupler translates, so each mass counts with the horizontal distance that its height depends on.
HOLDING = np.array([9.81 * 0.5 * (0.5 * 1 + 1 * 2 + 0.5 * 1), 0.0, 0.0])


def inverse(model, data, acceleration):
    data.qacc[:] = acceleration
    mujoco.mj_inverse(model, data)
    return data.qfrc_inverse.copy(), np.abs(data.qfrc_constraint).max()


for name, settings, bound in (("default", "", 1.0), ("0.9999", 'solimp="0.9999 0.9999 0.001"', 1e-3)):
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><worldbody>{BODIES}</worldbody>'
        f'<equality><connect site1="coupler" site2="rocker" {settings}/></equality></mujoco>')
    data = mujoco.MjData(model)
    exact, unloaded = inverse(model, data, 0.0)
    assert np.abs(data.efc_pos).max() < 1e-15 and unloaded < 1e-12
    data.qfrc_applied[:] = HOLDING
    mujoco.mj_forward(model, data)
    still = data.qacc.copy()
    there, loaded = inverse(model, data, still)
    print(f"{name}: inverse at 0: {exact.round(4)}; held with at most {np.abs(still).max():.1e} rad/s2, "
          f"inverse there: {there.round(4) + 0.0}")
    assert np.abs(exact - [31.8825, 19.62, 2.4525]).max() < 1e-6
    assert 0.0 < np.abs(still).max() < bound and np.abs(there - HOLDING).max() < 1e-3 and loaded > 10.0
CHECK
"$folder/env/bin/python" "$folder/check.py"
