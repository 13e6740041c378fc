#!/usr/bin/env bash
# pybullet 3.2.7 and rod 0.5.0: an SDF of version 1.9 whose links are placed relative to each other.
#
# Behaviour: pybullet leaves `relative_to` out and takes each pose as one of the model. Three links, each 1 m from
# the one before, are all at 1 m, with their joints there too, so that the last link does not move when the second
# joint turns. The same file as a URDF, as rod exports it, has them at 1, 2 and 2.9 m in pybullet, and the last link
# moves on a circle of 1 m. The one line that is printed is about a missing world.
#
# Guess before: the poses of the specification, or an error for a version that the reader does not know.
#
# Source: SDF has `relative_to` since version 1.7, and its page of `link` has the frame of a pose by that attribute. The
# word does not occur in pybullet's library. Drake 1.51.1 places the links as the URDF has them.
#
# Seen, at zero, and the last link with the second joint at 1 rad:
#   by rod: link1 (1.00, 0.00), link2 (2.00, 0.00), link3 (2.88, 0.48), with the joint at 1 rad (2.07, 1.00)
#   directly: link1 (1.00, 0.00), link2 (1.00, 0.00), link3 (1.00, 0.00), with the joint at 1 rad (1.00, 0.00)
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile pybullet==3.2.7 rod==0.5.0 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import sys

import numpy as np
import pybullet
import rod
from rod.urdf.exporter import UrdfExporter

BODY = ("<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz>"
        "</inertia></inertial>")
AXIS = ("<axis><xyz>0 0 1</xyz><limit><lower>-3</lower><upper>3</upper><effort>1</effort><velocity>1</velocity>"
        "</limit></axis>")
NAMES = ("base", "link1", "link2", "link3")
POSES = ("1 0 0 0 0 0", "1 0 0 0 0 0.5", "1 0 0 0 0 0")


def chain():
    parts = [f'<link name="base">{BODY}</link>']
    for index, (parent, child, pose) in enumerate(zip(NAMES, NAMES[1:], POSES), 1):
        parts.append(f'<link name="{child}"><pose relative_to="{parent}">{pose}</pose>{BODY}</link>')
        parts.append(f'<joint name="joint{index}" type="revolute"><parent>{parent}</parent><child>{child}</child>'
                     f"{AXIS}</joint>")
    return f'<sdf version="1.9"><model name="chain">{"".join(parts)}</model></sdf>'


def places(load, angle):
    """Places of the links in the plane, with the second joint at an angle."""
    pybullet.connect(pybullet.DIRECT)
    model = load()
    infos = [pybullet.getJointInfo(model, index) for index in range(pybullet.getNumJoints(model))]
    assert tuple(info[12].decode() for info in infos) == NAMES[1:]
    pybullet.resetJointState(model, 1, angle)
    found = [pybullet.getLinkState(model, index, computeForwardKinematics=True)[4][:2] for index in range(3)]
    pybullet.disconnect()
    return np.array(found)


sdf, urdf = sys.argv[1] + "/chain.sdf", sys.argv[1] + "/chain.urdf"
for path, text in ((sdf, chain()), (urdf, UrdfExporter().to_urdf_string(sdf=rod.Sdf.load(chain())))):
    with open(path, "w") as file:
        file.write(text)
found = {}
for name, load in (("by rod", lambda: pybullet.loadURDF(urdf)), ("directly", lambda: pybullet.loadSDF(sdf)[0])):
    found[name] = np.round(np.vstack([places(load, 0.0), places(load, 1.0)[2]]), 6) + 0.0
    listed = ", ".join(f"{link} ({x:.2f}, {y:.2f})" for link, (x, y) in zip(NAMES[1:], found[name]))
    print(f"\n{name}: {listed}, with the joint at 1 rad ({found[name][3][0]:.2f}, {found[name][3][1]:.2f})")
arms = [np.array([2 + np.cos(angle), np.sin(angle)]) for angle in (0.5, 1.5)]
assert np.allclose(found["by rod"], [[1, 0], [2, 0], *arms], atol=1e-5)
assert np.allclose(found["directly"], [[1, 0]] * 4, atol=1e-5)
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder" 2>&1 | grep -E '^(by rod|directly):|Error'
