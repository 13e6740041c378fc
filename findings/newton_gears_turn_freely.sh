#!/usr/bin/env bash
# newton 1.8.0 (with warp-lang 1.19.0) and mujoco 4.0.0: a gear pair, two hinges coupled by `<equality><joint/>`.
#
# Behaviour: the importer turns the coupling into a mimic constraint of the model, and warns of couplings that only
# one solver has, but not of this one. Featherstone's and the XPBD solver take the model without a message, and both
# wheels turn as if they were alone: after 0.2 s with a torque on the pinion the wheel is at -1/6 of its angle, where
# the ratio is -1/2.
#
# Guess before: the coupling, or a warning of the solver.
#
# Source: newton/_src/utils/import_mjcf.py: `mjc_add_equality_mimic`; the word "mimic" is not in
# newton/_src/solvers/featherstone and newton/_src/solvers/xpbd. The script runs the first of both, since each compiles
# for a minute.
#
# Seen:
#   MuJoCo: pinion 0.562, wheel -0.280 rad
#   Newton, 1 mimic constraint, 0 warnings: pinion 1.200, wheel -0.200 rad
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet newton==1.8.0 warp-lang==1.19.0 mujoco==4.0.0 numpy==2.4.6
export WARP_CACHE_PATH="$folder/cache"
cat >"$folder/check.py" <<'CHECK'
import warnings

import mujoco
import newton

STEP, STEPS, SPEEDS, TORQUE = 1e-3, 200, (2.0, -1.0), 1e-4
GEARS = ('<mujoco><option gravity="0 0 0" timestep="0.001"/><worldbody>'
         '<body name="pinion"><joint name="pinion" axis="0 0 1"/><geom type="cylinder" size="0.02 0.005"/></body>'
         '<body name="wheel" pos="0.06 0 0"><joint name="wheel" axis="0 0 1"/>'
         '<geom type="cylinder" size="0.04 0.005"/></body></worldbody>'
         '<contact><exclude body1="pinion" body2="wheel"/></contact>'
         '<equality><joint joint1="wheel" joint2="pinion" polycoef="0 -0.5 0 0 0"/></equality></mujoco>')


def in_mujoco():
    model = mujoco.MjModel.from_xml_string(GEARS)
    data = mujoco.MjData(model)
    data.qvel[:] = SPEEDS
    data.qfrc_applied[0] = TORQUE
    mujoco.mj_step(model, data, STEPS)
    return data.qpos


def in_newton():
    builder = newton.ModelBuilder(gravity=(0.0, 0.0, 0.0))
    newton.solvers.SolverMuJoCo.register_custom_attributes(builder)
    builder.add_mjcf(GEARS)
    model = builder.finalize(device="cpu")
    state, after, control = model.state(), model.state(), model.control()
    state.joint_qd.assign(SPEEDS)
    newton.eval_fk(model, state.joint_q, state.joint_qd, state)
    control.joint_f.assign([TORQUE, 0.0])
    solver = newton.solvers.SolverFeatherstone(model)
    for _ in range(STEPS):
        state.clear_forces()
        solver.step(state, after, control, None, STEP)
        state, after = after, state
    return model.constraint_mimic_count, state.joint_q.numpy()


pinion, wheel = in_mujoco()
print(f"MuJoCo: pinion {pinion:.3f}, wheel {wheel:.3f} rad")
assert abs(wheel + pinion / 2) < 0.01
with warnings.catch_warnings(record=True) as seen:
    warnings.simplefilter("always")
    count, (pinion, wheel) = in_newton()
print(f"Newton, {count} mimic constraint, {len(seen)} warnings: pinion {pinion:.3f}, wheel {wheel:.3f} rad")
assert count == 1 and not seen
assert abs(wheel + pinion / 6) < 0.01
CHECK
"$folder/env/bin/python" "$folder/check.py" 2>&1 | grep -E '^(MuJoCo|Newton)[:,]|Error'
