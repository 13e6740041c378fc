#!/usr/bin/env bash
# pymoca 0.12.0, from Modelica to CasADi: a drive of a gear and a wheel, whose output flange is left free.
#
# Behaviour: the equation that there is no torque at the free flange is missing. A motor on an inertia has as many
# equations as unknowns, also with the far end of the inertia free. With a drive behind the inertia, a model with two
# flanges of its own, there are 22 unknowns and 21 equations, and the acceleration is not determined. The model is
# returned; a line is logged. A free flange of a part gets its equation, and that of a model made of parts does not.
#
# Guess before: flow variables that are connected to nothing are zero for models of each depth.
#
# Source: section 9.2 of the specification of Modelica has an equation with zero for the flow variables of a connector
# that is in no connection on its outside. rumoca 0.10.2 reads the same text, and accelerates by 1 / (0.1 + 3 / 25).
#
# Seen:
#   Motor: 8 unknowns, 8 equations
#   Geared: 22 unknowns, 21 equations
#   Loaded: 28 unknowns, 28 equations
#   rumoca: speed of the motor after a second 4.5455 rad/s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile pymoca==0.12.0 casadi==3.8.2 rumoca==0.10.2 numpy==2.4.6
cat >"$folder/Drives.mo" <<'MODELS'
connector Flange
  Real phi;
  flow Real tau;
end Flange;

model Inertia
  Flange a;
  Flange b;
  parameter Real J = 1;
  Real phi(start = 0);
  Real w(start = 0);
equation
  phi = a.phi;
  phi = b.phi;
  der(phi) = w;
  J*der(w) = a.tau + b.tau;
end Inertia;

model Gear
  Flange a;
  Flange b;
  parameter Real ratio = 5;
equation
  a.phi = ratio*b.phi;
  0 = ratio*a.tau + b.tau;
end Gear;

model Torque
  Flange a;
equation
  a.tau = -1;
end Torque;

model Drive
  Flange left;
  Flange right;
  Gear gear;
  Inertia wheel(J = 3);
equation
  connect(left, gear.a);
  connect(gear.b, wheel.a);
  connect(wheel.b, right);
end Drive;

model Motor
  Torque torque;
  Inertia rotor(J = 0.1);
equation
  connect(torque.a, rotor.a);
end Motor;

model Geared
  Torque torque;
  Inertia rotor(J = 0.1);
  Drive drive;
equation
  connect(torque.a, rotor.a);
  connect(rotor.b, drive.left);
end Geared;

model Loaded
  Torque torque;
  Inertia rotor(J = 0.1);
  Drive drive;
  Inertia load(J = 1);
equation
  connect(torque.a, rotor.a);
  connect(rotor.b, drive.left);
  connect(drive.right, load.a);
end Loaded;
MODELS
cat >"$folder/check.py" <<'CHECK'
import logging
import sys

import rumoca
from pymoca.backends.casadi.api import transfer_model

logging.disable(logging.CRITICAL)
counts = {}
for name in ("Motor", "Geared", "Loaded"):
    model = transfer_model(sys.argv[1], name, {})
    counts[name] = len(model.states) + len(model.alg_states), len(model.equations)
    print(f"{name}: {counts[name][0]} unknowns, {counts[name][1]} equations")
assert counts == {"Motor": (8, 8), "Geared": (22, 21), "Loaded": (28, 28)}
speed = rumoca.Session().load(sys.argv[1] + "/Drives.mo", model="Geared").simulate(t=(0, 1), dt=0.1)["rotor.w"][-1]
print(f"rumoca: speed of the motor after a second {speed:.4f} rad/s")
assert abs(speed - 1 / (0.1 + 3 / 25)) < 1e-4
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
