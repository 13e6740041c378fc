#!/usr/bin/env bash
# gcode-simulator 0.2.1, the time of a G-code program on a machine with two axes.
#
# Behaviour: on a machine whose Y axis is slower than its X axis, a diagonal takes less time than its Y part alone. With
# at most 6000 mm/min along X and 600 along Y, 100 mm along Y take 10.0 s and 100 mm along both axes 1.5 s: the speed of
# the path is the root of the sum of both squares, so that Y moves at 4264 mm/min. Arcs are left out: a half circle of
# 100 mm radius at 600 mm/min, which takes 31.4 s, adds nothing, and the path goes on from its beginning. So are words
# that keep the last G. There is no message. Machines with equal axes and lines alone are right.
#
# Guess before: an axis that needs 10 s on its own needs at least 10 s together with another, and an arc is a motion
# or an error.
#
# Source: the README has accurate times, for plotters and CNC machines and 3D printers, and the settings as the largest
# feed rates of the axes. gcode_simulator.py takes G0 and G1 for motions, and no other code.
#
# Seen:
#   100 mm along X: 1.12 s, along Y: 10.01 s, along both: 1.50 s
#   with equal axes: 1.12 s, 1.12 s, 1.13 s
#   there and back: 20.02 s, with a half circle between: 20.02 s, with the second G1 left out: 10.01 s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile gcode-simulator==0.2.1 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
from gcode_simulator import GCodeSimulator, GrblSettings


def duration(program, along_x=6000.0, along_y=6000.0):
    """Seconds of a program, for the largest feed rates of the axes in mm/min."""
    settings = GrblSettings(max_rate_x=along_x, max_rate_y=along_y, max_accel_x=800.0, max_accel_y=800.0)
    return GCodeSimulator(settings).estimate_time("G21\nG90\n" + program)[0]


MOVES = "G1 X100 Y0 F60000", "G1 X0 Y100 F60000", "G1 X100 Y100 F60000"
slow, equal = [[duration(move, 6000.0, rate) for move in MOVES] for rate in (600.0, 6000.0)]
print(f"100 mm along X: {slow[0]:.2f} s, along Y: {slow[1]:.2f} s, along both: {slow[2]:.2f} s")
print(f"with equal axes: {equal[0]:.2f} s, {equal[1]:.2f} s, {equal[2]:.2f} s")
assert slow[1] > 10 and slow[2] < 1.6 and equal[0] == equal[1] < equal[2]

plain = duration("G1 X100 Y0 F600\nG1 X0 Y0")
curved = duration("G1 X100 Y0 F600\nG3 X-100 Y0 I-100 J0\nG1 X0 Y0")
modal = duration("G1 X100 Y0 F600\nX0 Y0")
print(f"there and back: {plain:.2f} s, with a half circle between: {curved:.2f} s, "
      f"with the second G1 left out: {modal:.2f} s")
assert abs(plain - 20.02) < 0.01 and abs(curved - plain) < 0.01 and abs(modal - plain / 2) < 0.01
CHECK
"$folder/env/bin/python" "$folder/check.py"
