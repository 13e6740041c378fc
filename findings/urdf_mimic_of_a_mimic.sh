#!/usr/bin/env bash
# urchin 0.0.30, yourdfpy 0.0.60, pin 4.1.0 (Pinocchio) and mujoco 4.0.0: a URDF joint that mimics a joint that mimics.
#
# Behaviour: `b` follows `a` by a factor of 2, and `c` follows `b` by a factor of 3 and an offset of 0.1, so `c` is at
# 1.3 rad if `a` is at 0.2. MuJoCo's equalities are satisfied there. yourdfpy takes 0 for `b`, so `c` is at 0.1, with a
# warning in its log. urchin leaves `c` at 0, without its offset and without a message. Pinocchio with `mimic=True`
# raises ValueError. The joint `b` is at 0.4 in yourdfpy and in urchin, as it should be.
#
# Guess before: each of the four follows the chain, as it follows a single joint.
#
# Source: the URDF page of `joint` gives `value = multiplier * other_joint_value + offset` for `mimic`, for any other
# joint. The warning is of `update_cfg` in yourdfpy/urdf.py; `link_fk_batch` and `link_fk` in urchin/urdf.py look up the
# leader among the values that were given.
#
# Seen: urchin: b 0.4, c 0.0; yourdfpy: b 0.4, c 0.1; pinocchio: ValueError; mujoco: residuals 0 at b 0.4, c 1.3
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet urchin==0.0.30 yourdfpy==0.0.60 pin==4.1.0 mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import sys

import mujoco
import numpy as np
import pinocchio
import urchin
import yourdfpy

path = sys.argv[1] + "/chain.urdf"
INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
JOINTS = {"a": "", "b": '<mimic joint="a" multiplier="2"/>', "c": '<mimic joint="b" multiplier="3" offset="0.1"/>'}
with open(path, "w") as file:
    file.write(f'<robot name="r"><link name="base">{INERTIAL}</link>')
    for name, mimic in JOINTS.items():
        file.write(f'<link name="{name}_link">{INERTIAL}</link><joint name="{name}" type="revolute">'
                   f'<parent link="base"/><child link="{name}_link"/><axis xyz="0 0 1"/>'
                   f'<limit lower="-3" upper="3" effort="1" velocity="1"/>{mimic}</joint>')
    file.write("</robot>")


def turn(matrix):
    return round(float(np.arctan2(matrix[1, 0], matrix[0, 0])), 6)


robot = urchin.URDF.load(path)
poses = robot.link_fk({"a": 0.2})
in_urchin = [turn(poses[robot.link_map[f"{name}_link"]]) for name in "abc"]
other = yourdfpy.URDF.load(path)
other.update_cfg({"a": 0.2})
in_yourdfpy = [turn(other.get_transform(f"{name}_link", "base")) for name in "abc"]
try:
    pinocchio.buildModelFromUrdf(path, mimic=True)
    in_pinocchio = None
except ValueError:
    in_pinocchio = "ValueError"
model = mujoco.MjModel.from_xml_path(path)
data = mujoco.MjData(model)
data.qpos[:] = 0.2, 0.4, 1.3
mujoco.mj_forward(model, data)
residual = np.abs(data.efc_pos[:data.ne]).max()
print("urchin:", in_urchin, "yourdfpy:", in_yourdfpy)
print("pinocchio:", in_pinocchio, "mujoco:", data.ne, "equalities, residual", residual)
assert in_urchin == [0.2, 0.4, 0.0] and in_yourdfpy == [0.2, 0.4, 0.1] and in_pinocchio == "ValueError"
assert data.ne == 2 and residual < 1e-12
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
