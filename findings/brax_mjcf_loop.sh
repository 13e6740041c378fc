#!/usr/bin/env bash
# brax 0.14.2 with mujoco 4.0.0 and jax 0.10.2: an MJCF model of a four-bar that a `connect` closes.
#
# Behaviour: the loop is left out without a message. `brax.io.mjcf.loads` reads models with `connect`, `weld` and
# `joint` equalities, and its `generalized` pipeline simulates the open tree: under a torque on the crank the rocker
# stays at its angle, and the joint between coupler and rocker opens by 0.48 m in 0.8 s, for a crank of 0.5 m. The same
# model in MuJoCo keeps a gap of 0.1 mm, and its rocker moves.
#
# Guess before: an error, as for other parts of MJCF that these pipelines do not have, or the constraint.
#
# Source: brax/io/mjcf.py: `validate_model`, to check "if a MuJoCo model is compatible with brax physics pipelines",
# raises NotImplementedError for integrators, cones, actuators, `ref` and more; the file does not read an equality.
#
# Seen:
#   MuJoCo: crank 1.166, rocker 0.321 rad, gap 0.0001 m
#   brax: crank 1.306, rocker 0.000 rad, gap 0.4835 m
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet brax==0.14.2 jax==0.10.2 jaxlib==0.10.2 mujoco==4.0.0 mujoco-mjx==3.17.0 \
    numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import jax
import jax.numpy as jnp
import mujoco
import numpy as np
from brax.generalized import pipeline
from brax.io import mjcf

CRANK, COUPLER, ROCKER, FRAME, PHI, STEPS = 0.5, 1.2, 1.0, 1.4, math.pi / 6, 400
CONNECT = '<connect site1="end_coupler" site2="end_rocker"/>'
OTHERS = '<weld body1="coupler" body2="rocker"/>', '<joint joint1="rocker" joint2="crank" polycoef="0 0.5 0 0 0"/>'


def angles():
    """The angles of coupler and rocker in the closed pose at `PHI`."""
    pin = CRANK * math.cos(PHI), CRANK * math.sin(PHI)
    distance = math.hypot(FRAME - pin[0], pin[1])
    inner = math.acos((COUPLER**2 + distance**2 - ROCKER**2) / (2 * COUPLER * distance))
    theta = math.atan2(-pin[1], FRAME - pin[0]) + inner
    return theta, math.atan2(pin[1] + COUPLER * math.sin(theta), pin[0] + COUPLER * math.cos(theta) - FRAME)


THETA, PSI = angles()


def link(name, x, turn, length, inner=""):
    return (f'<body name="{name}" pos="{x} 0 0" euler="0 0 {turn!r}"><joint name="{name}" axis="0 0 1"/>'
            f'<geom type="capsule" fromto="0 0 0 {length} 0 0" size="0.02" contype="0" conaffinity="0"/>'
            f'<site name="end_{name}" pos="{length} 0 0"/>{inner}</body>')


def four_bar(equality):
    coupler = link("coupler", CRANK, THETA - PHI, COUPLER)
    bodies = link("crank", 0, PHI, CRANK, coupler) + link("rocker", FRAME, PSI, ROCKER)
    return ('<mujoco><compiler angle="radian"/><option timestep="0.002" gravity="0 0 0"/>'
            f'<worldbody>{bodies}</worldbody><equality>{equality}</equality>'
            '<actuator><motor joint="crank"/></actuator></mujoco>')


def gap(turned):
    """The distance of the ends of coupler and rocker, from the three joint coordinates."""
    phi, theta, psi = PHI + turned[0], THETA + turned[0] + turned[1], PSI + turned[2]
    return math.hypot(CRANK * math.cos(phi) + COUPLER * math.cos(theta) - FRAME - ROCKER * math.cos(psi),
                      CRANK * math.sin(phi) + COUPLER * math.sin(theta) - ROCKER * math.sin(psi))


def show(name, turned):
    print(f"{name}: crank {turned[0]:.3f}, rocker {turned[2]:.3f} rad, gap {gap(turned):.4f} m")
    return turned, gap(turned)


model = mujoco.MjModel.from_xml_string(four_bar(CONNECT))
data = mujoco.MjData(model)
data.ctrl[0] = 1.0
mujoco.mj_step(model, data, STEPS)
closed, closed_gap = show("MuJoCo", np.array(data.qpos))
for other in OTHERS:
    assert mjcf.loads(four_bar(other)).num_links() == 3
system = mjcf.loads(four_bar(CONNECT))
step = jax.jit(pipeline.step)
state = pipeline.init(system, system.init_q, jnp.zeros(system.qd_size()))
for _ in range(STEPS):
    state = step(system, state, jnp.array([1.0]))
opened, opened_gap = show("brax", np.array(state.q))
assert closed_gap < 1e-3 and abs(closed[2]) > 0.05
assert opened_gap > 0.2 and abs(opened[2]) < 1e-4
CHECK
"$folder/env/bin/python" "$folder/check.py" 2>&1 | grep -E '^(MuJoCo|brax):|Error'
