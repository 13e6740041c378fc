#!/usr/bin/env bash
# dartpy 6.20.0 (DART): a load on the wheel of a gear pair, which a URDF describes by a mimic joint.
#
# Behaviour: the wheel follows its pinion, and the pinion carries no load. A pinion at 1 rad/s whose wheel is held back
# by 0.5 Nm keeps its speed for ever, and one whose wheel is driven too. With the inertias of 1 kg m^2 and a ratio of 2
# it would be at 0.8 rad/s after one second. The work of the load, 1 J, disappears. Nothing is printed about it.
#
# Guess before: the load slows both wheels down, by its torque times the ratio over both inertias.
#
# Source: the URDF page of `joint` has `mimic` as a relation of both values. DART's loader gives the follower the
# actuator type MIMIC; `setUseCouplerConstraint` of a joint, for a coupling in both directions, is off.
#
# Seen after 1 s, from 1 rad/s at the pinion:
#   ratio 2, no load: pinion 1.000, wheel 2.000, exact 1.000 and 2.000
#   ratio 2, load -0.5 Nm: pinion 1.000, wheel 2.000, exact 0.800 and 1.600
#   ratio -1, load 0.5 Nm: pinion 1.000, wheel -1.000, exact 0.750 and -0.750
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile dartpy==6.20.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import sys

import dartpy

LINK = ('<link name="{0}_link"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
        '</inertial></link><joint name="{0}" type="continuous"><parent link="world"/><child link="{0}_link"/>'
        '<axis xyz="0 0 1"/>{1}</joint>')
STEP, STEPS = 0.001, 1000
path = sys.argv[1] + "/gears.urdf"

for ratio, load in ((2, 0.0), (2, -0.5), (-1, 0.5)):
    with open(path, "w") as file:
        file.write('<robot name="gears"><link name="world"/>' + LINK.format("pinion", "")
                   + LINK.format("wheel", f'<mimic joint="pinion" multiplier="{ratio}"/>') + "</robot>")
    gears = dartpy.utils.DartLoader().parseSkeleton(path)
    world = dartpy.simulation.World()
    world.setGravity([0, 0, 0])
    world.setTimeStep(STEP)
    world.addSkeleton(gears)
    pinion, wheel = gears.getDof("pinion"), gears.getDof("wheel")
    pinion.setVelocity(1.0)
    wheel.setVelocity(ratio)
    for _ in range(STEPS):
        gears.getBodyNode("wheel_link").addExtTorque([0, 0, load])
        world.step()
    exact = 1 + STEP * STEPS * load * ratio / (1 + ratio**2)
    name = f"load {load} Nm" if load else "no load"
    print(f"ratio {ratio}, {name}: pinion {pinion.getVelocity():.3f}, wheel {wheel.getVelocity():.3f}, "
          f"exact {exact:.3f} and {ratio * exact:.3f}")
    assert abs(pinion.getVelocity() - 1) < 1e-9 and abs(wheel.getVelocity() - ratio) < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder" 2>&1 | grep -E '^ratio|Error'
