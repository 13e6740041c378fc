#!/usr/bin/env bash
# pyondsel 0.0.3 (OndselSolver, the engine of FreeCAD's Assembly): mechanisms that start at a dead point.
#
# Behaviour: a slider-crank that its piston drives from the dead centre comes apart: the piston moves 0.5 of its unit,
# crank and rod stay, and the joint between rod and piston has a gap of 0.5. A parallelogram that its crank drives from
# the row opens by 2 for a crank of 1. `solve()` returns both as trajectories, with all frames and without an
# error. Crank and slider that start elsewhere keep their joints to 1e-10, also beyond the dead point of the
# parallelogram. The start pose of each closes exactly.
#
# Guess before: the solver raises `SolveError` for a singular Jacobian, or follows one of the two branches.
#
# Source: the package's page promises `SolveError` if the "solver could not solve" the model. The planar loop has
# redundant equations in space, which the solver has to leave out; at a dead point one more is redundant, and it is
# missing in all later frames.
#
# Seen:
#   slider-crank from the dead centre: 10 frames, gap 0.5000
#   slider-crank from 0.5 rad: 10 frames, gap 0.0000
#   parallelogram from the row: 38 frames, gap 1.9974
#   parallelogram from 0.5 rad: 38 frames, gap 0.0000
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

ALONG_X = ((0, 0, 1), (0, 1, 0), (-1, 0, 0))
CRANK, ROD = 1.0, 3.0


def turned(angle):
    sine, cosine = math.sin(angle), math.cos(angle)
    return (cosine, -sine, 0), (sine, cosine, 0), (0, 0, 1)


def part(model, name, angle, position, length):
    """A bar from marker `a` to marker `b`; marker `s` has its z along the rail."""
    made = model.add_part(Part(name, position=position, rotation=turned(angle), moments_of_inertia=(0.01, 0.02, 0.02)))
    made.add_marker(Marker("a"))
    made.add_marker(Marker("b", position=(length, 0, 0)))
    made.add_marker(Marker("s", rotation=ALONG_X))


def revolutes(model, *pairs):
    for name, first, second in pairs:
        ends = [model.ground_path(end[1]) if end[0] == "ground" else model.part_path(*end) for end in (first, second)]
        model.add_joint(Joint(name, "revolute", *ends))


def end(path, length, frame):
    """The place of the far end of a bar."""
    matrix = rotation_matrix(path.bryant_angles[frame])
    return [path.positions[frame][axis] + matrix[axis][0] * length for axis in range(3)]


def largest_gap(trajectory, first, second):
    """Number of frames, and the largest distance of two ends that a joint holds together."""
    pairs = [[end(trajectory.parts["/R/" + name], length, frame) for name, length in (first, second)]
             for frame in range(len(trajectory.times))]
    return len(pairs), max(math.dist(*pair) for pair in pairs)


def slider_crank(phi):
    """The piston moves by 0.5 towards the crank within a second."""
    theta = -math.asin(CRANK * math.sin(phi) / ROD)
    pin = CRANK * math.cos(phi), CRANK * math.sin(phi), 0
    stroke = pin[0] + ROD * math.cos(theta)
    model = AsmtModel(name="R")
    model.add_ground_marker(Marker("o"))
    model.add_ground_marker(Marker("rail", rotation=ALONG_X))
    part(model, "crank", phi, (0, 0, 0), CRANK)
    part(model, "rod", theta, pin, ROD)
    part(model, "piston", 0.0, (stroke, 0, 0), 0.0)
    revolutes(model, ("main", ("ground", "o"), ("crank", "a")), ("pin", ("crank", "b"), ("rod", "a")),
              ("wrist", ("rod", "b"), ("piston", "a")))
    model.add_joint(Joint("bore", "translational", model.ground_path("rail"), model.part_path("piston", "s")))
    model.add_motion(Motion("push", "bore", f"{stroke!r} - 0.5*time", kind="translational"))
    model.simulation = Simulation(t_start=0.0, t_end=1.0, frames=9)
    return largest_gap(model.solve(), ("rod", ROD), ("piston", 0.0))


def parallelogram(phi):
    """The crank turns once within a second."""
    model = AsmtModel(name="R")
    model.add_ground_marker(Marker("o"))
    model.add_ground_marker(Marker("p", position=(2, 0, 0)))
    part(model, "crank", phi, (0, 0, 0), 1.0)
    part(model, "coupler", 0.0, (math.cos(phi), math.sin(phi), 0), 2.0)
    part(model, "rocker", phi, (2, 0, 0), 1.0)
    revolutes(model, ("main", ("ground", "o"), ("crank", "a")), ("pin", ("crank", "b"), ("coupler", "a")),
              ("far", ("coupler", "b"), ("rocker", "b")), ("base", ("ground", "p"), ("rocker", "a")))
    model.add_motion(Motion("spin", "main", f"{phi!r} + 2.0*pi*time"))
    model.simulation = Simulation(t_start=0.0, t_end=1.0, frames=37)
    return largest_gap(model.solve(), ("coupler", 2.0), ("rocker", 1.0))


for name, mechanism, singular in (("slider-crank", slider_crank, "the dead centre"),
                                  ("parallelogram", parallelogram, "the row")):
    frames, gap = mechanism(0.0)
    print(f"{name} from {singular}: {frames} frames, gap {gap:.4f}")
    usual, closed = mechanism(0.5)
    print(f"{name} from 0.5 rad: {usual} frames, gap {closed:.4f}")
    assert frames == usual and gap > 0.4 and closed < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py"
