#!/usr/bin/env bash
# cadquery 2.8.0, `Assembly.solve` for a four-bar whose crank is turned out of its reach.
#
# Behaviour: `solve()` returns the assembly as for a solution, with each of the four joints open by 2.4 mm. A four-bar
# of 50, 120, 60 and 140 mm cannot close at a crank of 3 rad; its parts are placed with the missing 9.6 mm shared by
# the joints, and the crank at 2.998 rad. Nothing is raised or printed. In metres the solver even ends with
# `Solve_Succeeded`, as it does for a pose in reach, whose gap is below 1e-12.
#
# Guess before: an exception, as constraints of kind `Point` and `FixedRotation` cannot hold.
#
# Source: the documentation of assemblies calls the constraints solved numerically as an optimization problem, and names
# no way to ask if they hold; the status is in the private `_solve_result`.
#
# Seen:
#   in mm at 2.0 rad: crank 2.0000, largest gap 0.0000 mm, Solve_Succeeded
#   in mm at 3.0 rad: crank 2.9980, largest gap 2.4051 mm, Solved_To_Acceptable_Level
#   in m at 3.0 rad: crank 2.9995, largest gap 2.4070 mm, Solve_Succeeded
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet cadquery==2.8.0 cadquery-ocp==7.9.3.1.1 casadi==3.8.2 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import cadquery

START = 1.0


def poses(crank, coupler, rocker, frame):
    """Length, angle and pivot of each link in a closed pose, with the crank at `START`."""
    pin = crank * math.cos(START), crank * math.sin(START)
    distance = math.hypot(frame - pin[0], pin[1])
    inner = math.acos((coupler**2 + distance**2 - rocker**2) / (2 * coupler * distance))
    theta = math.atan2(-pin[1], frame - pin[0]) + inner
    end = pin[0] + coupler * math.cos(theta), pin[1] + coupler * math.sin(theta)
    psi = math.atan2(end[1], end[0] - frame)
    return {"frame": (frame, 0.0, (0.0, 0.0)), "crank": (crank, START, (0.0, 0.0)),
            "coupler": (coupler, theta, pin), "rocker": (rocker, psi, (frame, 0.0))}


def turn(lengths, phi):
    """Angle of the crank, largest gap of a joint and the status, after the crank is turned to `phi`."""
    links = poses(*lengths)
    assembly = cadquery.Assembly()
    for name, (length, angle, (x, y)) in links.items():
        middle = cadquery.Vector(x + length / 2 * math.cos(angle), y + length / 2 * math.sin(angle), 0)
        place = cadquery.Location(middle, cadquery.Vector(0, 0, 1), math.degrees(angle))
        assembly.add(cadquery.Workplane().box(length, 0.1, 0.1), name=name, loc=place)

    def end(name, sign):
        return cadquery.Vertex.makeVertex(sign * links[name][0] / 2, 0, 0)

    joints = ("frame", -1, "crank", -1), ("crank", 1, "coupler", -1), ("coupler", 1, "rocker", 1), \
        ("frame", 1, "rocker", -1)
    assembly.constrain("frame", "Fixed")
    for first, side, second, other in joints:
        assembly.constrain(first, end(first, side), second, end(second, other), "Point")
    for name in ("crank", "coupler", "rocker"):
        assembly.constrain(name + "@faces@>Z", "FixedAxis", (0, 0, 1))
    assembly.constrain("crank", "FixedRotation", (0, 0, math.degrees(phi)))
    assert assembly.solve() is assembly
    places = {name: assembly.objects[name].loc for name in links}

    def placed(name, sign):
        return end(name, sign).moved(places[name]).Center()

    gap = max((placed(first, side) - placed(second, other)).Length for first, side, second, other in joints)
    matrix = places["crank"].wrapped.Transformation()
    return math.atan2(matrix.Value(2, 1), matrix.Value(1, 1)), gap, assembly._solve_result["return_status"]


MILLIMETRES = (50.0, 120.0, 60.0, 140.0)
found = {}
for unit, scale in (("mm", 1.0), ("m", 1000.0)):
    for phi in (2.0, 3.0):
        crank, gap, status = turn([length / scale for length in MILLIMETRES], phi)
        found[unit, phi] = crank, gap * scale
        print(f"in {unit} at {phi} rad: crank {crank:.4f}, largest gap {gap * scale:.4f} mm, {status}")
for (unit, phi), (crank, gap) in found.items():
    assert abs(crank - phi) < 0.01
    assert gap < 1e-6 if phi == 2.0 else abs(gap - 2.4) < 0.02
CHECK
"$folder/env/bin/python" "$folder/check.py"
