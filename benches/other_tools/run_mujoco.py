"""MuJoCo: the loop is closed by a `connect` constraint between two sites, step of 2 ms.

The integrator is `implicitfast`: with the default one, the drives of both gains are unstable at these small inertias.
All other settings are the defaults."""

import math

import mujoco

from measures import change_points, report, second_turn, unreachable
from mechanisms import RPM, exact, rod

STEP = 0.002


def body(name, length, angle, inner=""):
    mass, inertia = rod(length)
    end = length / 1000
    return f"""<body name="{name}" pos="{{}} 0 0" euler="0 0 {angle!r}">
      <joint name="{name}" axis="0 0 1"/>
      <inertial pos="{end / 2} 0 0" mass="{mass}" diaginertia="{inertia} {inertia} {inertia}"/>
      <site name="{name}" pos="{end} 0 0"/>{inner}</body>"""


class Simulation:
    def __init__(self, bar, step, rpm, phi, strong):
        start = exact(bar, phi)
        theta, psi = float(start.theta), float(start.psi)
        coupler = body("coupler", bar.coupler, theta - phi).format(bar.crank / 1000)
        crank = body("crank", bar.crank, phi, coupler).format(0)
        rocker = body("rocker", bar.rocker, psi).format(bar.frame / 1000)
        gain = 10.0 if strong else 0.01
        model = mujoco.MjModel.from_xml_string(f"""<mujoco><compiler angle="radian"/>
          <option timestep="{step}" integrator="implicitfast" gravity="0 0 0"/><worldbody>{crank}{rocker}</worldbody>
          <equality><connect site1="coupler" site2="rocker"/></equality>
          <actuator><velocity joint="crank" kv="{gain}"/></actuator></mujoco>""")
        self.model, self.data = model, mujoco.MjData(model)
        speed = rpm * math.pi / 30
        self.data.qvel[:] = [speed, speed * float(start.theta_1 - 1), speed * float(start.psi_1)]
        self.data.ctrl[0] = speed
        self.start = phi, psi
        mujoco.mj_forward(model, self.data)

    def advance(self):
        mujoco.mj_step(self.model, self.data)

    def angles(self):
        return self.start[0] + self.data.qpos[0], self.start[1] + self.data.qpos[2]

    def pins(self):
        return [1000 * self.data.site(name).xpos[:2] for name in ("coupler", "rocker")]


def main():
    by_speed = {rpm: second_turn(Simulation, STEP, rpm) for rpm in (6.0, 60.0, 300.0, 600.0)}
    by_step = {step: second_turn(Simulation, step) for step in (0.0005, 0.001, 0.002)}
    strong, weak = unreachable(Simulation, STEP, True), unreachable(Simulation, STEP, False)
    report("mujoco", step=STEP, gap=by_speed[RPM], by_speed=by_speed, by_step=by_step,
           changes=change_points(Simulation, STEP), strong=strong, weak=weak)


if __name__ == "__main__":
    main()
