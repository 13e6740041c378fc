#!/usr/bin/env bash
# gearpy 1.3.1, simulation of power trains: a motor that starts a wheel through gears.
#
# Behaviour: the inertia of the motor is multiplied by the ratio of the gears where it is seen from the wheel, not by
# the square of the ratio. A motor with nearly all of the inertia starts five times too fast through a ratio of 5, and
# 25 times too fast through two such stages. A speed that has settled is right, since no inertia is in it.
#
# A fair guess: seen from the wheel, an inertia on the motor's shaft counts with the square of the ratio, as the kinetic
# energy of the shafts requires, so the motor's shaft begins with torque over inertia.
#
# Source: the documentation of `Solver.run` states that each inertia is multiplied by its gear ratio, without a reason.
#
# Seen:
#   ratio 1: the shaft of the motor begins with 1.00 of torque over inertia
#   ratio 5: the shaft of the motor begins with 5.00 of torque over inertia
#   ratio 25: the shaft of the motor begins with 25.00 of torque over inertia
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet gearpy==1.3.1 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
from gearpy.mechanical_objects import DCMotor, SpurGear
from gearpy.powertrain import Powertrain
from gearpy.solver import Solver
from gearpy.units import AngularPosition, AngularSpeed, InertiaMoment, TimeInterval, Torque
from gearpy.utils import add_fixed_joint, add_gear_mating

LIGHT, HEAVY, TORQUE = 1e-12, 1e-3, 0.01


def start(stages):
    """The acceleration of a motor with an inertia of HEAVY at the start, over TORQUE / HEAVY."""
    motor = DCMotor(name="motor", no_load_speed=AngularSpeed(1000, "rad/s"),
                    maximum_torque=Torque(TORQUE, "Nm"), inertia_moment=InertiaMoment(HEAVY, "kgm^2"))
    previous = motor
    for stage in range(stages):
        pinion, wheel = (SpurGear(name=f"{kind} {stage}", n_teeth=teeth,
                                  inertia_moment=InertiaMoment(LIGHT, "kgm^2"))
                         for kind, teeth in (("pinion", 20), ("wheel", 100)))
        add_fixed_joint(master=previous, slave=pinion)
        add_gear_mating(master=pinion, slave=wheel, efficiency=1)
        previous = wheel
    if previous is motor:
        previous = SpurGear(name="wheel", n_teeth=20, inertia_moment=InertiaMoment(LIGHT, "kgm^2"))
        add_fixed_joint(master=motor, slave=previous)
    previous.external_torque = lambda time, angular_position, angular_speed: Torque(0, "Nm")
    previous.angular_position, previous.angular_speed = AngularPosition(0, "rad"), AngularSpeed(0, "rad/s")
    train = Powertrain(motor=motor)
    Solver(powertrain=train).run(time_discretization=TimeInterval(1, "ms"), simulation_time=TimeInterval(10, "ms"))
    first = motor.time_variables["angular acceleration"][0].to("rad/s^2").value
    return first / (TORQUE / HEAVY)


for stages, ratio in enumerate((1, 5, 25)):
    found = start(stages)
    print(f"ratio {ratio}: the shaft of the motor begins with {found:.2f} of torque over inertia")
    assert abs(found - ratio) < 1e-3 * ratio
CHECK
"$folder/env/bin/python" "$folder/check.py"
