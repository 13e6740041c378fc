#!/usr/bin/env bash
# truerig 0.1.1: an MJCF whose hinge is not at the origin of its body, as URDF, with the report of all changes.
#
# Behaviour: the frame of the crank is in its middle, 0.2 m from the pin, so its hinge has `pos="-0.2 0 0"`. The URDF
# of truerig has the joint at the frame: the crank turns about its own middle, and its end moves half as far. The
# report has the verdict PASS and no entry about the joint. MuJoCo 4.0.0 reads both files.
#
# Guess before: the same motion, with a joint at the pin and an offset after it, or an entry in the report.
#
# Source: the page of MJCF has "pos: Position of the joint, specified in the frame of the parent body". The joint has
# the place of its body as origin in truerig/frontends/mjcf.py, lines 131 and 146, and `jnt_pos` is not read. The
# package promises "a fidelity report of everything it changed".
#
# Seen, the end of the crank at 90 degrees:
#   MJCF: at 0.0 0.4
#   URDF: at 0.2 0.2
#   verdict: PASS   errors=0  warnings=0  notes=0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile truerig==0.1.1 mujoco==4.0.0 numpy==2.4.6 scipy==1.17.1
cat >"$folder/crank.xml" <<'MODEL'
<mujoco model="crank">
  <worldbody>
    <body name="base">
      <geom type="box" size="0.1 0.1 0.1" mass="1"/>
      <body name="crank" pos="0.2 0 0">
        <joint name="pin" type="hinge" axis="0 0 1" pos="-0.2 0 0" range="-180 180"/>
        <geom type="box" size="0.2 0.02 0.02" mass="1"/>
      </body>
    </body>
  </worldbody>
</mujoco>
MODEL
cat >"$folder/check.py" <<'CHECK'
import math
import sys

import mujoco
import numpy as np

for kind, file, expected in (("MJCF", "crank.xml", (0, 0.4)), ("URDF", "crank.urdf", (0.2, 0.2))):
    model = mujoco.MjModel.from_xml_path(f"{sys.argv[1]}/{file}")
    data = mujoco.MjData(model)
    data.joint("pin").qpos = math.pi / 2
    mujoco.mj_forward(model, data)
    crank = data.body("crank")
    end = crank.xpos + crank.xmat.reshape(3, 3) @ [0.2, 0, 0]
    print(f"{kind}: at {end[0] + 0.0:.1f} {end[1]:.1f}")
    assert np.allclose(end[:2], expected)
CHECK
cd "$folder"
env/bin/truerig convert crank.xml crank.urdf >report
env/bin/python check.py "$folder"
grep -o "verdict: PASS   errors=0  warnings=0  notes=0" report
