#!/usr/bin/env bash
# EAIK 1.2.2, `UrdfRobot`: the inverse kinematics of a URDF, for poses by urchin 0.0.30, with which it reads the file.
#
# Behaviour: a flange that is turned by 0.4 rad in its last joint has another orientation in EAIK, by this angle: the
# pose of EAIK has no rotation at zero of all joints. All eight solutions for the pose of urchin miss it, and are
# marked as exact. A slide in the place of the third joint is a hinge in EAIK: its value moves nothing by 0.5 m and
# turns by 0.5 rad. Without both the eight solutions are right. Nothing is raised or printed.
#
# Guess before: the pose of the last link as urchin has it, and an error for a slide.
#
# Source: the README has "Robot from a URDF file". `UrdfRobot` in eaik/IK_URDF.py passes the axes and the origins of
# all actuated joints, without their types, and a unit matrix as the rotation of the end.
#
# Seen, largest error of the solutions in an element of the pose:
#   straight flange: pose off by 0.000, 8 solutions, 8 exact, off by 0.000
#   turned flange: pose off by 0.322, 8 solutions, 8 exact, off by 0.371
#   slide: pose off by 0.469, third joint by 0.5: hinge turns 0.500 rad
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile eaik==1.2.2 urchin==0.0.30 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import sys

import numpy as np
from eaik.IK_URDF import UrdfRobot
from urchin import URDF

JOINT = ('<joint name="j{0}" type="{1}"><origin xyz="{2}" rpy="{3}"/><parent link="l{0}"/><child link="l{4}"/>'
         '<axis xyz="{5}"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>')
ORIGINS = ("0 0 0.4", "0.1 0 0.2", "0 0 0.5", "0.4 0 0", "0 0 0", "0 0 0")
AXES = ("0 0 1", "0 1 0", "0 1 0", "1 0 0", "0 1 0", "1 0 0")
VALUES = np.array([0.3, -0.4, 0.5, 0.2, 0.6, -0.7])


def read(third, flange):
    """The robot in EAIK, and its pose as a function of the joints in urchin."""
    path = sys.argv[1] + "/arm.urdf"
    with open(path, "w") as file:
        file.write('<robot name="arm">' + "".join(f'<link name="l{link}"/>' for link in range(7)))
        for joint, (origin, axis) in enumerate(zip(ORIGINS, AXES)):
            file.write(JOINT.format(joint, third if joint == 2 else "revolute", origin,
                                    flange if joint == 5 else "0 0 0", joint + 1, axis))
        file.write("</robot>")
    urdf = URDF.load(path)
    return UrdfRobot(path), lambda values: urdf.link_fk(cfg={f"j{joint}": value for joint, value in enumerate(values)},
                                                        link="l6")


def error(one, other):
    return np.abs(one - other).max()


for text, flange, expected in (("straight", "0 0 0", (0, 0)), ("turned", "0.4 0 0", (0.322, 0.371))):
    robot, pose = read("revolute", flange)
    goal = pose(VALUES)
    solutions = robot.IK(goal)
    exact = sum(not is_approximate for is_approximate in solutions.is_LS)
    found = error(robot.fwdKin(VALUES), goal), max(error(pose(values), goal) for values in solutions.Q)
    print(f"{text} flange: pose off by {found[0]:.3f}, {solutions.num_solutions()} solutions, {exact} exact, "
          f"off by {found[1]:.3f}")
    assert exact == solutions.num_solutions() == 8 and np.allclose(found, expected, atol=1e-3)

robot, pose = read("prismatic", "0 0 0")
moved = robot.fwdKin(np.array([0, 0, 0.5, 0, 0, 0]))
turn = np.arccos((np.trace(moved[:3, :3]) - 1) / 2)
off = error(robot.fwdKin(VALUES), pose(VALUES))
print(f"slide: pose off by {off:.3f}, third joint by 0.5: hinge turns {turn:.3f} rad")
assert off > 0.4 and abs(turn - 0.5) < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
