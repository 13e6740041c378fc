"""Exudyn: rigid bodies of the plane with revolute joints, a prescribed angle of the crank, generalized-alpha solver.

The integrator's step is 1 ms, everything else is at the default.
"""

import math

import exudyn
from exudyn.itemInterface import (
    MarkerBodyPosition,
    MarkerNodeCoordinate,
    NodePointGround,
    NodeRigidBody2D,
    ObjectConnectorCoordinate,
    ObjectGround,
    ObjectJointRevolute2D,
    ObjectRigidBody2D,
)

from measures import report
from mechanisms import (
    FOUR_BAR,
    PARALLELOGRAM,
    RPM,
    SHORT_ROCKER,
    START,
    away_from_change_point,
    exact,
    is_crossed,
    rod,
)

STEP = 0.001


def run(bar, step, rpm, phi, turns):
    """Returns crank's angle, rocker's angle, its angular velocity, and the gap in mm at every step, and an error."""
    container = exudyn.SystemContainer()
    system = container.AddSystem()
    speed = rpm * math.pi / 30
    start = exact(bar, phi)
    ground = system.AddObject(ObjectGround())
    nodes, bodies = {}, {}

    def link(name, length, base, angle, rate, base_velocity=(0.0, 0.0)):
        mass, inertia = rod(length)
        half = length / 2000
        c, s = math.cos(angle), math.sin(angle)
        nodes[name] = system.AddNode(NodeRigidBody2D(
            referenceCoordinates=[base[0] + half * c, base[1] + half * s, angle],
            initialVelocities=[base_velocity[0] - half * s * rate, base_velocity[1] + half * c * rate, rate]))
        bodies[name] = system.AddObject(ObjectRigidBody2D(
            physicsMass=mass, physicsInertia=inertia, nodeNumber=nodes[name]))
        ends = [[-half, 0, 0], [half, 0, 0]]
        return [system.AddMarker(MarkerBodyPosition(bodyNumber=bodies[name], localPosition=end)) for end in ends]

    def pin(first, second):
        system.AddObject(ObjectJointRevolute2D(markerNumbers=[first, second]))

    def fixed(x):
        return system.AddMarker(MarkerBodyPosition(bodyNumber=ground, localPosition=[x, 0, 0]))

    length = bar.crank / 1000
    a = length * math.cos(phi), length * math.sin(phi)
    crank = link("crank", bar.crank, (0.0, 0.0), phi, speed)
    coupler = link("coupler", bar.coupler, a, float(start.theta), speed * float(start.theta_1),
                   (-a[1] * speed, a[0] * speed))
    rocker = link("rocker", bar.rocker, (bar.frame / 1000, 0.0), float(start.psi), speed * float(start.psi_1))
    pin(fixed(0.0), crank[0])
    pin(crank[1], coupler[0])
    pin(fixed(bar.frame / 1000), rocker[0])
    pin(coupler[1], rocker[1])
    zero = system.AddMarker(MarkerNodeCoordinate(
        nodeNumber=system.AddNode(NodePointGround()), coordinate=0))
    angle = system.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes["crank"], coordinate=2))
    system.AddObject(ObjectConnectorCoordinate(
        markerNumbers=[zero, angle], offsetUserFunction=lambda mbs, t, item, offset: speed * t))

    rows = []

    def look(mbs, t):
        def at(name, length):
            return mbs.GetObjectOutputBody(
                bodies[name], exudyn.OutputVariableType.Position, localPosition=[length / 2000, 0, 0])

        first, second = at("coupler", bar.coupler), at("rocker", bar.rocker)
        gap = 1000 * math.hypot(first[0] - second[0], first[1] - second[1])
        values = [mbs.GetNodeOutput(nodes[name], exudyn.OutputVariableType.Coordinates)[2]
                  for name in ("crank", "rocker")]
        rate = mbs.GetNodeOutput(nodes["rocker"], exudyn.OutputVariableType.Coordinates_t)[2]
        rows.append((phi + values[0], float(start.psi) + values[1], rate, gap))
        return True

    system.SetPreStepUserFunction(look)
    system.Assemble()
    settings = exudyn.SimulationSettings()
    settings.timeIntegration.endTime = turns * 60 / rpm
    settings.timeIntegration.numberOfSteps = round(turns * 60 / rpm / step)
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    try:
        system.SolveDynamic(settings)
    except Exception as error:  # The class differs between versions.
        return rows, type(error).__name__
    return rows, None


def second_turn(step, rpm=RPM):
    rows, error = run(FOUR_BAR, step, rpm, START, 2)
    assert error is None
    second = [row for row in rows if row[0] - START > 2 * math.pi]
    speed = rpm * math.pi / 30
    worst = max(abs(rate - speed * float(exact(FOUR_BAR, phi).psi_1)) for phi, _, rate, _ in second[::10])
    return max(row[3] for row in second), FOUR_BAR.rocker * worst


def changes():
    rows, _ = run(PARALLELOGRAM, STEP, RPM, START, 10)
    sides = [is_crossed(phi, psi) for phi, psi, _, _ in rows if away_from_change_point(phi)]
    return sum(a != b for a, b in zip([False, *sides], sides))


def main():
    by_speed = {rpm: second_turn(STEP, rpm)[0] for rpm in (6.0, 60.0, 300.0)}
    by_step = {step: second_turn(step)[0] for step in (0.0005, 0.001, 0.002)}
    gap, velocity = second_turn(STEP)
    rows, error = run(SHORT_ROCKER, STEP, RPM, math.radians(90), 2)
    report("exudyn", step=STEP, gap=gap, by_speed=by_speed, by_step=by_step, changes=changes(),
           velocity_error=velocity, exception=error, last=math.degrees(rows[-1][0]))


if __name__ == "__main__":
    main()
