#!/usr/bin/env bash
# gcodeparser 0.3.0: codes with a point, lines without a command, and comments in parentheses, of RS274 (LinuxCNC).
#
# Behaviour: G91.1, relative centres of arcs, is read as G91, relative positions, so each later position of the
# program is a step. G38.2 Z-5 is G38 without Z, and G92.1, which clears offsets, is G92, which sets them. The `.1` is
# in no field. A line of coordinates alone, which repeats the last command, is left out. A command in a comment in
# parentheses is a motion, and the letters after it are its parameters. Nothing is raised.
#
# Guess before: the number 91.1 or a field for the part after the point, a motion, and a comment.
#
# Source: the pattern of a line in gcodeparser/__init__.py takes the digits after G, M or T, needs one of these
# letters, and begins comments with a semicolon. The reference of LinuxCNC has G90.1 and G91.1 as modes of arcs,
# comments in parentheses, and lines of axis words alone, which repeat the motion in force.
#
# Seen:
#   G21 G90 G91.1: G21 G90 G91
#   G1 X10 Y0 F300: G1 X10 Y0 F300
#   X10 Y5: nothing
#   (then G1 X99 at depth): G1 X99 A T D E P H
#   G92.1: G92
#   G38.2 Z-5 F50: G38
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile gcodeparser==0.3.0
cat >"$folder/check.py" <<'CHECK'
from gcodeparser import parse_gcode_lines

EXPECTED = {"G21 G90 G91.1": "G21 G90 G91", "G1 X10 Y0 F300": "G1 X10 Y0 F300", "X10 Y5": "nothing",
            "(then G1 X99 at depth)": "G1 X99 A T D E P H", "G92.1": "G92", "G38.2 Z-5 F50": "G38"}

lines = list(parse_gcode_lines("\n".join(EXPECTED)))
for index, (line, expected) in enumerate(EXPECTED.items()):
    found = [command.gcode_str for command in lines if command.line_index == index]
    text = " ".join(found) or "nothing"
    print(f"{line}: {text}")
    assert text == expected
CHECK
"$folder/env/bin/python" "$folder/check.py"
