"""DART: a ball joint constraint between two skeletons, servo joint for the strong drive, step of 1 ms."""

import math

import dartpy as dart
import numpy as np

from measures import change_points, report, second_turn, unreachable
from mechanisms import RPM, exact, rod

STEP = 0.001
# Torque of the weak drive, in N m.
WEAK = 0.01


def place(x):
    transform = dart.math.Isometry3()
    transform.set_translation([x / 1000, 0.0, 0.0])
    return transform


def link(skeleton, parent, name, x, length):
    properties = dart.dynamics.RevoluteJointProperties()
    properties.mName = name
    joint, body = skeleton.createRevoluteJointAndBodyNodePair(parent, properties)
    joint.setAxis([0.0, 0.0, 1.0])
    joint.setTransformFromParentBodyNode(place(x))
    mass, inertia = rod(length)
    body.setInertia(dart.dynamics.Inertia(mass, [length / 2000, 0, 0], np.diag([inertia] * 3)))
    return joint, body


class Simulation:
    def __init__(self, bar, step, rpm, phi, strong):
        world = dart.simulation.World()
        world.setGravity([0, 0, 0])
        world.setTimeStep(step)
        chain, other = dart.dynamics.Skeleton("chain"), dart.dynamics.Skeleton("rocker")
        crank, crank_body = link(chain, None, "crank", 0.0, bar.crank)
        coupler, coupler_body = link(chain, crank_body, "coupler", bar.crank, bar.coupler)
        rocker, rocker_body = link(other, None, "rocker", bar.frame, bar.rocker)
        world.addSkeleton(chain)
        world.addSkeleton(other)
        start = exact(bar, phi)
        self.speed = rpm * math.pi / 30
        angles = phi, float(start.theta) - phi, float(start.psi)
        rates = self.speed, self.speed * float(start.theta_1 - 1), self.speed * float(start.psi_1)
        for joint, angle, rate in zip((crank, coupler, rocker), angles, rates):
            joint.setPosition(0, angle)
            joint.setVelocity(0, rate)
        pin = [float(start.pin[0]) / 1000, float(start.pin[1]) / 1000, 0.0]
        constraint = dart.constraint.BallJointConstraint(coupler_body, rocker_body, pin)
        world.getConstraintSolver().addConstraint(constraint)
        if strong:
            crank.setActuatorType(dart.dynamics.ActuatorType.SERVO)
            crank.setForceLowerLimit(0, -1000.0)
            crank.setForceUpperLimit(0, 1000.0)
        self.strong, self.world, self.joints = strong, world, (crank, coupler, rocker)
        self.ends = (coupler_body, bar.coupler / 1000), (rocker_body, bar.rocker / 1000)

    def advance(self):
        crank = self.joints[0]
        if self.strong:
            crank.setCommand(0, self.speed)
        else:
            crank.setForce(0, math.copysign(WEAK, self.speed - crank.getVelocity(0)))
        self.world.step()

    def angles(self):
        return self.joints[0].getPosition(0), self.joints[2].getPosition(0)

    def pins(self):
        return [1000 * (body.getTransform().multiply([x, 0, 0]))[:2] for body, x in self.ends]


def main():
    by_speed = {rpm: second_turn(Simulation, STEP, rpm) for rpm in (6.0, 60.0, 300.0)}
    by_step = {step: second_turn(Simulation, step) for step in (0.0001, 0.001)}
    strong, weak = unreachable(Simulation, STEP, True), unreachable(Simulation, STEP, False)
    report("dartpy", step=STEP, gap=by_speed[RPM], by_speed=by_speed, by_step=by_step,
           changes=change_points(Simulation, STEP), strong=strong, weak=weak)


if __name__ == "__main__":
    main()
