#!/usr/bin/env bash
# sympy 1.14.0, `physics.mechanics.KanesMethod`: a four-bar with two dependent speeds, at a parallelogram.
#
# Behaviour: the equations divide by the height of the coupler, which a parallelogram has nowhere. With a coupler at
# 0 rad all accelerations are NaN, and numpy prints a warning. At 1e-16 rad, a rounding of zero, the crank accelerates
# by -2.88 rad/s2 instead of -5.96, without a warning. The velocities of the loop have a regular matrix there. With
# `constraint_solver="CRAMER"` both positions are right.
#
# Guess before: right accelerations wherever the matrix of the dependent speeds is regular, or an error, since the
# program that `lambdify` makes solves the equations with numbers.
#
# Source: the documentation string of `KanesMethod` names "LU" as the default `constraint_solver`, and its weakness as
# "zero division errors". A finite wrong number is not one. Pivots are chosen by the expressions, before there are
# numbers.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet sympy==1.14.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import warnings

import numpy as np
import sympy
from sympy.physics import mechanics

CRANK, COUPLER, FRAME, GRAVITY = 1.0, 2.0, 2.0, 9.81
angles, speeds = mechanics.dynamicsymbols("q1:4"), mechanics.dynamicsymbols("u1:4")
a, b, d, g = sympy.symbols("a b d g", positive=True)


def equations(**options):
    """Mass matrix and right side as a function of angles and speeds. Crank and rocker have the same length."""
    space, base = mechanics.ReferenceFrame("N"), mechanics.Point("O")
    base.set_vel(space, 0)
    frames = [space.orientnew(f"F{k}", "Axis", [angle, space.z]) for k, angle in enumerate(angles)]
    for frame, speed in zip(frames, speeds):
        frame.set_ang_vel(space, speed * space.z)
    crank_end = base.locatenew("A", a * frames[0].x)
    crank_end.set_vel(space, a * speeds[0] * frames[0].y)
    pivot = base.locatenew("D", d * space.x)
    pivot.set_vel(space, 0)
    gap = a * frames[0].x + b * frames[1].x - d * space.x - a * frames[2].x
    closure = [gap.dot(space.x), gap.dot(space.y)]
    rates = {angle.diff(): speed for angle, speed in zip(angles, speeds)}
    velocities = [part.diff(mechanics.dynamicsymbols._t).subs(rates) for part in closure]
    bodies, loads = [], []
    for k, (start, length) in enumerate(((base, a), (crank_end, b), (pivot, a))):
        centre = start.locatenew(f"G{k}", length / 2 * frames[k].x)
        centre.v2pt_theory(start, space, frames[k])
        inertia = mechanics.inertia(frames[k], 0, 0, length**3 / 12)
        bodies.append(mechanics.RigidBody(f"B{k}", centre, frames[k], length, (inertia, centre)))
        loads.append((centre, -length * g * space.y))
    kane = mechanics.KanesMethod(
        space, q_ind=angles[:1], u_ind=speeds[:1], q_dependent=angles[1:], u_dependent=speeds[1:],
        configuration_constraints=closure, velocity_constraints=velocities,
        kd_eqs=[angle.diff() - speed for angle, speed in zip(angles, speeds)], **options)
    kane.kanes_equations(bodies, loads)
    return sympy.lambdify([angles, speeds, a, b, d, g], [kane.mass_matrix_full, kane.forcing_full], cse=True)


def crank(program, coupler):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        matrix, right = program([1.0, coupler, 1.0], [1.0, 0.0, 1.0], CRANK, COUPLER, FRAME, GRAVITY)
    return np.linalg.solve(matrix, right)[3, 0]


# A parallelogram of rods with the mass 1 kg/m: two rods that turn, and one that moves as a point.
inertia, weight = 2 * CRANK**3 / 3 + COUPLER * CRANK**2, CRANK**2 + COUPLER * CRANK
exact = -GRAVITY * weight * np.cos(1.0) / inertia
default, cramer = equations(), equations(constraint_solver="CRAMER")
print("exact:", exact)
for coupler in (0.0, 1e-16, 1e-12):
    print(f"coupler at {coupler} rad: LU {crank(default, coupler)}, CRAMER {crank(cramer, coupler)}")
    assert abs(crank(cramer, coupler) - exact) < 1e-9
assert np.isnan(crank(default, 0.0)) and abs(crank(default, 1e-16) - exact) > 1.0
assert abs(crank(default, 1e-12) - exact) < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py"
