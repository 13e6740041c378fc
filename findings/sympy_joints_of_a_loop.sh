#!/usr/bin/env bash
# sympy 1.14.0, `physics.mechanics`: a four-bar of four `PinJoint`s in a `System`.
#
# Behaviour: the joint that closes the loop opens it elsewhere. The system has four independent coordinates and no
# constraint; `validate_system` finds nothing, and `form_eoms` returns four equations for a mechanism with one degree of
# freedom. They are those of a double pendulum of crank and coupler and of a rocker beside it: the joint of coupler and
# rocker has no equation but 0 = 0, so the mass matrix has rank 3. There are warnings that loops of orientations may
# cause errors, and no exception.
#
# Guess before: an exception, or two holonomic constraints for the loop and three dependent coordinates.
#
# Source: the documentation string of `System.validate_system` names its checks: as many dependent coordinates as
# constraints, which holds for none of both, and coordinates of the joints that are known to the system.
#
# Seen:
#   coordinates 4, dependent 0, constraints 0, rank of the mass matrix 3
#   row of the third joint: [0, 0, 0, 0], forcing 0
#   the rocker depends on: q_j4(t)
#   a warning: Loops are defined among the orientation of frames
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet sympy==1.14.0
cat >"$folder/check.py" <<'CHECK'
import warnings

from sympy.physics import mechanics

CRANK, COUPLER, ROCKER, FRAME = 0.5, 1.2, 1.0, 1.4
frame, crank, coupler, rocker = (mechanics.RigidBody(name) for name in ("frame", "crank", "coupler", "rocker"))
pins = (("j1", frame, crank, 0, -CRANK / 2), ("j2", crank, coupler, CRANK / 2, -COUPLER / 2),
        ("j3", coupler, rocker, COUPLER / 2, ROCKER / 2), ("j4", frame, rocker, FRAME, -ROCKER / 2))
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    joints = [mechanics.PinJoint(name, parent, child, parent_point=near * parent.x, child_point=far * child.x,
                                 joint_axis=parent.z)
              for name, parent, child, near, far in pins]
    system = mechanics.System.from_newtonian(frame)
    system.add_joints(*joints)
    system.validate_system()
    system.form_eoms()
messages = {str(warning.message).split(".")[0].strip() for warning in caught}
matrix = system.mass_matrix
numbers = {symbol: index + 1.0 for index, symbol in enumerate(sorted(matrix.free_symbols, key=str))}
rank = matrix.subs(system.q[1], 0.5).subs(numbers).rank()
print(f"coordinates {len(system.q)}, dependent {len(system.q_dep)}, constraints {len(system.holonomic_constraints)}, "
      f"rank of the mass matrix {rank}")
row, force = list(matrix.row(2)), system.forcing[2]
print(f"row of the third joint: {row}, forcing {force}")
angles = [angle for angle in system.q if rocker.frame.dcm(frame.frame).has(angle)]
print(f"the rocker depends on: {' '.join(map(str, angles))}")
loops = [message for message in messages if message.startswith("Loops are defined")]
print(f"a warning: {loops[0]}")
assert len(system.q) == 4 and not system.q_dep and not system.holonomic_constraints and rank == 3
assert not any(row) and force == 0 and angles == [system.q[3]]
CHECK
"$folder/env/bin/python" "$folder/check.py"
