"""Pinocchio: forward dynamics with a rigid point constraint, Euler steps of 1 ms, no drive (the linkage runs freely).

Two settings of the constraint's stabilisation: gains of zero, which are the default, and Kp = 1e4, Kd = 200.
"""

import math

import numpy as np
import pinocchio

from measures import change_points, largest_gap, report, unreachable
from mechanisms import FOUR_BAR, RPM, START, exact, rod

STEP = 0.001


def place(x):
    return pinocchio.SE3(np.eye(3), np.array([x / 1000, 0.0, 0.0]))


class Simulation:
    GAINS = 0.0, 0.0

    def __init__(self, bar, step, rpm, phi, strong=False):
        model = pinocchio.Model()
        model.gravity.linear[:] = 0.0

        def link(name, parent, x, length):
            joint = model.addJoint(parent, pinocchio.JointModelRZ(), place(x), name)
            mass, inertia = rod(length)
            spatial = pinocchio.Inertia(mass, np.array([length / 2000, 0, 0]), np.diag([0.0, inertia, inertia]))
            model.appendBodyToJoint(joint, spatial, pinocchio.SE3.Identity())
            return joint

        crank = link("crank", 0, 0.0, bar.crank)
        coupler = link("coupler", crank, bar.crank, bar.coupler)
        rocker = link("rocker", 0, bar.frame, bar.rocker)
        pin = pinocchio.RigidConstraintModel(
            pinocchio.ContactType.CONTACT_3D, model, coupler, place(bar.coupler), rocker, place(bar.rocker),
            pinocchio.ReferenceFrame.LOCAL)
        pin.setBaumgarteCorrectorParameters(pinocchio.BaumgarteCorrectorParameters(*self.GAINS))
        self.model, self.data = model, model.createData()
        self.constraints = pinocchio.StdVec_RigidConstraintModel()
        self.constraints.append(pin)
        self.states = pinocchio.StdVec_RigidConstraintData()
        self.states.append(self.constraints[0].createData())
        pinocchio.initConstraintDynamics(model, self.data, self.constraints, self.states)
        # The third row of the constraint is satisfied by the plane: the system is singular without a proximal term.
        self.proximal = pinocchio.ProximalSettings(1e-12, 1e-12, 1e-8, 20)
        start, speed = exact(bar, phi), rpm * math.pi / 30
        self.q = np.array([phi, float(start.theta) - phi, float(start.psi)])
        self.v = speed * np.array([1.0, float(start.theta_1 - 1), float(start.psi_1)])
        self.step, self.tau = step, np.zeros(3)
        self.ends = (coupler, place(bar.coupler)), (rocker, place(bar.rocker))

    def advance(self):
        a = pinocchio.constraintDynamics(self.model, self.data, self.q, self.v, self.tau, self.constraints,
                                         self.states, self.proximal)
        self.v = self.v + self.step * a
        self.q = self.q + self.step * self.v

    def angles(self):
        return self.q[0], self.q[2]

    def pins(self):
        pinocchio.forwardKinematics(self.model, self.data, self.q)
        return [1000 * (self.data.oMi[joint] * end).translation[:2] for joint, end in self.ends]


class Stabilised(Simulation):
    GAINS = 1e4, 200.0


def after(simulation, seconds):
    for _ in range(round(seconds / simulation.step)):
        simulation.advance()
    (ax, ay), (bx, by) = simulation.pins()
    return math.hypot(ax - bx, ay - by)


def main():
    def gap(kind, step=STEP):
        return largest_gap(kind(FOUR_BAR, step, RPM, START), 2.0, 1.0)

    report("pin", step=STEP, gap=gap(Simulation), gap_stabilised=gap(Stabilised),
           after_10_s=after(Simulation(FOUR_BAR, STEP, RPM, START), 10.0),
           by_step={step: gap(Simulation, step) for step in (0.0001, 0.001)},
           changes=change_points(Stabilised, STEP), weak=unreachable(Stabilised, STEP, False))


if __name__ == "__main__":
    main()
