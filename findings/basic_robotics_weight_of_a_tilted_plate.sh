#!/usr/bin/env bash
# basic-robotics 1.0.2: the leg forces of a Stewart platform that holds its plate of 10 kg, for a wrench of zero.
#
# Behaviour: `carryMassCalc`, with the wrench in the global frame, returns forces whose sum is the weight for a level
# and for a tilted plate. `carryMassCalcBody`, with the wrench in the frame of the plate, returns forces that are
# along the normal of the plate: at a tilt of 0.2 rad their sum is 19.5 N sideways, and legs have 5.1 and 33.0 N in
# place of 18.0 and 20.5 N. A zero wrench is the same in both frames. Nothing is raised.
#
# Guess before: the same forces from both, as no load but the weight acts.
#
# Source: both docstrings have "given actuator masses, plate masses, and a wrench", and differ in the frame of the
# wrench. In kinematics/sp_model.py `carryMassCalcBody` adds the weight of the plate with the vector `grav`, which is
# global.
#
# Seen:
#   level: sum 0.0 0.0 -98.1, in the frame of the plate 0.0 0.0 -98.1
#   level: first and third leg -18.1 -18.1, in the frame of the plate -18.1 -18.1
#   tilted: sum 0.0 0.0 -98.1, in the frame of the plate -19.5 0.0 -96.1
#   tilted: first and third leg -18.0 -20.5, in the frame of the plate -5.1 -33.0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile basic-robotics==1.0.2 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from basic_robotics.general import fsr, tm
from basic_robotics.kinematics.sp_model import newSP

MASS = 10.0
# Radii, angles and thicknesses of both plates, masses of legs, of the top and of the bottom, limits of the legs.
platform = newSP(0.5, 0.3, 20, 20, 0.05, 0.05, 0.0, 0.0, MASS, 0.0, 0.1, 0.1, 0.3, 2.0, tm(), "platform")
NO_LOAD = fsr.makeWrench(tm(), 0.0, np.array([0.0, 0.0, -1.0]))


def text(force):
    return " ".join(f"{value + 0.0:.1f}" for value in np.round(force, 9))


for name, tilt in (("level", 0.0), ("tilted", 0.2)):
    platform.IK(top_plate_pos=tm([0, 0, 0.8, 0, tilt, 0]), protect=True)
    legs = platform.getTopJoints() - platform.getBottomJoints()
    legs /= np.linalg.norm(legs, axis=0)
    forces = [np.ravel(calculate(NO_LOAD.copy(), protect=True)[0])
              for calculate in (platform.carryMassCalc, platform.carryMassCalcBody)]
    sums = [legs @ force for force in forces]
    print(f"{name}: sum {text(sums[0])}, in the frame of the plate {text(sums[1])}")
    print(f"{name}: first and third leg {text(forces[0][[0, 2]])}, in the frame of the plate {text(forces[1][[0, 2]])}")
    weight = MASS * 9.81
    assert np.allclose(sums[0], [0, 0, -weight])
    assert np.allclose(sums[1], [-weight * np.sin(tilt), 0, -weight * np.cos(tilt)])
CHECK
"$folder/env/bin/python" "$folder/check.py"
