#!/usr/bin/env bash
# mujoco 4.0.0, pybullet 3.2.7, pin 4.1.0 (Pinocchio), urchin 0.0.30 and yourdfpy 0.0.60: a planar joint in URDF, whose
# axis is y.
#
# Behaviour: the body moves in the x-z plane in MuJoCo and pybullet, and in the x-y plane in Pinocchio and urchin, which
# leave the axis out. It has three coordinates in the first three, and two in urchin, which cannot turn it. yourdfpy
# lists the joint with two values and accepts only one, which does not move the body. None prints a message.
#
# A fair guess: a planar joint has two shifts and one turn, in the plane normal to its axis, in each reader that accepts
# it.
#
# Source: the URDF page of `joint` states that a planar joint allows motion in a plane perpendicular to the axis. The
# text leaves open whether the body turns.
#
# Seen:
#   mujoco: 3 coordinates, moves along xz, turns about y
#   pybullet: 3 coordinates, moves along xz, turns about y
#   pinocchio: 3 coordinates, moves along xy, turns about z
#   urchin: 2 coordinates, moves along xy, turns about none
#   yourdfpy: 1 coordinates, moves along none, turns about none
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet yourdfpy==0.0.60 urchin==0.0.30 pin==4.1.0 pybullet==3.2.7 mujoco==4.0.0 \
    numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import sys
import warnings

import mujoco
import numpy as np
import pinocchio
import pybullet
import urchin
import yourdfpy

warnings.simplefilter("ignore")
VALUE, STEPS = 0.2, 60


def in_mujoco(path):
    """The poses of the body, as 4 by 4 matrices, for each coordinate alone."""
    model = mujoco.MjModel.from_xml_path(path)
    data = mujoco.MjData(model)
    for index in range(model.nq):
        data.qpos[:] = np.eye(model.nq)[index] * VALUE
        mujoco.mj_kinematics(model, data)
        yield pose(data.xmat[-1].reshape(3, 3), data.xpos[-1])


def in_pybullet(path):
    """The poses after a push along or about each axis, where the body moves: the state of the joint is not set."""
    for push, vectors in ((pybullet.applyExternalForce, np.eye(3)), (pybullet.applyExternalTorque, np.eye(3))):
        for vector in vectors:
            pybullet.resetSimulation()
            robot = pybullet.loadURDF(path, useFixedBase=True)
            for _ in range(STEPS):
                place = [[0, 0, 0]] if push is pybullet.applyExternalForce else []
                push(robot, 0, list(vector), *place, pybullet.LINK_FRAME)
                pybullet.stepSimulation()
            position, quaternion = pybullet.getLinkState(robot, 0, computeForwardKinematics=True)[4:6]
            found = pose(np.reshape(pybullet.getMatrixFromQuaternion(quaternion), (3, 3)), position)
            if not np.allclose(found, np.eye(4), atol=1e-4):
                yield found


def in_pinocchio(path):
    model = pinocchio.buildModelFromUrdf(path)
    data = model.createData()
    for index in range(model.nv):
        values = pinocchio.integrate(model, pinocchio.neutral(model), np.eye(model.nv)[index] * VALUE)
        pinocchio.framesForwardKinematics(model, data, values)
        yield data.oMf[model.getFrameId("b")].homogeneous.copy()


def in_urchin(path):
    robot = urchin.URDF.load(path)
    for values in np.eye(2) * VALUE:
        yield robot.link_fk({"j": values})[robot.link_map["b"]]


def in_yourdfpy(path):
    robot = yourdfpy.URDF.load(path)
    assert robot.num_dofs == 2 and robot.actuated_joint_names == ["j"]
    robot.update_cfg({"j": VALUE})
    yield robot.get_transform("b", "a")


def pose(rotation, position):
    found = np.eye(4)
    found[:3, :3], found[:3, 3] = rotation, position
    return found


INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
path = f"{sys.argv[1]}/planar.urdf"
with open(path, "w") as file:
    file.write(f'<robot name="r"><link name="a">{INERTIAL}</link><link name="b">{INERTIAL}</link><joint name="j" '
               'type="planar"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/></joint></robot>')
pybullet.connect(pybullet.DIRECT)

seen = {}
for name, reader in [(name[3:], reader) for name, reader in globals().items() if name.startswith("in_")]:
    poses = list(reader(path))
    moved = "".join(letter for index, letter in enumerate("xyz") if any(abs(p[index, 3]) > 1e-3 for p in poses))
    # A turn about an axis leaves the element of that axis on the diagonal at one, and no other.
    turned = "".join(letter for index, letter in enumerate("xyz")
                     if any(p[index, index] > 1 - 1e-6 and np.trace(p[:3, :3]) < 3 - 1e-4 for p in poses))
    seen[name] = len(poses), moved or "none", turned or "none"
    print("{}: {} coordinates, moves along {}, turns about {}".format(name, *seen[name]))
assert seen == {"mujoco": (3, "xz", "y"), "pybullet": (3, "xz", "y"), "pinocchio": (3, "xy", "z"),
                "urchin": (2, "xy", "none"), "yourdfpy": (1, "none", "none")}
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
