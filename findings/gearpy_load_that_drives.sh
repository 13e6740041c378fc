#!/usr/bin/env bash
# gearpy 1.3.1, simulation of power trains: a load that drives the motor through gears, as a weight that is lowered.
#
# Behaviour: the torque of the load is divided by the efficiency of the gears in both directions of the power. Through a
# ratio of 5 with an efficiency of 0.8, a load that drives with 1 Nm reaches the motor as 0.25 Nm. Without any loss it
# would be 0.2 Nm, and with the efficiency it is 0.16 Nm. The motor brakes with more power than the load has, and
# settles at 1500 rad/s in place of 1320 rad/s. A load that resists is right: its 0.1 Nm takes 0.025 Nm of the motor.
#
# A fair guess: losses take power away from the side that drives, so a load that drives is multiplied by the efficiency.
#
# Source: `add_gear_mating` documents that the gear closest to the motor transfers a fraction of the driving torque. The
# text has no case of a load that drives.
#
# Seen:
#   load of 0.1 Nm that resists: torque of the motor 0.0250 Nm, 950.0 rad/s, power of the load over the motor 0.80
#   load of 1 Nm that drives: torque of the motor -0.2500 Nm, 1500.0 rad/s, power of the load over the motor 0.80
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

FREE_SPEED, STALL_TORQUE, RATIO, EFFICIENCY = 1000, 0.5, 5, 0.8


def settle(load):
    """The torque in Nm and the speed in rad/s of a motor, after its wheel has settled under a load in Nm."""
    inertia = InertiaMoment(1e-6, "kgm^2")
    motor = DCMotor(name="motor", no_load_speed=AngularSpeed(FREE_SPEED, "rad/s"),
                    maximum_torque=Torque(STALL_TORQUE, "Nm"), inertia_moment=inertia)
    pinion, wheel = (SpurGear(name=name, n_teeth=teeth, inertia_moment=inertia)
                     for name, teeth in (("pinion", 20), ("wheel", 20 * RATIO)))
    add_fixed_joint(master=motor, slave=pinion)
    add_gear_mating(master=pinion, slave=wheel, efficiency=EFFICIENCY)
    wheel.external_torque = lambda time, angular_position, angular_speed: Torque(load, "Nm")
    wheel.angular_position, wheel.angular_speed = AngularPosition(0, "rad"), AngularSpeed(0, "rad/s")
    Solver(powertrain=Powertrain(motor=motor)).run(time_discretization=TimeInterval(0.1, "ms"),
                                                   simulation_time=TimeInterval(50, "ms"))
    values = motor.time_variables
    return values["driving torque"][-1].to("Nm").value, values["angular speed"][-1].to("rad/s").value


for name, load, torque in (("0.1 Nm that resists", 0.1, 0.025), ("1 Nm that drives", -1.0, -0.25)):
    found, speed = settle(load)
    share = load / RATIO / found
    print(f"load of {name}: torque of the motor {found:.4f} Nm, {speed:.1f} rad/s, "
          f"power of the load over the motor {share:.2f}")
    assert abs(found - torque) < 1e-4 and abs(speed - FREE_SPEED * (1 - torque / STALL_TORQUE)) < 0.5
CHECK
"$folder/env/bin/python" "$folder/check.py"
