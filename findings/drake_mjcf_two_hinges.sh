#!/usr/bin/env bash
# drake 1.51.1 (the newest for Python 3.11), the parser of MJCF: a body with two joints, compared with mujoco 4.0.0
# and pin 4.1.0 (Pinocchio).
#
# Behaviour: a body at (1, 0, 0) on two hinges, as in a universal joint, stays there in MuJoCo and in Pinocchio whatever
# the angles. In Drake the first hinge turns it about the origin of its parent: with 0.7 rad it is at (0.765, 0.644, 0).
# A hinge with a slide is off by the same turn, a slide with a hinge is right, and so is a single hinge. The rotations
# agree in all cases, and at zero the positions do. Nothing is printed.
#
# Guess before: the three tools place the body alike, since several joints per body are usual in this format.
#
# Source: MuJoCo's XML reference allows several joints in a body, and composes them in the order of the file. Drake's
# issue 20367 is about another misplacement of joints, corrected in 2023, and treats the difference to MuJoCo as a bug.
#
# Seen, at 0.7 and 0.3:
#   hinge: mujoco (1.000, 0.000, 0.000), pinocchio the same, drake (1.000, 0.000, 0.000)
#   hinge, hinge: mujoco (1.000, 0.000, 0.000), pinocchio the same, drake (0.765, 0.644, 0.000)
#   hinge, slide: mujoco (0.807, 0.229, 0.000), pinocchio the same, drake (0.572, 0.874, 0.000)
#   slide, hinge: mujoco (1.000, 0.700, 0.000), pinocchio the same, drake (1.000, 0.700, 0.000)
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet drake==1.51.1 pin==4.1.0 mujoco==4.0.0 numpy==2.4.6
cat >"$folder/mujoco_and_pinocchio.py" <<'CHECK'
import json
import sys

import mujoco
import numpy as np
import pinocchio

path, values = sys.argv[1], np.array(json.loads(sys.argv[2]))
model = mujoco.MjModel.from_xml_path(path)
data = mujoco.MjData(model)
data.qpos[:] = values
mujoco.mj_kinematics(model, data)
other = pinocchio.buildModelFromMJCF(path)
state = other.createData()
pinocchio.framesForwardKinematics(other, state, values)
pose = state.oMf[other.getFrameId("b", pinocchio.FrameType.BODY)]
assert np.abs(pose.translation - data.xpos[1]).max() < 1e-12
assert np.abs(pose.rotation - data.xmat[1].reshape(3, 3)).max() < 1e-12
print(json.dumps([data.xpos[1].tolist(), data.xmat[1].tolist()]))
CHECK
cat >"$folder/check.py" <<'CHECK'
import json
import math
import subprocess
import sys

import numpy as np
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant

HINGES = '<joint name="first" axis="0 0 1"/>', '<joint name="second" axis="1 0 0"/>'
SLIDES = '<joint name="first" type="slide" axis="0 1 0"/>', '<joint name="second" type="slide" axis="0 1 0"/>'
CASES = {"hinge": HINGES[:1], "hinge, hinge": HINGES, "hinge, slide": (HINGES[0], SLIDES[1]),
         "slide, hinge": (SLIDES[0], HINGES[1])}
path = sys.argv[1] + "/body.xml"


def in_drake(values):
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModels(path)
    plant.Finalize()
    context = plant.CreateDefaultContext()
    plant.SetPositions(context, values)
    pose = plant.GetFrameByName("b").CalcPoseInWorld(context)
    return pose.translation(), pose.rotation().matrix().ravel()


def in_others(values):
    command = [sys.executable, sys.argv[1] + "/mujoco_and_pinocchio.py", path, json.dumps(values)]
    return [np.array(part) for part in json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)]


def text(point):
    return "(" + ", ".join(f"{x + 0.0:.3f}" for x in point) + ")"


off = {}
for name, joints in CASES.items():
    with open(path, "w") as file:
        file.write(f'<mujoco model="m"><worldbody><body name="b" pos="1 0 0">{"".join(joints)}'
                   '<inertial pos="0.5 0 0" mass="1" diaginertia="0.1 0.1 0.1"/></body></worldbody></mujoco>')
    at_zero, values = [0.0] * len(joints), [0.7, 0.3][:len(joints)]
    assert np.abs(in_drake(at_zero)[0] - in_others(at_zero)[0]).max() < 1e-12
    (drake, turned), (others, matrix) = in_drake(values), in_others(values)
    off[name] = drake - others
    print(f"{name}: mujoco {text(others)}, pinocchio the same, drake {text(drake)}")
    assert np.abs(turned - matrix).max() < 1e-12
ARC = np.array([math.cos(0.7) - 1, math.sin(0.7), 0.0])
for name, difference in off.items():
    assert np.abs(difference - (ARC if name in ("hinge, hinge", "hinge, slide") else 0.0)).max() < 1e-12
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder" 2>"$folder/err"
[[ ! -s $folder/err ]]
