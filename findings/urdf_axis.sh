#!/usr/bin/env bash
# kinpy 0.6.1, ikpy 4.2.1, yourdfpy 0.0.60, urchin 0.0.30, pin 4.1.0 (Pinocchio), pybullet 3.2.7 and mujoco 4.0.0: the
# `axis` of a joint in URDF, at a joint value of 0.2.
#
# Behaviour: a joint without an `axis` turns about x, but in kinpy about z. A prismatic joint with the axis (0, 1, 1)
# moves by 0.2 in Pinocchio, MuJoCo and urchin, and by 0.2828 in kinpy, ikpy, yourdfpy and pybullet. A revolute joint
# with this axis turns by 0.2 in all but ikpy, whose rotation matrix has a determinant of 1.06. pybullet prints a note
# of the missing axis, the others print nothing. Rounding counts too: (0.71, 0.71, 0) makes a stroke 0.4 % longer.
#
# Guess before: x in all seven, and an axis is a direction, so each reader divides by its length.
#
# Source: the URDF page of `joint` gives (1,0,0) as the default, and states that the vector should be normalized. It
# has no rule for one that is not.
#
# Seen:
#   kinpy      no axis: z, stroke 0.2828, angle 0.2
#   ikpy       no axis: x, stroke 0.2828, angle none, determinant 1.06
#   yourdfpy, pybullet no axis: x, stroke 0.2828, angle 0.2
#   urchin, pinocchio, mujoco no axis: x, stroke 0.2, angle 0.2
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet kinpy==0.6.1 ikpy==4.2.1 yourdfpy==0.0.60 urchin==0.0.30 pin==4.1.0 \
    pybullet==3.2.7 mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import os
import sys
import warnings

import ikpy.chain
import kinpy
import mujoco
import numpy as np
import pinocchio
import pybullet
import urchin
import yourdfpy

warnings.simplefilter("ignore")
pybullet.connect(pybullet.DIRECT)
INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
VALUE = 0.2


def in_kinpy(path):
    with open(path) as file:
        return kinpy.build_chain_from_urdf(file.read()).forward_kinematics({"j": VALUE})["b"].matrix()


def in_ikpy(path):
    return ikpy.chain.Chain.from_urdf_file(path, base_elements=["a"]).forward_kinematics([0.0, VALUE])


def in_yourdfpy(path):
    robot = yourdfpy.URDF.load(path)
    robot.update_cfg({"j": VALUE})
    return robot.get_transform("b", "a")


def in_urchin(path):
    robot = urchin.URDF.load(path)
    return robot.link_fk({"j": VALUE})[robot.link_map["b"]]


def in_pinocchio(path):
    model = pinocchio.buildModelFromUrdf(path)
    data = model.createData()
    pinocchio.framesForwardKinematics(model, data, np.array([VALUE]))
    return data.oMf[model.getFrameId("b")].homogeneous


def in_pybullet(path):
    robot = pybullet.loadURDF(path, useFixedBase=True)
    pybullet.resetJointState(robot, 0, VALUE)
    position, quaternion = pybullet.getLinkState(robot, 0, computeForwardKinematics=True)[4:6]
    found = np.eye(4)
    found[:3, :3], found[:3, 3] = np.reshape(pybullet.getMatrixFromQuaternion(quaternion), (3, 3)), position
    return found


def in_mujoco(path):
    model = mujoco.MjModel.from_xml_path(path)
    data = mujoco.MjData(model)
    data.qpos[0] = VALUE
    mujoco.mj_kinematics(model, data)
    found = np.eye(4)
    found[:3, :3], found[:3, 3] = data.xmat[-1].reshape(3, 3), data.xpos[-1]
    return found


def write(name, kind, axis):
    path = f"{sys.argv[1]}/{name}.urdf"
    with open(path, "w") as file:
        file.write(f'<robot name="r"><link name="a">{INERTIAL}</link><link name="b">{INERTIAL}</link>'
                   f'<joint name="j" type="{kind}"><parent link="a"/><child link="b"/>{axis}'
                   '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>')
    return path


AXIS = '<axis xyz="0 1 1"/>'
missing = write("missing", "revolute", "")
slide, hinge = write("slide", "prismatic", AXIS), write("hinge", "revolute", AXIS)
readers = {name[3:]: reader for name, reader in list(globals().items()) if name.startswith("in_")}
seen = {}
for name, reader in readers.items():
    turned = reader(missing)[:3, :3]
    about = "xyz"[int(np.argmax(np.diag(turned)))]
    stroke = float(np.linalg.norm(reader(slide)[:3, 3]))
    matrix = reader(hinge)[:3, :3]
    determinant = float(np.linalg.det(matrix))
    angle = float(np.arccos((np.trace(matrix) - 1) / 2)) if abs(determinant - 1) < 1e-5 else None
    seen[name] = about, round(stroke, 4), angle and round(angle, 4)
    print(f"{name:10} no axis: {about}, stroke {stroke:.4f}, angle {angle}, determinant {determinant:.4f}")
LONG = round(VALUE * 2**0.5, 4)
assert seen == {"kinpy": ("z", LONG, VALUE), "ikpy": ("x", LONG, None), "yourdfpy": ("x", LONG, VALUE),
                "urchin": ("x", VALUE, VALUE), "pinocchio": ("x", VALUE, VALUE), "pybullet": ("x", LONG, VALUE),
                "mujoco": ("x", VALUE, VALUE)}
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
