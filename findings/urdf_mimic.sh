#!/usr/bin/env bash
# pin 4.1.0 (Pinocchio), pybullet 3.2.7 and mujoco 4.0.0: one URDF with a joint that mimics another.
#
# Behaviour: MuJoCo couples the joints by an equality constraint. Pinocchio's `buildModelFromUrdf` reads two
# independent joints unless `mimic=True` is given, which then leaves one coordinate. pybullet reads two independent
# joints and no constraint. None of the three prints anything about the element, so the same file has one degree of
# freedom in one tool and two in the others.
#
# Guess before: a reader that does not couple the joints warns of it, as it does of a link without inertia (pybullet).
#
# Source: the URDF page of `joint` says of `mimic` that the joint mimics another one. The signature of
# `buildModelFromUrdf` in its documentation string has `mimic=False`. pybullet's library does not contain the word.
#
# Seen: mujoco: 2 joints, 1 equality; pinocchio: 2 coordinates, with mimic=True 1; pybullet: 2 joints, 0 constraints
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pin==4.1.0 pybullet==3.2.7 mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import os
import sys

import mujoco
import pinocchio
import pybullet

path = sys.argv[1] + "/mimic.urdf"
INERTIAL = ('<inertial><origin xyz="0.1 0 0"/><mass value="1"/>'
            '<inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>')
with open(path, "w") as file:
    file.write('<robot name="two">')
    for link in ("base", "a", "b"):
        file.write(f'<link name="{link}">{INERTIAL}</link>')
    for name, child, x, mimic in (("first", "a", 0, ""), ("second", "b", 1, '<mimic joint="first" multiplier="-2"/>')):
        file.write(f'<joint name="{name}" type="revolute"><parent link="base"/><child link="{child}"/>'
                   f'<origin xyz="{x} 0 0"/><axis xyz="0 0 1"/>'
                   f'<limit lower="-3" upper="3" effort="10" velocity="10"/>{mimic}</joint>')
    file.write("</robot>")

in_mujoco = mujoco.MjModel.from_xml_path(path)
free, coupled = pinocchio.buildModelFromUrdf(path), pinocchio.buildModelFromUrdf(path, mimic=True)
pybullet.connect(pybullet.DIRECT)
# What pybullet prints comes from C++, so it is collected from the file descriptors.
log, old = os.open(sys.argv[1] + "/log", os.O_CREAT | os.O_RDWR), [os.dup(1), os.dup(2)]
os.dup2(log, 1), os.dup2(log, 2)
robot = pybullet.loadURDF(path, useFixedBase=True)
os.dup2(old[0], 1), os.dup2(old[1], 2)
with open(sys.argv[1] + "/log") as file:
    printed = file.read()
joints, constraints = pybullet.getNumJoints(robot), pybullet.getNumConstraints()
print("mujoco:", in_mujoco.nv, "joints,", in_mujoco.neq, "equality")
print("pinocchio:", free.nv, "coordinates, with mimic=True", coupled.nv)
print("pybullet:", joints, "joints,", constraints, "constraints, printed:", repr(printed))
assert (in_mujoco.nv, in_mujoco.neq, free.nv, coupled.nv, joints, constraints) == (2, 1, 2, 1, 2, 0)
assert "mimic" not in printed
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
