"""pybullet: a point-to-point constraint between two multibodies, step of 1/240 s, which is the default."""

import math
import pathlib
import tempfile

import pybullet as bullet

from measures import change_points, report, second_turn, unreachable
from mechanisms import RPM, exact, rod

STEP = 1.0 / 240.0


def urdf(path, links):
    """Writes links, each (name, place on the one before in mm, length in mm), as a chain from a fixed base."""
    text = '<robot name="r"><link name="base"><inertial><mass value="1"/>'
    text += '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    parent = "base"
    for name, x, length in links:
        mass, inertia = rod(length)
        text += f"""<link name="{name}"><inertial><origin xyz="{length / 2000} 0 0"/><mass value="{mass!r}"/>
          <inertia ixx="{inertia!r}" iyy="{inertia!r}" izz="{inertia!r}" ixy="0" ixz="0" iyz="0"/></inertial></link>
          <joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{name}"/>
          <origin xyz="{x / 1000} 0 0"/><axis xyz="0 0 1"/></joint>"""
        parent = name
    path.write_text(text + "</robot>")
    return bullet.loadURDF(str(path), useFixedBase=True, flags=bullet.URDF_USE_INERTIA_FROM_FILE)


class Simulation:
    def __init__(self, bar, step, rpm, phi, strong):
        bullet.resetSimulation()
        bullet.setTimeStep(step)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            self.chain = urdf(folder / "chain.urdf", [("crank", 0, bar.crank), ("coupler", bar.crank, bar.coupler)])
            self.rocker = urdf(folder / "rocker.urdf", [("rocker", bar.frame, bar.rocker)])
        start = exact(bar, phi)
        speed = rpm * math.pi / 30
        theta, psi = float(start.theta), float(start.psi)
        places = [(self.chain, 0, phi, speed),
                  (self.chain, 1, theta - phi, speed * float(start.theta_1 - 1)),
                  (self.rocker, 0, psi, speed * float(start.psi_1))]
        for body, joint, angle, rate in places:
            bullet.resetJointState(body, joint, angle, rate)
            bullet.changeDynamics(body, joint, linearDamping=0, angularDamping=0, jointDamping=0)
            bullet.setJointMotorControl2(body, joint, bullet.VELOCITY_CONTROL, force=0)
        bullet.setJointMotorControl2(self.chain, 0, bullet.VELOCITY_CONTROL, targetVelocity=speed,
                                     force=1000.0 if strong else 0.01)
        # Frames of a constraint are measured from the centre of mass.
        self.ends = (self.chain, 1, bar.coupler / 2000), (self.rocker, 0, bar.rocker / 2000)
        bullet.createConstraint(self.chain, 1, self.rocker, 0, bullet.JOINT_POINT2POINT, [0, 0, 1],
                                [self.ends[0][2], 0, 0], [self.ends[1][2], 0, 0])

    def advance(self):
        bullet.stepSimulation()

    def angles(self):
        return bullet.getJointState(self.chain, 0)[0], bullet.getJointState(self.rocker, 0)[0]

    def pins(self):
        found = []
        for body, joint, x in self.ends:
            state = bullet.getLinkState(body, joint, computeForwardKinematics=True)
            place, _ = bullet.multiplyTransforms(state[0], state[1], [x, 0, 0], [0, 0, 0, 1])
            found.append((1000 * place[0], 1000 * place[1]))
        return found


def main():
    bullet.connect(bullet.DIRECT)
    by_speed = {rpm: second_turn(Simulation, STEP, rpm) for rpm in (6.0, 60.0, 300.0)}
    by_step = {step: second_turn(Simulation, step) for step in (1 / 960, 1 / 240)}
    strong, weak = unreachable(Simulation, STEP, True), unreachable(Simulation, STEP, False)
    report("pybullet", step=STEP, gap=by_speed[RPM], by_speed=by_speed, by_step=by_step,
           changes=change_points(Simulation, STEP), strong=strong, weak=weak)


if __name__ == "__main__":
    main()
