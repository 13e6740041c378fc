#!/usr/bin/env bash
# mujoco 4.0.0: a four-bar closed by a `connect` constraint, at default constraint settings.
#
# Behaviour: the gap of the closed loop does not go to zero with the time step. From 2 ms to 0.5 ms it falls from 0.13
# to 0.047 mm, then it rises again, to 0.054 mm at 0.05 ms: the smallest step is not the best, and none closes the
# loop. The crank turns at 60 rpm without gravity or load.
#
# Guess before: the gap is an error of the integration and goes to zero with the step, as Drake's and DART's do.
#
# Source: the page "Computation" says that constraints are soft; the page "Modeling" (solver parameters) gives the
# default `solref` of 0.02 s, whatever the time step, and a `solimp` that starts at 0.9.
#
# Seen: 2 ms: 0.1307 mm; 0.5 ms: 0.0475 mm; 0.05 ms: 0.0544 mm
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import mujoco
import numpy as np

CRANK, COUPLER, ROCKER, FRAME = 0.05, 0.12, 0.1, 0.14
PHI, SPEED = math.radians(30.0), 2 * math.pi


def start():
    """Angles of coupler and rocker at `PHI`, and their angular velocities."""
    ax, ay = CRANK * math.cos(PHI), CRANK * math.sin(PHI)
    distance = math.hypot(FRAME - ax, ay)
    along = (distance**2 + COUPLER**2 - ROCKER**2) / (2 * distance)
    theta = math.atan2(-ay, FRAME - ax) + math.acos(along / COUPLER)
    x, y = ax + COUPLER * math.cos(theta), ay + COUPLER * math.sin(theta)
    psi = math.atan2(y, x - FRAME)
    sine = math.sin(theta - psi)
    pairs = (psi, COUPLER), (theta, ROCKER)
    return theta, psi, *(SPEED * CRANK * math.sin(other - PHI) / (length * sine) for other, length in pairs)


def link(name, x, turn, length, inner=""):
    mass = 1000 * math.pi * 0.004**2 * length
    inertia = mass * length**2 / 12
    return (f'<body name="{name}" pos="{x} 0 0" euler="0 0 {turn!r}"><joint name="{name}" axis="0 0 1"/>'
            f'<inertial pos="{length / 2} 0 0" mass="{mass}" diaginertia="{inertia} {inertia} {inertia}"/>'
            f'<site name="{name}" pos="{length} 0 0"/>{inner}</body>')


def gap(step):
    """The largest distance of the two sites in the second turn, in mm."""
    theta, psi, theta_1, psi_1 = start()
    coupler = link("coupler", CRANK, theta - PHI, COUPLER)
    bodies = link("crank", 0, PHI, CRANK, coupler) + link("rocker", FRAME, psi, ROCKER)
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler angle="radian"/><option timestep="{step}" integrator="implicitfast" gravity="0 0 0"/>'
        f'<worldbody>{bodies}</worldbody><equality><connect site1="coupler" site2="rocker"/></equality>'
        '<actuator><velocity joint="crank" kv="10"/></actuator></mujoco>')
    data = mujoco.MjData(model)
    data.qvel[:] = SPEED, theta_1 - SPEED, psi_1
    data.ctrl[0] = SPEED
    worst = 0.0
    for count in range(round(2.0 / step)):
        mujoco.mj_step(model, data)
        if count * step > 1.0:
            worst = max(worst, np.linalg.norm(data.site("coupler").xpos - data.site("rocker").xpos))
    return 1000 * worst


found = {step: gap(step) for step in (2e-3, 5e-4, 5e-5)}
for step, value in found.items():
    print(f"{1000 * step} ms: {value:.4f} mm")
assert found[2e-3] > 2 * found[5e-4] and found[5e-5] > 1.05 * found[5e-4] and found[5e-5] > 0.04
CHECK
"$folder/env/bin/python" "$folder/check.py"
