#!/usr/bin/env bash
# pylieg 0.2.5 (module pylie): the logarithm of a half turn, as of a lever that is folded back about its pin.
#
# Behaviour: the logarithm of an exact half turn is zero, about z as about a diagonal. A lever that turns about a pin at
# (1, 0) by half a turn has the logarithm of a translation by 2: half of it is a slide in place of a quarter of a turn,
# and its exponential is another pose. `SE2` is right for the same lever in the plane. Nothing is raised.
#
# Guess before: `exp(log(X))` is `X`, for a half turn as well, where two logarithms exist.
#
# Source: `SO3.log` in pylie/SO3.py, line 63, divides the difference of the matrix and its transpose, zero for a half
# turn, by the sine of the angle. The case of small angles has a branch of its own, and this one has none.
#
# Seen:
#   in space, half a turn: logarithm 0.000 0.000 0.000 2.000 0.000 0.000, pose again off by 2.000
#   in the plane, half a turn: logarithm 3.142 0.000 -3.142, pose again off by 0.000
#   about a diagonal, half a turn: logarithm 0.000 0.000 0.000, pose again off by 2.000
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile pylieg==0.2.5 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from pylie import SE2, SE3, SO3


def text(values):
    return " ".join(f"{value + 0.0:.3f}" for value in np.round(np.ravel(values), 9))


def error(group, pose):
    """Largest difference between a pose and the exponential of its logarithm."""
    return np.abs(group.exp(group.from_matrix(pose).log()).as_matrix() - pose).max()


half = np.diag([-1.0, -1.0, 1.0, 1.0])
half[0, 3] = 2.0
logarithm = SE3.from_matrix(half).log()
print(f"in space, half a turn: logarithm {text(logarithm)}, pose again off by {error(SE3, half):.3f}")
assert np.array_equal(logarithm, [0, 0, 0, 2, 0, 0]) and error(SE3, half) == 2

plane = np.array([[-1.0, 0.0, 2.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])
print(f"in the plane, half a turn: logarithm {text(SE2.from_matrix(plane).log())}, "
      f"pose again off by {error(SE2, plane):.3f}")
assert error(SE2, plane) < 1e-9

diagonal = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
print(f"about a diagonal, half a turn: logarithm {text(SO3.from_matrix(diagonal).log())}, "
      f"pose again off by {error(SO3, diagonal):.3f}")
assert error(SO3, diagonal) == 2
CHECK
"$folder/env/bin/python" "$folder/check.py"
