#!/usr/bin/env bash
# mechanism 1.1.10, kinematics of linkages and cams: a cam that is sized for a follower, and its saved coordinates.
#
# Behaviour: the saved profile is the base circle plus the lift, in polar coordinates, for each follower. It is the path
# of a pointed follower. A cam with a rise of 20 mm that is sized for a flat follower with a smallest radius of 10 mm
# lifts the follower by 9.7 mm where the motion law has 4.8 mm, and the profile is hollow, where a flat follower bridges
# it. A roller of 8 mm, for which the cam is sized too, is off by 1.5 mm.
#
# A fair guess: the profile is the envelope of the follower, so the follower moves by the motion law, and the smallest
# radius of curvature is the one that was asked for.
#
# Source: the README announces coordinates of profiles for roller and flat followers that can be machined. Below an
# animation it calls the displacement of a roller a result of its contact with the cam.
#
# Seen:
#   flat follower: lift 9.66 mm in place of 4.79 mm at 43.3 degrees
#   radius of curvature: asked 10.0 mm, analysis 10.0 mm, profile hollow with 290.8 mm
#   roller: largest error of the lift 1.52 mm
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet mechanism==1.1.10 numpy==2.4.6 scipy==1.17.1 matplotlib==3.11.2
cat >"$folder/check.py" <<'CHECK'
import sys

import numpy as np
from mechanism import Cam

RADIUS, SMALLEST, KIND = 8, 10, "cycloidal"
cam = Cam(motion=[("Rise", 20, 120), ("Dwell", 60), ("Fall", 20, 120), ("Dwell", 60)], degrees=True, omega=1.0)
angles, law = cam.thetas, cam.cycloidal.S


def saved(base):
    """The saved coordinates of the profile, as complex numbers."""
    path = f"{sys.argv[1]}/profile.csv"
    cam.save_coordinates(path, kind=KIND, base=base)
    table = np.genfromtxt(path, delimiter=",", names=True)
    return table["x"] + 1j * table["y"]


def lifts(profile, height):
    """The lift over the angle of the cam: the largest height of a follower on a point, less the first."""
    found = np.array([max(height(profile * np.exp(1j * angle))) for angle in angles])
    return found - found[0]


def on_a_roller(points):
    near = points[(np.abs(points.imag) < RADIUS) & (points.real > 0)]
    return near.real + np.sqrt(RADIUS**2 - near.imag**2)


analysis = cam.get_base_circle(kind=KIND, follower="flat", desired_min_rho=SMALLEST)
profile = saved(analysis["Rb"])
flat = lifts(profile, lambda points: points.real)
index = int(np.argmax(np.abs(flat - law)))
print(f"flat follower: lift {flat[index]:.2f} mm in place of {law[index]:.2f} mm "
      f"at {np.degrees(angles[index]):.1f} degrees")
assert abs(flat[index] - law[index] - 4.87) < 0.01

# The profile is saved against the direction of rotation, so its curvature is negative where it is convex.
first = np.gradient(profile, angles)
curvature = -(np.conj(first) * np.gradient(first, angles)).imag / np.abs(first) ** 3
hollow = curvature[3:-3].min()
print(f"radius of curvature: asked {SMALLEST:.1f} mm, analysis {analysis['rhos'].min():.1f} mm, "
      f"profile hollow with {-1 / hollow:.1f} mm")
assert abs(analysis["rhos"].min() - SMALLEST) < 1e-6 and abs(-1 / hollow - 290.8) < 1

analysis = cam.get_base_circle(kind=KIND, follower="roller", roller_radius=RADIUS, max_pressure_angle=30)
error = np.abs(lifts(saved(analysis["Rb"]), on_a_roller) - law).max()
print(f"roller: largest error of the lift {error:.2f} mm")
assert abs(error - 1.52) < 0.01
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
