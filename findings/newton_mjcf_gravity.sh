#!/usr/bin/env bash
# newton 1.8.0 (with warp-lang 1.19.0): the gravity of an MJCF model.
#
# Behaviour: the vector in `<option gravity="..."/>` is left out without a message; the model has 9.81 m/s2 along -z.
# So a four-bar that is drawn in the x-y plane, with gravity along -y, does not move, and a model for the moon falls
# as on earth. `<flag gravity="disable"/>` of the same element is read.
#
# Guess before: the vector is read, as `add_usd` of the same package reads that of a scene, and MuJoCo its file.
#
# Source: newton/_src/utils/import_mjcf.py: the importer looks for `gravity` in `flag` alone. ModelBuilder has the
# argument `gravity`.
#
# Seen:
#   MuJoCo: 0 -9.81 0 and 0 0 -1.62, without: 0
#   Newton: 0 0 -9.81 and 0 0 -9.81, without: 0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet newton==1.8.0 warp-lang==1.19.0 mujoco==4.0.0 numpy==2.4.6
export WARP_CACHE_PATH="$folder/cache"
cat >"$folder/check.py" <<'CHECK'
import mujoco
import newton
import numpy as np


def pendulum(option):
    return (f'<mujoco><option {option}</option><worldbody><body name="link"><joint name="pin" axis="0 0 1"/>'
            '<geom type="capsule" fromto="0 0 0 0.1 0 0" size="0.01"/></body></worldbody></mujoco>')


def in_newton(option):
    builder = newton.ModelBuilder()
    newton.solvers.SolverMuJoCo.register_custom_attributes(builder)
    builder.add_mjcf(pendulum(option))
    return builder.finalize(device="cpu").gravity.numpy().reshape(-1)


def in_mujoco(option):
    model = mujoco.MjModel.from_xml_string(pendulum(option))
    is_off = model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_GRAVITY
    return np.zeros(3) if is_off else model.opt.gravity


def show(name, read):
    plane, moon = read('gravity="0 -9.81 0">'), read('gravity="0 0 -1.62">')
    without = read('gravity="0 0 -1.62"><flag gravity="disable"/>')
    text = [" ".join(f"{x:.3g}" for x in vector + 0.0) for vector in (plane, moon)]
    print(f"{name}: {text[0]} and {text[1]}, without: {np.abs(without).max():g}")
    return plane, moon, without


plane, moon, without = show("MuJoCo", in_mujoco)
assert np.allclose(plane, [0, -9.81, 0]) and np.allclose(moon, [0, 0, -1.62]) and not without.any()
plane, moon, without = show("Newton", in_newton)
assert np.allclose(plane, [0, 0, -9.81]) and np.allclose(moon, plane) and not without.any()
CHECK
"$folder/env/bin/python" "$folder/check.py" 2>&1 | grep -E '^(MuJoCo|Newton):|Error'
