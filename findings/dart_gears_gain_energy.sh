#!/usr/bin/env bash
# dartpy 6.20.0 (DART): a gear pair of a URDF that is coupled in both directions, by `setUseCouplerConstraint`.
#
# Behaviour: two equal wheels of a ratio of 2 that turn freely at 1 and 2 rad/s are at 5 and 0 rad/s after one step of
# 1 ms, at -15 and 10 after two, and at 65 and -30 after three. The energy grows with each step, up to numbers that
# overflow. At a ratio of 1 one of both wheels is at rest after each step. At a ratio of 1/2 the right speeds come back.
#
# Guess before: speeds that satisfy the ratio stay, as no load acts on the wheels.
#
# Source: the method is one of `Joint` and belongs to mimic joints. The result does not depend on the sign of the ratio,
# and is the same for steps of 0.1 ms.
#
# Seen, speeds of pinion and wheel after 0, 1, 2 and 3 steps:
#   ratio 2: 1.00 2.00, 5.00 0.00, -15.00 10.00, 65.00 -30.00; energy 2.5 J, then 2562.5 J
#   ratio 1: 1.00 1.00, 2.00 0.00, 0.00 2.00, 2.00 0.00; energy 1.0 J, then 2.0 J
#   ratio 0.5: 1.00 0.50, 1.25 0.00, 0.94 0.62, 1.02 0.47; energy 0.6 J, then 0.6 J
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
STEP, STEPS = 0.001, 3
path = sys.argv[1] + "/gears.urdf"

for ratio, last in ((2, (65, -30)), (1, (2, 0)), (0.5, (1.015625, 0.46875))):
    with open(path, "w") as file:
        file.write('<robot name="gears"><link name="world"/>' + LINK.format("pinion", "")
                   + LINK.format("wheel", f'<mimic joint="pinion" multiplier="{ratio}"/>') + "</robot>")
    gears = dartpy.utils.DartLoader().parseSkeleton(path)
    gears.getJoint("wheel").setUseCouplerConstraint(True)
    world = dartpy.simulation.World()
    world.setGravity([0, 0, 0])
    world.setTimeStep(STEP)
    world.addSkeleton(gears)
    pinion, wheel = gears.getDof("pinion"), gears.getDof("wheel")
    pinion.setVelocity(1.0)
    wheel.setVelocity(ratio)
    before, speeds = gears.computeKineticEnergy(), [(1.0, ratio)]
    for _ in range(STEPS):
        world.step()
        speeds.append((pinion.getVelocity(), wheel.getVelocity()))
    print(f"ratio {ratio}: " + ", ".join(f"{first:.2f} {second + 0.0:.2f}" for first, second in speeds)
          + f"; energy {before:.1f} J, then {gears.computeKineticEnergy():.1f} J")
    assert max(abs(found - value) for found, value in zip(speeds[-1], last)) < 1e-5
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder" 2>&1 | grep -E '^ratio|Error'
