#!/usr/bin/env bash
# mujoco 4.0.0: a four-bar that turns freely at 180 rpm, closed by a `connect` constraint, at default settings.
#
# Behaviour: without drive, load, damping and weight the energy of the mechanism grows by 13 % in 20 s, with the default
# integrator and step of 2 ms. With a step of 0.5 ms it falls by 35 %. `RK4` loses 39 % for both steps alike: the soft
# constraint takes the energy, so that no step is small enough. With a constraint as stiff as the step allows (`solref`
# of two steps, `solimp` 0.9999) RK4 keeps the energy to 0.01 %.
#
# Guess before: the energy falls a little, as constraints are soft and damped, and the loss goes to zero with the step.
#
# Source: the page "Computation" derives the constraint from a spring and a damper (`solref`), with a default time
# constant of 0.02 s, whatever the step.
#
# Seen: Euler, 2 ms: +12.6 %; Euler, 0.5 ms: -34.7 %; RK4, 2 ms: -39.4 %; RK4, 0.5 ms: -39.4 %
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet mujoco==4.0.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import mujoco
import numpy as np

CRANK, COUPLER, ROCKER, FRAME, SPEED = 0.05, 0.12, 0.1, 0.14, 6 * math.pi
GAP = FRAME - CRANK
# The crank is in line with the frame; coupler and rocker are the other sides of a triangle.
THETA = math.acos((COUPLER**2 + GAP**2 - ROCKER**2) / (2 * COUPLER * GAP))
PSI = math.atan2(COUPLER * math.sin(THETA), COUPLER * math.cos(THETA) - GAP)
MATRIX = [[-COUPLER * math.sin(THETA), ROCKER * math.sin(PSI)], [COUPLER * math.cos(THETA), -ROCKER * math.cos(PSI)]]
THETA_RATE, PSI_RATE = np.linalg.solve(MATRIX, [0.0, -CRANK * SPEED])


def body(x, angle, length, mass, site="", inner=""):
    moment = mass * length**2 / 12
    return (f'<body pos="{x} 0 0" euler="0 0 {angle!r}"><joint axis="0 0 1"/>{site}{inner}<inertial pos="{length / 2} 0 0" '
            f'mass="{mass}" diaginertia="{moment} {moment} {moment}"/></body>')


def gain(integrator, step, constraint=""):
    """Change of the energy in 20 s, as a part of it."""
    coupler = body(CRANK, THETA, COUPLER, 0.12, f'<site name="a" pos="{COUPLER} 0 0"/>')
    rocker = body(FRAME, PSI, ROCKER, 0.1, f'<site name="b" pos="{ROCKER} 0 0"/>')
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler angle="radian"/><option timestep="{step}" integrator="{integrator}" gravity="0 0 0">'
        f'<flag energy="enable"/></option><worldbody>{body(0, 0.0, CRANK, 0.5, "", coupler)}{rocker}</worldbody>'
        f'<equality><connect site1="a" site2="b" {constraint}/></equality></mujoco>')
    data = mujoco.MjData(model)
    data.qvel[:] = [SPEED, THETA_RATE - SPEED, PSI_RATE]
    mujoco.mj_forward(model, data)
    start = data.energy.sum()
    mujoco.mj_step(model, data, round(20 / step))
    mujoco.mj_forward(model, data)
    return data.energy.sum() / start - 1


found = {(name, step): gain(name, step) for name in ("Euler", "RK4") for step in (2e-3, 5e-4)}
for (name, step), value in found.items():
    print(f"{name}, {1000 * step:g} ms: {100 * value:+.1f} %")
stiff = gain("RK4", 5e-4, 'solref="0.001 1" solimp="0.9999 0.9999 0.001"')
print(f"RK4, 0.5 ms, stiff: {100 * stiff:+.3f} %")
assert found["Euler", 2e-3] > 0.05 and found["Euler", 5e-4] < -0.05
assert abs(found["RK4", 2e-3] / found["RK4", 5e-4] - 1) < 0.02 and found["RK4", 5e-4] < -0.05
assert abs(stiff) < 1e-3
CHECK
"$folder/env/bin/python" "$folder/check.py"
