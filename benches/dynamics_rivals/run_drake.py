"""Drake: a discrete multibody plant whose loops are ball constraints, over its time steps."""

import numpy as np
from pydrake.math import RigidTransform
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import (
    FixedOffsetFrame,
    LinearSpringDamper,
    PrismaticJoint,
    RevoluteJoint,
    RotationalInertia,
    SpatialInertia,
)
from pydrake.systems.analysis import Simulator

from measures import report, sweep
from problems import PROBLEMS

STEPS = [1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6, 1e-6, 5e-7, 2e-7]


def place(point):
    return np.array([*point, 0.0])


def build(problem, step):
    plant = MultibodyPlant(step)
    plant.SetUseSampledOutputPorts(False)
    plant.mutable_gravity_field().set_gravity_vector([0, -problem.gravity, 0])
    bodies, joints = [], []
    for body in problem.bodies:
        inertia = SpatialInertia.MakeFromCentralInertia(
            body.mass, place(body.centre), RotationalInertia(*3 * [body.inertia]))
        bodies.append(plant.AddRigidBody(body.name, inertia))
        parent = plant.world_body() if body.parent < 0 else bodies[body.parent]
        frame = plant.AddFrame(FixedOffsetFrame(
            body.name + "_at", parent.body_frame(), RigidTransform(place(body.pivot))))
        kind, axis = (PrismaticJoint, [1, 0, 0]) if body.slides else (RevoluteJoint, [0, 0, 1])
        joints.append(plant.AddJoint(kind(body.name, frame, bodies[-1].body_frame(), axis)))
    for first, point, second, other in problem.closures:
        plant.AddBallConstraint(bodies[first], place(point), bodies[second], place(other))
    if problem.spring:
        body, point, fixed, stiffness, free = problem.spring
        plant.AddForceElement(LinearSpringDamper(
            plant.world_body(), place(fixed), bodies[body], place(point), free, stiffness, 0.0))
    plant.AddJointActuator("motor", joints[0])
    plant.Finalize()
    return plant, joints


def prepare(problem, step):
    plant, joints = build(problem, step)
    simulator = Simulator(plant)
    context = simulator.get_mutable_context()
    positions, speeds = map(problem.relative, problem.start())
    plant.get_actuation_input_port().FixValue(context, [problem.torque])

    def run():
        context.SetTime(0.0)
        for joint, body, position, speed in zip(joints, problem.bodies, positions, speeds):
            if body.slides:
                joint.set_translation(context, position)
                joint.set_translation_rate(context, speed)
            else:
                joint.set_angle(context, position)
                joint.set_angular_rate(context, speed)
        simulator.Initialize()
        simulator.AdvanceTo(problem.end)
        return joints[0].get_angle(context)

    return run


def main():
    rows = []
    for problem in PROBLEMS:
        steps = [step * problem.end / 0.03 for step in STEPS]
        rows += sweep(problem, "Drake, discrete", steps, lambda step: prepare(problem, step))
    report(rows, "drake")


if __name__ == "__main__":
    main()
