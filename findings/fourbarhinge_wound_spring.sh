#!/usr/bin/env bash
# fourbarhinge 0.1.2, four-bar hinges with springs: a torsion spring that is wound by more than half a turn.
#
# Behaviour: the winding of a spring is brought to the range of half a turn to each side. Between the frame and the
# input bar, a spring that is wound by 170 degrees has the torque for 170 degrees. One that is wound by 190 degrees has
# that torque in the other direction. A spring that is wound by a whole turn has no torque and no energy. There is no
# message.
#
# A fair guess: the torque is the constant times the winding, as in a garage door, whose springs have several turns.
#
# Source: the README has torsion springs in the hinges without a range of their angle. A comment in the code names the
# range, as a cure for jumps of other angles.
#
# Seen:
#   wound by 170 degrees: torque 2.967 Nm, energy 4.402 J
#   wound by 190 degrees: torque -2.967 Nm, energy 4.402 J
#   wound by 360 degrees: torque 0.000 Nm, energy 0.000 J
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet fourbarhinge==0.1.2 modern-robotics==1.1.1 numpy==2.4.6 scipy==1.17.1
cat >"$folder/check.py" <<'CHECK'
import math

from fourbarhinge import (Actuator, Bar, BarId, FourBarDynamics, FourBarGeometry, FourBarKinematics, Point,
                          TorsionSpring)

CONSTANT, CLOSED = 1.0, math.radians(100)


def hinge(winding):
    """The torque on the input bar that holds a hinge with one wound spring, and the energy of the spring."""
    lengths = {BarId.GROUND: 0.6, BarId.INPUT: 0.25, BarId.COUPLER: 0.7, BarId.OUTPUT: 0.55}
    bars = {key: Bar(length=length, mass=1e-6, inertia=1e-6, center_of_mass=Point(x=length / 2, y=0.0))
            for key, length in lengths.items()}
    kinematics = FourBarKinematics(FourBarGeometry(position_ground=Point(x=0.0, y=0.0), bar=bars), theta_ground=0.0)
    spring = TorsionSpring(free_angle=CLOSED + winding, constant=CONSTANT, bar_a=BarId.GROUND, bar_b=BarId.INPUT)
    dynamics = FourBarDynamics(kinematics, torsion_springs=[spring], gravity=(0.0, 0.0))
    kinematics.solve_configuration(CLOSED, branch=-1)
    kinematics.solve_theta_dot(0.0)
    holding = dynamics.solve_required_effort(Actuator(bar=BarId.INPUT))
    return round(-holding, 12) + 0.0, dynamics.get_spring_potential_energy()


for degrees, counted in ((170, 170), (190, -170), (360, 0)):
    torque, energy = hinge(math.radians(degrees))
    print(f"wound by {degrees} degrees: torque {torque:.3f} Nm, energy {energy:.3f} J")
    wanted = CONSTANT * math.radians(counted)
    assert abs(torque - wanted) < 1e-9 and abs(energy - wanted**2 / (2 * CONSTANT)) < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py"
