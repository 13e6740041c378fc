#!/usr/bin/env bash
# pyondsel 0.0.3 (OndselSolver, the engine of FreeCAD's Assembly): a crank that is driven out of its reach.
#
# Behaviour: `solve()` returns a trajectory that ends where the mechanism locks, without an error and without a mark. A
# four-bar of 50, 120, 60 and 140 mm that is asked for one turn has 15 frames, of the 38 that a crank-rocker has, and
# its last time is 0.378 of 1. The same holds for the other direction. All frames that are there are right.
#
# Guess before: `SolveError`, as the solver could not solve the model, or frames up to the end with an open loop.
#
# Source: the package's page: `Simulation(t_start, t_end, frames)` records that many samples over the span, "so the
# trajectory length is predictable"; `SolveError` is raised if the "solver could not solve".
#
# Seen:
#   four-bar (50, 120, 100, 140), 1.0 turns: 38 frames, last time 1.000, gap 7e-14
#   four-bar (50, 120, 60, 140), 1.0 turns: 15 frames, last time 0.378, gap 2e-10
#   four-bar (50, 120, 60, 140), -1.0 turns: 15 frames, last time 0.378, gap 2e-10
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet pyondsel==0.0.3
cat >"$folder/check.py" <<'CHECK'
import math

from pyondsel.asmt_solver import rotation_matrix
from pyondsel.model.asmt_model import AsmtModel
from pyondsel.model.joint import Joint
from pyondsel.model.marker import Marker
from pyondsel.model.motion import Motion
from pyondsel.model.part import Part
from pyondsel.model.simulation import Simulation


def solve(crank, coupler, rocker, frame, turns):
    """Number of frames, last time and largest gap of a crank that starts at 0 and turns so often within a second."""
    cosine = ((frame - crank) ** 2 + coupler**2 - rocker**2) / (2 * coupler * (frame - crank))
    theta = math.acos(cosine)
    end = crank + coupler * math.cos(theta), coupler * math.sin(theta)
    psi = math.atan2(end[1], end[0] - frame)
    model = AsmtModel(name="R")
    model.add_ground_marker(Marker("o"))
    model.add_ground_marker(Marker("p", position=(frame, 0, 0)))
    bars = {"crank": (0.0, 0.0, crank), "coupler": (theta, crank, coupler), "rocker": (psi, frame, rocker)}
    for name, (angle, x, length) in bars.items():
        sine, cosine = math.sin(angle), math.cos(angle)
        turned = (cosine, -sine, 0), (sine, cosine, 0), (0, 0, 1)
        part = model.add_part(Part(name, position=(x, 0, 0), rotation=turned, moments_of_inertia=(0.01, 0.02, 0.02)))
        part.add_marker(Marker("a"))
        part.add_marker(Marker("b", position=(length, 0, 0)))
    for name, first, second in (
            ("main", model.ground_path("o"), model.part_path("crank", "a")),
            ("pin", model.part_path("crank", "b"), model.part_path("coupler", "a")),
            ("far", model.part_path("coupler", "b"), model.part_path("rocker", "b")),
            ("base", model.ground_path("p"), model.part_path("rocker", "a"))):
        model.add_joint(Joint(name, "revolute", first, second))
    model.add_motion(Motion.constant_speed("spin", "main", turns_per_time=turns))
    model.simulation = Simulation(t_start=0.0, t_end=1.0, frames=37)
    found = model.solve()
    gap = 0.0
    for index in range(len(found.times)):
        ends = []
        for name in ("coupler", "rocker"):
            path = found.parts["/R/" + name]
            matrix = rotation_matrix(path.bryant_angles[index])
            ends.append([path.positions[index][axis] + matrix[axis][0] * bars[name][2] for axis in range(3)])
        gap = max(gap, math.dist(*ends))
    return len(found.times), found.times[-1], gap


rows = {}
for lengths, turns in (((50, 120, 100, 140), 1.0), ((50, 120, 60, 140), 1.0), ((50, 120, 60, 140), -1.0)):
    rows[lengths, turns] = frames, last, gap = solve(*lengths, turns)
    print(f"four-bar {lengths}, {turns} turns: {frames} frames, last time {last:.3f}, gap {gap:.0e}")
    assert gap < 1e-9
whole, cut, other = rows.values()
assert whole[0] == 38 and whole[1] > 0.999
assert cut[0] == other[0] == 15 and cut[1] < 0.4
CHECK
"$folder/env/bin/python" "$folder/check.py"
