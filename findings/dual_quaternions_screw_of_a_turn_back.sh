#!/usr/bin/env bash
# dual_quaternions 0.4.0: the screw of a displacement, and the half of it, for turns to the right.
#
# Behaviour: a lid that is turned by -2 rad about (2, 1), with a stroke of 0.4 along that axis, has a screw whose axis
# goes through (-0.08, 2.23); made again from its screw, the displacement is another one. The half of it, `pow(0.5)`,
# done twice, is off by 1.8 units. Turns to the left by up to 3 rad and to the right by 1 rad are right. It is so where
# the quaternion of the matrix has a negative real part, which `from_homogeneous_matrix` returns for obtuse turns to the
# right, and for those to the left beyond half a turn. Nothing is raised.
#
# Guess before: `from_screw` of a `screw` is the displacement, as both signs of a dual quaternion are one displacement.
#
# Source: the documentation of `screw` has the coordinates of the screw's axis, its turn and its stroke, for each rigid
# displacement. It takes the angle in the range of half a turn to each side, and the direction from the quaternion, and
# the two have different signs here.
#
# Seen:
#   turn by 2 rad: axis through (2.00, 1.00), of its screw off by 0.000, two halves off by 0.000
#   turn by -1 rad: axis through (2.00, 1.00), of its screw off by 0.000, two halves off by 0.000
#   turn by -2 rad: axis through (-0.08, 2.23), of its screw off by 1.819, two halves off by 1.819
#   turn by 4 rad: axis through (0.55, 2.17), of its screw off by 1.514, two halves off by 1.514
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile dual_quaternions==0.4.0 pyquaternion==0.9.9 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from dual_quaternions import DualQuaternion

CENTRE, STROKE = np.array([2.0, 1.0, 0.0]), 0.4


def displacement(angle):
    """The matrix of a turn about the vertical axis through the centre, with a stroke along it."""
    matrix = np.eye(4)
    matrix[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    matrix[:3, 3] = CENTRE - matrix[:3, :3] @ CENTRE + [0, 0, STROKE]
    return matrix


for angle, right in ((2, True), (-1, True), (-2, False), (4, False)):
    matrix = displacement(angle)
    whole = DualQuaternion.from_homogeneous_matrix(matrix)
    assert np.allclose(whole.homogeneous_matrix(), matrix)
    direction, moment, turn, stroke = whole.screw()
    x, y, _ = np.cross(direction, moment) + 0.0
    again = DualQuaternion.from_screw(direction, moment, turn, stroke).homogeneous_matrix()
    half = whole.pow(0.5).homogeneous_matrix()
    off, off_twice = np.abs(again - matrix).max(), np.abs(half @ half - matrix).max()
    print(f"turn by {angle} rad: axis through ({x:.2f}, {y:.2f}), of its screw off by {off:.3f}, "
          f"two halves off by {off_twice:.3f}")
    assert np.allclose([x, y], CENTRE[:2]) == right
    assert (off < 1e-9 and off_twice < 1e-9) if right else (off > 1 and off_twice > 1)
CHECK
"$folder/env/bin/python" "$folder/check.py"
