#!/usr/bin/env bash
# poekit 0.1.0, product of exponentials: twists with a pitch, as for a nut on a lead screw.
#
# Behaviour: `ExpMapping.exp_screw` leaves out the pitch of a twist. A nut with a lead of 5 mm per radian that turns by
# 2 rad stays where it is, and `ForwardKine.forward_kinematics_poe` with it. `TwistUtils.motion_2_twist` returns a
# pitch of 1 for a pure turn about an axis in z, -2 for one in x, and -0.29 for an oblique one. The axis is at the right
# point. The exponential leaves the pitch out and returns the right pose, so a test of one by the other passes.
#
# Guess before: the nut moves by 10 mm, and the twist of a turn has the pitch 0.
#
# Source: the docstring of `exp_screw` has the exponential of a twist and its magnitude, and `TwistUtils.twist_pitch`
# computes pitches. The term of the translation along the axis is missing in poekit/expmapping.py, and
# `w @ np.transpose(w)` in poekit/twist_utils.py is a number, 1, in place of the matrix of the axis.
#
# Seen:
#   nut: pitch 5.000, moved by 0.000 along the axis; as a chain 0.000
#   turn about z: pitch 1.000, point of the axis 2.000 1.000 0.000, pose again off by 0.000
#   turn about x: pitch -2.000, point of the axis 0.000 1.000 3.000, pose again off by 0.000
#   turn about an oblique axis: pitch -0.286, point of the axis -0.160 1.000 0.120, pose again off by 0.000
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile poekit==0.1.0 numpy==2.4.6 sympy==1.14.0
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from poekit import ExpMapping, ForwardKine, TwistUtils

POINT = np.array([2.0, 1.0, 3.0])


def turn(axis, angle):
    """The pose after a turn about an axis through the point."""
    cross = np.cross(np.eye(3), axis).T
    pose = np.eye(4)
    pose[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    pose[:3, 3] = POINT - pose[:3, :3] @ POINT
    return pose


nut = np.array([0.0, 0.0, 5.0, 0.0, 0.0, 1.0])
moved = ExpMapping.exp_screw(np.append(nut, 2.0))
chain = ForwardKine.forward_kinematics_poe(np.append(nut, 2.0).reshape(7, 1))
print(f"nut: pitch {TwistUtils.twist_pitch(nut):.3f}, moved by {moved[2, 3]:.3f} along the axis; "
      f"as a chain {chain[2, 3]:.3f}")
assert np.allclose(moved[:2, :2], [[np.cos(2), -np.sin(2)], [np.sin(2), np.cos(2)]])
assert moved[2, 3] == 0 and chain[2, 3] == 0 and TwistUtils.twist_pitch(nut) == 5
for name, axis, wrong in (("z", [0, 0, 1], 1.0), ("x", [1, 0, 0], -2.0), ("an oblique axis", [0.6, 0, 0.8], -2 / 7)):
    axis = np.array(axis, dtype=float)
    twist = TwistUtils.motion_2_twist(turn(axis, 0.5)).ravel()
    pitch, (_, point, _) = TwistUtils.twist_pitch(twist), TwistUtils.twist_2_joint(twist)
    error = np.abs(ExpMapping.exp_screw(np.append(twist, 0.5)) - turn(axis, 0.5)).max()
    print(f"turn about {name}: pitch {pitch:.3f}, point of the axis "
          + " ".join(f"{value + 0.0:.3f}" for value in np.round(point, 9)) + f", pose again off by {error:.3f}")
    assert abs(pitch - wrong) < 1e-6 and np.allclose(point, POINT - axis * (axis @ POINT)) and error < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py"
