#!/usr/bin/env bash
# gscrew 1.1.0: the power of a force on a crank, as the comoment of a coscrew and a screw, at two points of reference.
#
# Behaviour: a crank turns at 1 rad/s about the origin, and a force of 1 N across it acts at 2 m. `comoment` returns 0
# W if the twist is at the origin and the force at its own point, and 2 W if both are at one of these points, which is
# right. The sum and the product of screws bring the second operand to the point of the first: after `a + b` the
# object `b` has another point of reference and another moment. Nothing is raised.
#
# Guess before: 2 W, as a comoment does not depend on the point, and the operators take care of it.
#
# Source: `comoment` in gscrew/screw.py has no comparison of the points of reference, `__add__` and `__xor__` have it.
# `change_point` writes into the object and returns it, while its docstring has "Computes and returns".
#
# Seen:
#   twist at the origin, force at 2 m: 0.0 W
#   both at the origin: 2.0 W
#   both at 2 m: 2.0 W
#   moment of the force after a sum: 2.0 at the origin, before 0.0 at 2 m
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile gscrew==1.1.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
from gscrew.geometric_algebra import GeometricAlgebra
from gscrew.screw import CoScrew, Screw, comoment

blades = GeometricAlgebra(3).blades
one, x, y, turn = (blades[name] for name in ("s", "e1", "e2", "e12"))
ORIGIN, POINT = 0 * one, 2 * x


def power(point_of_twist, point_of_force):
    twist = CoScrew(ORIGIN, turn, 0 * one).change_point(point_of_twist)
    force = Screw(POINT, y, 0 * one).change_point(point_of_force)
    return number(comoment(twist, force), "s")


def number(multivector, blade):
    """Coefficient of one blade."""
    return float(str(multivector(0) if blade == "s" else (multivector * ~blades[blade])(0)))


for text, points, expected in (("twist at the origin, force at 2 m", (ORIGIN, POINT), 0.0),
                               ("both at the origin", (ORIGIN, ORIGIN), 2.0), ("both at 2 m", (POINT, POINT), 2.0)):
    found = power(*points)
    print(f"{text}: {found} W")
    assert found == expected

force = Screw(POINT, y, 0 * one)
before = number(force.moment, "e12")
Screw(ORIGIN, x, 0 * one) + force
after = number(force.moment, "e12")
print(f"moment of the force after a sum: {after} at the origin, before {before} at 2 m")
assert force.ref_point == ORIGIN and (before, after) == (0.0, 2.0)
CHECK
"$folder/env/bin/python" "$folder/check.py"
