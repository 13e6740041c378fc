#!/usr/bin/env bash
# rod 0.5.0 and pybullet 3.2.7: an SDF whose joint has its axis in the frame of another link.
#
# Behaviour: `expressed_in` has no effect. A lid is mounted at 90 degrees to its base, with a hinge along the x axis of
# the base. In pybullet, and in the URDF that rod exports, it turns about the y axis of the base, as if the attribute
# were not there. No message is printed. The frames of poses are converted by rod.
#
# Guess before: rod, which parses the attribute and converts poses between frames, turns the axis as well.
#
# Source: SDF's page of `axis` has `expressed_in` as the name of the frame in which the unit vector is given. rod's
# `Xyz` has a field of that name, which no other line of the package reads; pybullet's library does not contain the
# word. Drake 1.51.1 turns the lid about x.
#
# Seen, for x by the frame of the joint and of the base, as the axis is in the base:
#   the joint: rod (0, 1, 0), pybullet (0, 1, 0)
#   the base: rod (0, 1, 0), pybullet (0, 1, 0)
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile pybullet==3.2.7 rod==0.5.0 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pybullet
import rod
from rod.urdf.exporter import UrdfExporter
from scipy.spatial.transform import Rotation

BODY = ("<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz>"
        "</inertia></inertial>")
LIMIT = "<limit><lower>-3</lower><upper>3</upper><effort>1</effort><velocity>1</velocity></limit>"
MOUNTED = "1 0 0 0 0 1.5707963267948966"


def write(path, attribute):
    with open(path, "w") as file:
        file.write(f'<sdf version="1.9"><model name="box"><link name="base">{BODY}</link>'
                   f'<link name="lid"><pose>{MOUNTED}</pose>{BODY}</link>'
                   '<joint name="hinge" type="revolute"><parent>base</parent><child>lid</child>'
                   f'<axis><xyz{attribute}>1 0 0</xyz>{LIMIT}</axis></joint></model></sdf>')


def by_rod(path):
    urdf = ET.fromstring(UrdfExporter().to_urdf_string(sdf=rod.Sdf.load(path)))
    [joint] = urdf.findall("joint[@name='hinge']")
    numbers = {name: np.array([float(part) for part in joint.find(name).get(key).split()])
               for name, key in (("origin", "rpy"), ("axis", "xyz"))}
    return Rotation.from_euler("xyz", numbers["origin"]).apply(numbers["axis"])


def by_pybullet(path):
    pybullet.connect(pybullet.DIRECT)
    [model] = pybullet.loadSDF(path)
    places = []
    for angle in (0.0, 1.0):
        pybullet.resetJointState(model, 0, angle)
        places.append(Rotation.from_quat(pybullet.getLinkState(model, 0, computeForwardKinematics=True)[5]))
    pybullet.disconnect()
    return (places[1] * places[0].inv()).as_rotvec()


READERS = {"rod": by_rod, "pybullet": by_pybullet}
for name, attribute in (("the joint", ""), ("the base", ' expressed_in="base"')):
    write(sys.argv[1], attribute)
    axes = {reader: read(sys.argv[1]) for reader, read in READERS.items()}
    shown = ", ".join(f"{reader} ({', '.join(f'{abs(part):.0f}' for part in axis)})" for reader, axis in axes.items())
    print(f"{name}: {shown}")
    for reader, axis in axes.items():
        assert np.allclose(axis, [0, 1, 0], atol=1e-6)
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder/box.sdf" 2>&1 | grep -oE '(the (joint|base):|[A-Z]\w*Error).*'
