"""Pinocchio: `constraintDynamics` of the closed loops, integrated by DOP853 of SciPy.

The time is that of the calls of `constraintDynamics` alone, without the integrator, which is slow in Python: a lower
bound for any program around it.
"""

import math
import time

import numpy as np
import pinocchio
from scipy.integrate import solve_ivp

from measures import report, sweep
from problems import PROBLEMS

TOLERANCES = [10.0 ** -digits for digits in range(3, 14)]
CALLS = 20_000


class Chains:
    def __init__(self, problem):
        self.problem = problem
        model = pinocchio.Model()
        model.gravity.linear = np.array([0.0, -problem.gravity, 0.0])

        def place(point):
            return pinocchio.SE3(np.eye(3), np.array([*point, 0.0]))

        self.joints = []
        for body in problem.bodies:
            parent = 0 if body.parent < 0 else self.joints[body.parent]
            kind = pinocchio.JointModelPX() if body.slides else pinocchio.JointModelRZ()
            joint = model.addJoint(parent, kind, place(body.pivot), body.name)
            inertia = pinocchio.Inertia(body.mass, np.array([*body.centre, 0.0]), body.inertia * np.eye(3))
            model.appendBodyToJoint(joint, inertia, pinocchio.SE3.Identity())
            self.joints.append(joint)
        self.constraints, self.states = pinocchio.StdVec_RigidConstraintModel(), pinocchio.StdVec_RigidConstraintData()
        for first, point, second, other in problem.closures:
            self.constraints.append(pinocchio.RigidConstraintModel(
                pinocchio.ContactType.CONTACT_3D, model, self.joints[first], place(point), self.joints[second],
                place(other), pinocchio.ReferenceFrame.LOCAL))
            self.states.append(self.constraints[len(self.states)].createData())
        self.model, self.data = model, model.createData()
        pinocchio.initConstraintDynamics(model, self.data, self.constraints, self.states)
        self.settings = pinocchio.ProximalSettings(1e-14, 1e-14, 1e-10, 10)
        # Joints are numbered depth first.
        self.places = [model.joints[joint].idx_q for joint in self.joints]

    def order(self, values):
        ordered = np.empty(len(values))
        ordered[self.places] = self.problem.relative(values)
        return ordered

    def accelerations(self, q, v):
        tau = np.zeros(self.model.nv)
        tau[self.places[0]] = self.problem.torque
        if self.problem.spring:
            body, point, fixed, stiffness, free = self.problem.spring
            angle, pivot = q[self.places[body]], np.array(self.problem.bodies[body].pivot)
            c, s = math.cos(angle), math.sin(angle)
            arm = np.array([c * point[0] - s * point[1], s * point[0] + c * point[1]])
            span = pivot + arm - np.array(fixed)
            length = math.hypot(*span)
            force = -stiffness * (1 - free / length) * span
            tau[self.places[body]] += arm[0] * force[1] - arm[1] * force[0]
        return pinocchio.constraintDynamics(
            self.model, self.data, q, v, tau, self.constraints, self.states, self.settings)

    def seconds_of_a_call(self):
        q, v = map(self.order, self.problem.start())
        tau, best = np.zeros(self.model.nv), math.inf
        call = pinocchio.constraintDynamics
        arguments = self.model, self.data, q, v, tau, self.constraints, self.states, self.settings
        for _ in range(5):
            start = time.thread_time()
            for _ in range(CALLS):
                call(*arguments)
            best = min(best, time.thread_time() - start)
        return best / CALLS


def rows_of(problem):
    chains = Chains(problem)
    call = chains.seconds_of_a_call()
    n = chains.model.nv
    start = np.concatenate([*map(chains.order, problem.start())])
    counts = {}

    def prepare(tolerance):
        def run():
            solved = solve_ivp(lambda _, y: np.concatenate([y[n:], chains.accelerations(y[:n], y[n:])]),
                               (0.0, problem.end), start, "DOP853", rtol=tolerance, atol=tolerance)
            assert solved.success
            counts[str(tolerance)] = solved.nfev
            return solved.y[chains.places[0], -1]

        return run

    rows = sweep(problem, "Pinocchio, DOP853 (its calls alone)", TOLERANCES, prepare)
    return [row | {"seconds": call * counts[row["setting"]]} for row in rows]


def main():
    report([row for problem in PROBLEMS for row in rows_of(problem)], "pin", "scipy")


if __name__ == "__main__":
    main()
