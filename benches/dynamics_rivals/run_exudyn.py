"""Exudyn: rigid bodies of the plane with revolute joints; two implicit solvers over their steps."""

import exudyn
import numpy as np
from exudyn.itemInterface import (
    LoadMassProportional,
    LoadTorqueVector,
    MarkerBodyMass,
    MarkerBodyPosition,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    NodePointGround,
    NodeRigidBody2D,
    ObjectConnectorCoordinate,
    ObjectConnectorSpringDamper,
    ObjectGround,
    ObjectJointRevolute2D,
    ObjectRigidBody2D,
)

from measures import report, sweep
from problems import PROBLEMS

COUNTS = [300, 1000, 3000, 10_000, 30_000, 100_000, 300_000]
SOLVERS = {
    "generalized alpha": exudyn.DynamicSolverType.GeneralizedAlpha,
    "trapezoidal, index 2": exudyn.DynamicSolverType.TrapezoidalIndex2,
}


def build(problem):
    """The system, and the node of the first body."""
    container = exudyn.SystemContainer()
    system = container.AddSystem()
    positions, speeds = problem.start()
    frames = problem.frames(positions)
    # Rates of the origins of all frames.
    step = 1e-30
    rates = [frame[0].imag / step for frame in problem.frames(positions + 1j * step * speeds)]
    ground = system.AddObject(ObjectGround())
    zero = system.AddMarker(MarkerNodeCoordinate(nodeNumber=system.AddNode(NodePointGround()), coordinate=0))
    nodes, objects = [], []
    for body, (origin, axes), rate, angle, speed in zip(problem.bodies, frames, rates, positions, speeds):
        angle, speed = (0.0, 0.0) if body.slides else (angle, speed)
        arm = axes @ np.array(body.centre)
        velocity = rate + speed * np.array([-arm[1], arm[0]])
        nodes.append(system.AddNode(NodeRigidBody2D(
            referenceCoordinates=[*(origin + arm), angle], initialVelocities=[*velocity, speed])))
        objects.append(system.AddObject(ObjectRigidBody2D(
            physicsMass=body.mass, physicsInertia=body.inertia, nodeNumber=nodes[-1])))
        if problem.gravity:
            marker = system.AddMarker(MarkerBodyMass(bodyNumber=objects[-1]))
            system.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=[0, -problem.gravity, 0]))

    def marker(index, point):
        if index < 0:
            return system.AddMarker(MarkerBodyPosition(bodyNumber=ground, localPosition=[*point, 0]))
        local = np.array(point) - np.array(problem.bodies[index].centre)
        return system.AddMarker(MarkerBodyPosition(bodyNumber=objects[index], localPosition=[*local, 0]))

    for index, body in enumerate(problem.bodies):
        if body.slides:
            for coordinate in (1, 2):
                held = system.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[index], coordinate=coordinate))
                system.AddObject(ObjectConnectorCoordinate(markerNumbers=[zero, held]))
        else:
            pins = [marker(body.parent, body.pivot), marker(index, (0.0, 0.0))]
            system.AddObject(ObjectJointRevolute2D(markerNumbers=pins))
    for first, point, second, other in problem.closures:
        system.AddObject(ObjectJointRevolute2D(markerNumbers=[marker(first, point), marker(second, other)]))
    if problem.torque:
        rigid = system.AddMarker(MarkerBodyRigid(bodyNumber=objects[0], localPosition=[0, 0, 0]))
        system.AddLoad(LoadTorqueVector(markerNumber=rigid, loadVector=[0, 0, problem.torque]))
    if problem.spring:
        body, point, fixed, stiffness, free = problem.spring
        system.AddObject(ObjectConnectorSpringDamper(
            markerNumbers=[marker(-1, fixed), marker(body, point)], referenceLength=free, stiffness=stiffness))
    system.Assemble()
    return container, system, nodes[0]


def prepare(problem, count, solver):
    settings = exudyn.SimulationSettings()
    settings.timeIntegration.endTime = problem.end
    settings.timeIntegration.numberOfSteps = count
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.newton.useModifiedNewton = True
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    settings.solutionSettings.writeSolutionToFile = False
    settings.linearSolverType = exudyn.LinearSolverType.EigenDense
    container, system, node = build(problem)
    first = float(problem.start()[0][0])

    def run():
        # The initial state stays; only the current one is integrated.
        system.SolveDynamic(settings, solverType=solver)
        return first + float(system.GetNodeOutput(node, exudyn.OutputVariableType.Coordinates)[2])

    run.keep = container
    return run


def main():
    rows = []
    for problem in PROBLEMS:
        for name, solver in SOLVERS.items():
            rows += sweep(problem, f"Exudyn, {name}", COUNTS, lambda count: prepare(problem, count, solver))
    report(rows, "exudyn")


if __name__ == "__main__":
    main()
