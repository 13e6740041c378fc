#!/usr/bin/env bash
# py-gearworks 0.0.24: the centre distance of two spur gears for a backlash, and the backlash at a distance.
#
# Behaviour: `calc_involute_mesh_distance` returns 60 mm for gears of module 2 with 20 and 40 teeth without backlash,
# which is right, and 60.43 mm for a backlash of 0.3 mm. `backlash_from_ax_distance`, its documented inverse,
# returns 8.43 and 8.73 mm at these distances for the same arguments, and 0.84 and 1.14 mm if the signs
# of both angles are changed. The differences of backlash are right, 0.3 mm. Nothing is raised.
#
# Guess before: 0 and 0.3 mm, as the inverse returns.
#
# Source: the docstring of `backlash_from_ax_distance` in gearmath.py has "Inverse of calc_involute_mesh_distance", and
# both have the same arguments. The angles at the base circle enter with other signs, and the term of the
# thickness counts once in place of twice.
#
# Seen:
#   distance 60.0000 for 0.0 mm: backlash 8.4253, with angles of the other sign 0.8403
#   distance 60.4274 for 0.3 mm: backlash 8.7253, with angles of the other sign 1.1403
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile numpy==2.4.6 scipy==1.17.1
"$folder/env/bin/pip" install --quiet --no-compile --no-deps py-gearworks==0.0.24 # its solids alone need build123d
cat >"$folder/check.py" <<'CHECK'
import importlib.metadata
import math
import sys
import types

package = types.ModuleType("py_gearworks")  # the package without the import of its solids
package.__path__ = [str(importlib.metadata.distribution("py-gearworks").locate_file("py_gearworks"))]
sys.modules["py_gearworks"] = package

from py_gearworks.gearmath import backlash_from_ax_distance, calc_involute_mesh_distance

TEETH, MODULE, PRESSURE = (20, 40), 2.0, math.radians(20)

bases = [MODULE * teeth / 2 * math.cos(PRESSURE) for teeth in TEETH]
# Half of the angle of a tooth at its base circle: a quarter of a pitch and the involute function.
halves = [math.pi / 2 / teeth + math.tan(PRESSURE) - PRESSURE for teeth in TEETH]
pitch = 2 * math.pi / TEETH[1]
for backlash, expected in ((0.0, 60.0), (0.3, 60.4274)):
    distance = calc_involute_mesh_distance(*bases, *halves, pitch, backlash=backlash)
    same = backlash_from_ax_distance(distance, *bases, *halves, pitch)
    other = backlash_from_ax_distance(distance, *bases, *(-half for half in halves), pitch)
    print(f"distance {distance:.4f} for {backlash} mm: backlash {same:.4f}, "
          f"with angles of the other sign {other:.4f}")
    assert abs(distance - expected) < 1e-4
    assert abs(same - backlash - 8.4253) < 1e-3 and abs(other - backlash - 0.8403) < 1e-3
CHECK
"$folder/env/bin/python" "$folder/check.py"
