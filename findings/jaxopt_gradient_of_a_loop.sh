#!/usr/bin/env bash
# jaxopt 0.8.5 with jax 0.10.2: the derivative of a closed loop by the implicit function theorem.
#
# Behaviour: the derivative of a root depends on the unit of length. A slider-crank with a crank of 0.5 m and a rod of
# 1.2 m turns its rod by -0.2404 rad per rad of the crank in metres, and by -0.0879 in millimetres. The position is
# right to the last digits in both, and so is the derivative of the slider. Near the dead point of a parallelogram, at
# 1e-5 rad, the derivatives of its angles are -0.4 and 0.2, not 0 and 1. Numbers are in double precision, and nothing
# is printed. The linear system is solved by conjugate gradients on the normal equations, which stop at 1e-5 of the
# norm of the right side, whatever the `tol` of the root finder. A direct solver in `implicit_diff_solve` gives the
# derivative to all digits.
#
# Guess before: the derivative is as good as the root, as the linear system has two unknowns.
#
# Source: jaxopt/_src/implicit_diff.py takes `linear_solve.solve_normal_cg` where no solver is given; the page on
# implicit differentiation names no accuracy.
#
# Seen:
#   slider-crank in m: -0.240386 -0.521874, exact -0.240386 -0.521874
#   slider-crank in mm: -0.087906 -521.874213, exact -0.240386 -521.874213
#   parallelogram at 1e-05 rad: -0.400000 0.200000, exact 0 1
#   direct solver: slider-crank in mm -0.240386 -521.874213; parallelogram 0.000000 1.000000
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet jaxopt==0.8.5 jax==0.10.2 jaxlib==0.10.2 scipy==1.17.1 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import jax
import jax.numpy as jnp
import jaxopt
import numpy as np

jax.config.update("jax_enable_x64", True)


def direct(product, right):
    return jnp.linalg.solve(jax.jacobian(product)(right), right)


def derivative(closure, start, phi, solver=None):
    """The largest gap at the root, and the derivatives of its coordinates by the angle of the crank."""
    finder = jaxopt.ScipyRootFinding(
        method="hybr", optimality_fun=closure, tol=1e-13, implicit_diff_solve=solver)
    start = jnp.array(start)
    root = finder.run(start, phi).params
    rates = jax.jacrev(lambda angle: finder.run(start, angle).params)(phi)
    return float(jnp.abs(closure(root, phi)).max()), np.asarray(rates)


def slider_crank(crank, rod, phi=1.0):
    """The closure, the pose and the derivatives from the formula."""
    theta = -math.asin(crank * math.sin(phi) / rod)
    rate = -crank * math.cos(phi) / (rod * math.cos(theta))
    pose = [theta, crank * math.cos(phi) + rod * math.cos(theta)]
    rates = [rate, -crank * math.sin(phi) - rod * math.sin(theta) * rate]
    return lambda q, angle: jnp.array([
        crank * jnp.cos(angle) + rod * jnp.cos(q[0]) - q[1],
        crank * jnp.sin(angle) + rod * jnp.sin(q[0])]), pose, np.array(rates)


def parallelogram(q, angle):
    return jnp.array([jnp.cos(angle) + 2 * jnp.cos(q[0]) - 2 - jnp.cos(q[1]),
                      jnp.sin(angle) + 2 * jnp.sin(q[0]) - jnp.sin(q[1])])


def line(rates):
    return " ".join(f"{rate:.6f}" for rate in rates)


off = {}
for unit, scale in (("m", 1.0), ("mm", 1000.0)):
    closure, pose, exact = slider_crank(0.5 * scale, 1.2 * scale)
    gap, rates = derivative(closure, pose, 1.0)
    print(f"slider-crank in {unit}: {line(rates)}, exact {line(exact)}")
    off[unit] = abs(rates[0] - exact[0])
    assert gap < 1e-12 * scale and abs(rates[1] / exact[1] - 1) < 1e-3
PHI = 1e-5
gap, rates = derivative(parallelogram, [0.0, PHI], PHI)
print(f"parallelogram at {PHI} rad: {line(rates)}, exact 0 1")
assert gap < 1e-12 and np.abs(rates - (0, 1)).max() > 0.1
by_solver = derivative(closure, pose, 1.0, direct)[1], derivative(parallelogram, [0.0, PHI], PHI, direct)[1]
print(f"direct solver: slider-crank in mm {line(by_solver[0])}; parallelogram {line(by_solver[1])}")
assert off["m"] < 1e-6 and off["mm"] > 0.1
assert np.allclose(by_solver[0], exact, rtol=1e-9) and np.allclose(by_solver[1], (0, 1), atol=1e-6)
CHECK
"$folder/env/bin/python" "$folder/check.py"
