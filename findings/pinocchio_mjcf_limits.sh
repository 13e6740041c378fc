#!/usr/bin/env bash
# pin 4.1.0 (Pinocchio), `buildModelFromMJCF`: limits of joints, compared with mujoco 4.0.0 on the same file.
#
# Behaviour: the range of a slide is divided by 57.3, as if it were in degrees: a stroke from -1 to 2 m becomes one from
# -17 to 35 mm. With `angle="radian"` it is right. The reference value `ref` of a joint is subtracted from its limits,
# although coordinates include it: a hinge from -10 to 60 degrees with a `ref` of 30 has the limits -40 and 30, and at
# equal coordinates the bodies of both tools are at the same place. Nothing is printed.
#
# Guess before: coordinates and limits are those of MuJoCo, in metres and radians.
#
# Source: MuJoCo's XML reference has the unit of `range` by the kind of the joint, whatever the `angle` of the compiler,
# and `ref` as the value of the joint in the initial configuration. Limits are limits of the value.
#
# Seen, limits in MuJoCo and in Pinocchio:
#   slide: [-1, 2], [-0.0175, 0.0349]
#   slide, radian: [-1, 2], [-1, 2]
#   hinge: [-0.1745, 1.0472], [-0.1745, 1.0472]
#   hinge with ref: [-0.1745, 1.0472], [-0.6981, 0.5236]
#   slide with ref, radian: [-1, 2], [-1.3, 1.7]
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pin==4.1.0 mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math
import sys

import mujoco
import numpy as np
import pinocchio

VALUE = 0.7
CASES = {
    "slide": ("degree", 'type="slide" axis="0 1 0" range="-1 2"'),
    "slide, radian": ("radian", 'type="slide" axis="0 1 0" range="-1 2"'),
    "hinge": ("degree", 'axis="0 0 1" range="-10 60"'),
    "hinge with ref": ("degree", 'axis="0 0 1" range="-10 60" ref="30"'),
    "slide with ref, radian": ("radian", 'type="slide" axis="0 1 0" range="-1 2" ref="0.3"'),
}
path = sys.argv[1] + "/joint.xml"
seen = {}
for name, (unit, joint) in CASES.items():
    with open(path, "w") as file:
        file.write(f'<mujoco model="m"><compiler angle="{unit}"/><worldbody><body name="b"><joint name="j" {joint}/>'
                   '<inertial pos="0.5 0 0" mass="1" diaginertia="0.1 0.1 0.1"/></body></worldbody></mujoco>')
    model = mujoco.MjModel.from_xml_path(path)
    data = mujoco.MjData(model)
    data.qpos[0] = VALUE
    mujoco.mj_kinematics(model, data)
    other = pinocchio.buildModelFromMJCF(path)
    state = other.createData()
    pinocchio.framesForwardKinematics(other, state, np.array([VALUE]))
    pose = state.oMf[other.getFrameId("b", pinocchio.FrameType.BODY)]
    assert np.abs(pose.translation - data.xpos[1]).max() < 1e-12
    assert np.abs(pose.rotation - data.xmat[1].reshape(3, 3)).max() < 1e-12
    limits = model.jnt_range[0], np.array([other.lowerPositionLimit[0], other.upperPositionLimit[0]])
    seen[name] = limits
    print(f"{name}: {limits[0].round(4).tolist()}, {limits[1].round(4).tolist()}")
DEGREE = math.pi / 180
EXPECTED = {"slide": np.array([-1, 2]) * DEGREE, "slide, radian": [-1, 2], "hinge": np.array([-10, 60]) * DEGREE,
            "hinge with ref": np.array([-40, 30]) * DEGREE, "slide with ref, radian": [-1.3, 1.7]}
assert all(np.abs(seen[name][1] - limits).max() < 1e-9 for name, limits in EXPECTED.items())
assert all(np.abs(found[0] - (np.array([-10, 60]) * DEGREE if "hinge" in name else [-1, 2])).max() < 1e-9
           for name, found in seen.items())
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
