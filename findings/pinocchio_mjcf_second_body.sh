#!/usr/bin/env bash
# pin 4.1.0 (Pinocchio), `buildModelFromMJCF`.
#
# Behaviour: of several bodies in `<worldbody>` only the first, with all that it carries, is read. A four-bar whose
# crank with coupler and whose rocker both start from the world has 3 joints in MuJoCo and 2 in Pinocchio; nothing is
# printed. `buildModelAndConstraintsFromMJCF` then raises "Model does not have any body named rocker". With both
# bodies in one fixed body, all is read, the constraint included.
#
# Guess before: all bodies are read, or the file is refused.
#
# Source: MuJoCo's XML reference describes `worldbody` as the root of the tree of bodies, without a limit to them.
# The documentation string of `buildModelFromMJCF` says that the file is parsed and a model returned.
#
# Seen: MuJoCo: 3 joints; Pinocchio: crank, coupler; in one fixed body: crank, coupler, rocker and 1 constraint
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


def body(name, x, turn, inner=""):
    return (f'<body name="{name}" pos="{x} 0 0" euler="0 0 {turn}"><joint name="{name}" axis="0 0 1"/>'
            f"{INERTIA}{inner}</body>")


chains = body("crank", 0, 60, body("coupler", 1, -60)) + body("rocker", 2, 60)


def write(name, content):
    path = f"{sys.argv[1]}/{name}.xml"
    with open(path, "w") as file:
        file.write(f'<mujoco model="m"><worldbody>{content}</worldbody><equality>'
                   '<connect body1="coupler" body2="rocker" anchor="2 0 0"/></equality></mujoco>')
    return path


two, one = write("two", chains), write("one", f'<body name="base">{INERTIA}{chains}</body>')
in_mujoco = mujoco.MjModel.from_xml_path(two).njnt
in_pinocchio = list(pinocchio.buildModelFromMJCF(two).names)[1:]
try:
    pinocchio.buildModelAndConstraintsFromMJCF(two)
    refusal = None
except ValueError as error:
    refusal = str(error)
model, constraints = pinocchio.buildModelAndConstraintsFromMJCF(one)[:2]
print("MuJoCo:", in_mujoco, "joints; Pinocchio:", in_pinocchio)
print("with constraints:", refusal)
print("in one fixed body:", list(model.names)[1:], len(constraints))
assert in_mujoco == 3 and in_pinocchio == ["crank", "coupler"] and "rocker" in refusal
assert list(model.names)[1:] == ["crank", "coupler", "rocker"] and len(constraints) == 1
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
