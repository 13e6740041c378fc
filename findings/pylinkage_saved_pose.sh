#!/usr/bin/env bash
# pylinkage 1.3.0: a mechanism that is saved in the middle of its motion begins elsewhere when it is loaded.
#
# Behaviour: `mechanism_to_dict` stores the present positions of joints, and the `initial_angle` of the driver as it was
# at construction. `mechanism_from_dict` takes lengths from the positions and the crank from the angle. The first step
# of the loaded mechanism therefore leaves the saved positions: here from a crank at -32.4 degrees to one at 3.6 degrees
# instead of -28.8. No message is printed. The file has no lengths at all.
#
# Guess before: the angle in the file is that of the positions in the file, so that a loaded mechanism continues.
#
# Source: docstring of `mechanism_from_dict` ("deserialize a mechanism"), and the field `initial_angle`, which a reader
# takes for the angle of the drawing.
#
# Seen: saved at -32.4 degrees, first step after loading 3.6 degrees, continued -28.8 degrees; lengths in the file: none
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pylinkage==1.3.0
"$folder/env/bin/python" - <<'CHECK'
import json
import math

from pylinkage.mechanism import fourbar, mechanism_from_dict, mechanism_to_dict

mechanism = fourbar(crank=1, coupler=3, rocker=3, ground=4)
steps = mechanism.step()
for _ in range(91):
    next(steps)
saved = mechanism_to_dict(mechanism)
text = json.dumps(saved)
driver = next(link for link in saved["links"] if link["type"] == "driver")
tip = next(joint["position"] for joint in saved["joints"] if joint["id"] == driver["joints"][1])
drawn = math.degrees(math.atan2(tip[1], tip[0]))


def crank(positions):
    """The direction of the only joint that is 1 away from the motor."""
    x, y = next(p for p in positions if abs(math.hypot(*p) - 1) < 1e-9)
    return math.degrees(math.atan2(y, x))


loaded = crank(next(mechanism_from_dict(json.loads(text)).step()))
continued = crank(next(steps))
print(f"saved at {drawn:.1f} degrees, first step after loading {loaded:.1f}, continued {continued:.1f}")
assert driver["initial_angle"] == 0.0
assert abs(drawn + 32.4) < 1e-6 and abs(loaded - 3.6) < 1e-6 and abs(continued + 28.8) < 1e-6
assert "length" not in text and '"distance"' not in text
print("lengths in the file: none")
CHECK
