"""Drake: a discrete multibody plant with a ball constraint, step of 1 ms."""

import math

import mpmath
import numpy as np
from pydrake.autodiffutils import AutoDiffXd
from pydrake.math import RigidTransform, RigidTransform_
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import FixedOffsetFrame, PdControllerGains, RevoluteJoint, SpatialInertia
from pydrake.systems.analysis import Simulator, Simulator_

from measures import change_points, report, second_turn, unreachable
from mechanisms import FOUR_BAR, RPM, START, FourBar, exact, rod

STEP = 0.001


def place(x):
    return RigidTransform(np.array([x / 1000, 0.0, 0.0]))


class Simulation:
    def __init__(self, bar, step, rpm, phi, strong):
        plant = MultibodyPlant(step)
        plant.mutable_gravity_field().set_gravity_vector([0, 0, 0])

        def link(name, length):
            mass, _ = rod(length)
            inertia = SpatialInertia.ThinRodWithMassAboutEnd(mass, length / 1000, [1.0, 0.0, 0.0])
            return plant.AddRigidBody(name, inertia)

        def hinge(name, parent, x, child):
            frame = plant.AddFrame(FixedOffsetFrame(name + "_at", parent.body_frame(), place(x)))
            return plant.AddJoint(RevoluteJoint(name, frame, child.body_frame(), [0, 0, 1]))

        crank, coupler, rocker = link("crank", bar.crank), link("coupler", bar.coupler), link("rocker", bar.rocker)
        self.joints = [
            hinge("crank", plant.world_body(), 0.0, crank),
            hinge("coupler", crank, bar.crank, coupler),
            hinge("rocker", plant.world_body(), bar.frame, rocker),
        ]
        ends = np.array([bar.coupler / 1000, 0, 0]), np.array([bar.rocker / 1000, 0, 0])
        plant.AddBallConstraint(coupler, ends[0], rocker, ends[1])
        actuator = plant.AddJointActuator("drive", self.joints[0])
        actuator.set_controller_gains(PdControllerGains(p=0.0, d=10.0 if strong else 0.01))
        plant.Finalize()

        start = exact(bar, phi)
        speed = rpm * math.pi / 30
        self.simulator = Simulator(plant)
        self.plant, self.step, self.count = plant, step, 0
        self.context = self.simulator.get_mutable_context()
        angles = phi, float(start.theta) - phi, float(start.psi)
        rates = speed, speed * float(start.theta_1 - 1), speed * float(start.psi_1)
        for joint, angle, rate in zip(self.joints, angles, rates):
            joint.set_angle(self.context, angle)
            joint.set_angular_rate(self.context, rate)
        plant.get_desired_state_input_port(plant.GetModelInstanceByName("DefaultModelInstance")).FixValue(
            self.context, [0.0, speed])
        self.bodies, self.ends = (coupler, rocker), ends

    def advance(self):
        self.count += 1
        self.simulator.AdvanceTo(self.count * self.step)

    def angles(self):
        return self.joints[0].get_angle(self.context), self.joints[2].get_angle(self.context)

    def pins(self):
        return [1000 * body.EvalPoseInWorld(self.context).multiply(end)[:2]
                for body, end in zip(self.bodies, self.ends)]


def length_sensitivity():
    """Relative error of the rocker's angle by the crank's length, 20 ms after the start, by automatic differentiation.

    The crank's own angle depends on the length too: that part is subtracted.
    """
    number = AutoDiffXd
    start = Simulation(FOUR_BAR, STEP, RPM, START, strong=True)
    plant = start.plant.ToAutoDiffXd()
    context = plant.CreateDefaultContext()
    context.SetTimeStateAndParametersFrom(start.context)
    port = plant.get_desired_state_input_port(plant.GetModelInstanceByName("DefaultModelInstance"))
    port.FixValue(context, [number(0.0), number(RPM * math.pi / 30)])
    pose = RigidTransform_[number]([number(FOUR_BAR.crank / 1000, [1.0]), number(0.0), number(0.0)])
    plant.GetFrameByName("coupler_at").SetPoseInParentFrame(context, pose)
    simulator = Simulator_[number](plant, context)
    simulator.AdvanceTo(0.02)
    crank, rocker = (plant.GetJointByName(name).get_angle(context) for name in ("crank", "rocker"))
    phi = crank.value()

    def psi(length):
        return exact(FourBar(length, FOUR_BAR.coupler, FOUR_BAR.rocker, FOUR_BAR.frame), phi).psi

    true = float(mpmath.diff(psi, mpmath.mpf(FOUR_BAR.crank)))
    carried = float(exact(FOUR_BAR, phi).psi_1) * crank.derivatives()[0]
    return abs((rocker.derivatives()[0] - carried) / 1000 - true) / abs(true)


def main():
    by_speed = {rpm: second_turn(Simulation, STEP, rpm) for rpm in (6.0, 60.0, 300.0)}
    by_step = {step: second_turn(Simulation, step) for step in (0.0001, 0.001, 0.01)}
    strong, weak = unreachable(Simulation, STEP, True), unreachable(Simulation, STEP, False)
    report("drake", step=STEP, gap=by_speed[RPM], by_speed=by_speed, by_step=by_step,
           changes=change_points(Simulation, STEP), strong=strong, weak=weak,
           length_sensitivity=length_sensitivity())


if __name__ == "__main__":
    main()
