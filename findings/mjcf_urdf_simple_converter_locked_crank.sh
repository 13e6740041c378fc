#!/usr/bin/env bash
# mjcf_urdf_simple_converter 0.7.3: a crank without a range in an MJCF, as URDF, in MuJoCo 4.0.0 and pybullet 3.2.7.
#
# Behaviour: the crank turns freely in MuJoCo. The URDF has it as a revolute joint with limits from 0 to 0. MuJoCo
# reads that back as a free crank, with a warning. pybullet locks it without one: a torque of 0.01 Nm for half a
# second leaves it at rest, and turns a continuous joint in its place by 0.19 rad. A rocker with a range keeps it.
#
# Guess before: a joint of type `continuous`, or wide limits.
#
# Source: a joint without limits has 0 0 in `jnt_range` of MuJoCo, and false in `jnt_limited`. The converter writes
# `jnt_range` for each hinge (mjcf_urdf_simple_converter.py, lines 51 and 199). The page `joint` of URDF has the type
# `continuous` for a joint without limits.
#
# Seen:
#   URDF: crank revolute from 0.0 to 0.0
#   URDF: rocker revolute from -1.0 to 1.0
#   MuJoCo, from the URDF: crank limited False, rocker limited True
#   pybullet: crank turned by 0.00 rad, a continuous one by 0.19 rad
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile mjcf-urdf-simple-converter==0.7.3 mujoco==4.0.0 pybullet==3.2.7 \
    numpy==2.4.6 scipy==1.17.1
cat >"$folder/model.xml" <<'MODEL'
<mujoco>
  <compiler angle="radian"/>
  <worldbody>
    <body name="frame">
      <geom type="box" size="0.1 0.1 0.1" mass="1"/>
      <body name="crank_body" pos="1 0 0">
        <joint name="crank" type="hinge" axis="0 0 1"/>
        <geom type="box" size="0.1 0.1 0.1" mass="1"/>
      </body>
      <body name="rocker_body" pos="2 0 0">
        <joint name="rocker" type="hinge" axis="0 0 1" range="-1 1"/>
        <geom type="box" size="0.1 0.1 0.1" mass="1"/>
      </body>
    </body>
  </worldbody>
</mujoco>
MODEL
cat >"$folder/check.py" <<'CHECK'
import sys
import xml.etree.ElementTree as ElementTree

import mjcf_urdf_simple_converter
import mujoco
import pybullet

TORQUE, STEPS = 0.01, 120

urdf, continuous = (f"{sys.argv[1]}/{name}.urdf" for name in ("model", "continuous"))
mjcf_urdf_simple_converter.convert(f"{sys.argv[1]}/model.xml", urdf)
joints = {joint.get("name"): joint for joint in ElementTree.parse(urdf).iter("joint")}
for name, limit in (("crank", 0.0), ("rocker", 1.0)):
    kind, limits = joints[name].get("type"), joints[name].find("limit")
    print(f"URDF: {name} {kind} from {limits.get('lower')} to {limits.get('upper')}")
    assert kind == "revolute" and (float(limits.get("lower")), float(limits.get("upper"))) == (-limit, limit)

model = mujoco.MjModel.from_xml_path(urdf)
limited = [bool(model.jnt_limited[model.joint(name).id]) for name in ("crank", "rocker")]
print(f"MuJoCo, from the URDF: crank limited {limited[0]}, rocker limited {limited[1]}")
assert limited == [False, True]


def turn(path):
    """Angle of the crank after half a second under a torque."""
    pybullet.connect(pybullet.DIRECT)
    robot = pybullet.loadURDF(path, useFixedBase=True, flags=pybullet.URDF_USE_INERTIA_FROM_FILE)
    names = [pybullet.getJointInfo(robot, joint)[1] for joint in range(pybullet.getNumJoints(robot))]
    crank = names.index(b"crank")
    pybullet.setJointMotorControl2(robot, crank, pybullet.VELOCITY_CONTROL, force=0)
    for _ in range(STEPS):
        pybullet.setJointMotorControl2(robot, crank, pybullet.TORQUE_CONTROL, force=TORQUE)
        pybullet.stepSimulation()
    angle = pybullet.getJointState(robot, crank)[0]
    pybullet.disconnect()
    return angle


with open(urdf) as source, open(continuous, "w") as target:
    target.write(source.read().replace('"revolute"', '"continuous"'))
locked, free = turn(urdf), turn(continuous)
print(f"pybullet: crank turned by {locked:.2f} rad, a continuous one by {free:.2f} rad")
assert abs(locked) < 1e-9 and abs(free - 0.187) < 0.01
CHECK
cd "$folder" # for the log of MuJoCo
env/bin/python check.py . 2>/dev/null
