#!/usr/bin/env bash
# mujoco 4.0.0: a crank whose pin slides in a slotted lever. The slot is a light block on a slide joint of the lever,
# and a `connect` constraint joins pin and block.
#
# Behaviour: the gap of the loop grows as the block becomes lighter, although nothing accelerates the block much. With
# a block of a hundredth of the lever's mass the pin is 0.2 mm off the slot, with a ten thousandth 3 mm, a seventh of
# the crank. A body that only joins two joints must therefore not be nearly massless.
#
# Guess before: a lighter block disturbs the motion less, so the lightest one that the compiler accepts is best.
#
# Source: the page "Computation" scales the regularisation of a constraint by an approximation of its inverse inertia
# at the initial position, so a light body makes the constraint soft for the heavy one, too. The XML reference says of
# `inertial/mass` that there is no reason to use massless bodies.
#
# Seen: block of 20 g: 0.034 mm; 2 g: 0.203 mm; 0.02 g: 3.05 mm (crank 20 mm, lever 200 g)
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import mujoco
import numpy as np

CRANK, DEPTH, PHI = 0.02, 0.05, math.radians(60.0)
X, Y = CRANK * math.cos(PHI), CRANK * math.sin(PHI)
LONG = math.hypot(X, Y + DEPTH)


def gap(mass):
    """The largest distance of pin and block in the first 0.8 s, in mm."""
    moment = 1e-4 * mass * LONG**2
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><compiler angle="radian"/><option gravity="0 0 0" timestep="2e-4"/><worldbody>'
        f'<body><joint name="crank"/><inertial pos="{X / 2} {Y / 2} 0" mass="0.1" diaginertia="4e-5 4e-5 4e-5"/>'
        f'<site name="pin" pos="{X} {Y} 0"/></body>'
        f'<body pos="0 {-DEPTH} 0"><joint/><inertial pos="0 0.04 0" mass="0.2" diaginertia="1.4e-4 1.4e-4 1.4e-4"/>'
        f'<body pos="{X} {Y + DEPTH} 0"><joint type="slide" axis="{X / LONG} {(Y + DEPTH) / LONG} 0"/>'
        f'<inertial pos="0 0 0" mass="{mass}" diaginertia="{moment} {moment} {moment}"/><site name="block"/></body>'
        '</body></worldbody><equality><connect site1="pin" site2="block"/></equality></mujoco>')
    data = mujoco.MjData(model)
    worst = 0.0
    for _ in range(4000):
        data.qfrc_applied[0] = 0.05 * (1 - data.qvel[0])
        mujoco.mj_step(model, data)
        worst = max(worst, np.linalg.norm(data.site("pin").xpos - data.site("block").xpos))
    return 1000 * worst


found = {mass: gap(mass) for mass in (2e-2, 2e-3, 2e-5)}
for mass, value in found.items():
    print(f"{1000 * mass:g} g: {value:.4f} mm")
assert found[2e-2] < found[2e-3] < found[2e-5] and found[2e-5] > 2.0 and found[2e-3] < 0.5
CHECK
"$folder/env/bin/python" "$folder/check.py"
