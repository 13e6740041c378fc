#!/usr/bin/env bash
# pin 4.1.0 (Pinocchio), `buildModelAndConstraintsFromMJCF`, compared with mujoco 4.0.0.
#
# Behaviour: of the equality constraints of an MJCF, `connect` and `weld` are read, with the residuals of MuJoCo. Those
# of the kinds `joint` and `tendon` are left out, and nothing is printed. Two jaws that a gear couples, as in grippers,
# are then two freedoms instead of one.
#
# Guess before: all kinds are read, or the file is refused; mimic joints exist in Pinocchio.
#
# Source: the documentation string of the function names a model and two lists of constraints, of points and of frames,
# and no kind that is left out. MuJoCo's XML reference has all four kinds under `equality`.
#
# Seen:
#   connect: MuJoCo 1 constraint, Pinocchio 1, largest difference of residuals 1.7e-16
#   weld: MuJoCo 1 constraint, Pinocchio 1, largest difference of residuals 1.1e-16
#   joint: MuJoCo 1 constraint, Pinocchio 0
#   tendon: MuJoCo 1 constraint, Pinocchio 0
#   printed: ''
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pin==4.1.0 mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import sys

import mujoco
import numpy as np
import pinocchio

INERTIA = '<inertial pos="0.5 0 0" mass="1" diaginertia="0.1 0.1 0.1"/>'
JAWS = "".join(f'<body name="{name}" pos="{x} 0 0"><joint name="{name}" axis="0 0 1"/>{INERTIA}</body>'
               for name, x in (("left", 0), ("right", 1)))
TENDON = ('<tendon><fixed name="both"><joint joint="left" coef="1"/><joint joint="right" coef="1"/></fixed></tendon>')
EQUALITIES = {
    "connect": '<connect body1="left" body2="right" anchor="0.5 0.5 0"/>',
    "weld": '<weld body1="left" body2="right"/>',
    "joint": '<joint joint1="right" joint2="left" polycoef="0 -1 0 0 0"/>',
    "tendon": '<tendon tendon1="both"/>',
}
TURNS = np.array([0.3, 0.2])


def position_gap(model, constraint):
    data = model.createData()
    pinocchio.forwardKinematics(model, data, TURNS)
    first = data.oMi[constraint.joint1_id] * constraint.joint1_placement
    second = data.oMi[constraint.joint2_id] * constraint.joint2_placement
    return first.translation - second.translation


for name, equality in EQUALITIES.items():
    path = f"{sys.argv[1]}/{name}.xml"
    with open(path, "w") as file:
        file.write(f'<mujoco model="jaws"><worldbody><body name="hand">{INERTIA}{JAWS}</body></worldbody>{TENDON}'
                   f"<equality>{equality}</equality></mujoco>")
    model = mujoco.MjModel.from_xml_path(path)
    data = mujoco.MjData(model)
    data.qpos[:] = TURNS
    mujoco.mj_forward(model, data)
    read, points, frames = pinocchio.buildModelAndConstraintsFromMJCF(path)
    constraints = list(points) + list(frames)
    line = f"{name}: MuJoCo {model.neq} constraint, Pinocchio {len(constraints)}"
    assert model.neq == 1 and data.ne > 0 and np.abs(data.efc_pos[:data.ne]).max() > 0.1 and read.nv == 2
    if constraints:
        difference = np.abs(position_gap(read, constraints[0]) - data.efc_pos[:3]).max()
        line += f", largest difference of residuals {difference:.1e}"
        assert difference < 1e-12
    print(line)
    assert len(constraints) == (1 if name in ("connect", "weld") else 0)
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder" >"$folder/out" 2>"$folder/err"
cat "$folder/out"
printf "printed: '%s'\n" "$(cat "$folder/err")"
[[ ! -s $folder/err && $(wc -l <"$folder/out") == 4 ]]
