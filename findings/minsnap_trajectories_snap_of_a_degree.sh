#!/usr/bin/env bash
# minsnap-trajectories 0.3.0: the least snap of a motion over three places, by the degree of its polynomials.
#
# Behaviour: the integral of the squared snap of the default algorithm, "closed-form", grows with the degree: 441 for
# degree 6, 566 for 7, 863 for 8 and 1363 for 9, with three continuous orders. The "constrained" algorithm falls from
# 435 to 416 and stays there. Both motions have the same places, are at rest at their ends and are continuous up to
# the acceleration. At degree 5 both are equal, as there is nothing to choose. Nothing is raised or warned of.
#
# Guess before: equal values of both algorithms, which fall with the degree, as a polynomial of degree 6 is one of
# degree 7.
#
# Source: the docstring of `generate_trajectory` has `idx_minimized_orders` as the orders to minimize, and both
# algorithms as ways to do it. `_solve_closed_form` in minimum_snap.py takes the coefficients of each piece from the
# derivatives at its ends by `lstsq`: more coefficients than these are those of least squares, not those of least
# snap.
#
# Seen:
#   degree 5: closed-form 511.1, constrained 511.1
#   degree 6: closed-form 441.1, constrained 435.2
#   degree 7: closed-form 566.1, constrained 416.1
#   degree 8: closed-form 863.0, constrained 416.1
#   degree 9: closed-form 1362.5, constrained 416.1
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile minsnap-trajectories==0.3.0 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import minsnap_trajectories as minsnap
import numpy as np

PLACES = [minsnap.Waypoint(0, [0.0]), minsnap.Waypoint(1, [1.0]), minsnap.Waypoint(3, [3.0])]
SNAP = 4
CLOSED = {5: 511.1, 6: 441.1, 7: 566.1, 8: 863.0, 9: 1362.5}
nodes, weights = np.polynomial.legendre.leggauss(20)


def snap(degree, algorithm):
    """Integral of the squared snap, exact for these polynomials."""
    motion = minsnap.generate_trajectory(PLACES, degree, idx_minimized_orders=SNAP, num_continuous_orders=3,
                                         algorithm=algorithm)
    before, after = (minsnap.compute_trajectory_derivatives(motion, [1 + step], 3) for step in (-1e-9, 1e-9))
    ends = minsnap.compute_trajectory_derivatives(motion, [0, 3], 3)[..., 0]
    assert np.allclose(before, after, atol=1e-5) and abs(after[0, 0, 0] - 1) < 1e-6
    assert np.allclose(ends, [[0, 3], [0, 0], [0, 0]], atol=1e-6)
    total = 0.0
    for duration, coefficients in zip(motion.durations, motion.coefficients[..., 0]):
        value = np.polynomial.Polynomial(coefficients).deriv(SNAP)
        total += weights @ value((nodes + 1) * duration / 2) ** 2 * duration / 2
    return total


least = np.inf
for degree, expected in CLOSED.items():
    closed, constrained = snap(degree, "closed-form"), snap(degree, "constrained")
    print(f"degree {degree}: closed-form {closed:.1f}, constrained {constrained:.1f}")
    assert abs(closed - expected) < 0.1 and constrained < least + 0.01
    least = constrained
CHECK
"$folder/env/bin/python" "$folder/check.py"
