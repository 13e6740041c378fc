#!/usr/bin/env bash
# casadi 3.8.2, the root finders `newton` and `fast_newton`.
#
# Behaviour: a Newton step from a point with a singular Jacobian gives NaN, and NaN counts as converged. For x^2 = 1
# from the start 0 both solvers return NaN, raise nothing although `error_on_fail` is on by default, and report
# success. For x^2 = -1, which has no root, the result is the same. A four-bar that starts with its links in a row,
# all guesses 0, returns minus infinity for both angles as a success. Only a warning is printed.
#
# Guess before: an exception, as for a linkage that is asked for a position out of its reach.
#
# Source: casadi/solvers/newton.cpp in the project's repository. The largest residual is collected with a maximum
# that starts at 0 and is replaced only by a greater value, which NaN never is, and is then found below the tolerance.
# The documentation string of `rootfinder` says of `error_on_fail`: "Throw exceptions".
#
# Seen:
#   newton: x^2 = 1.0 from 0: nan, True, success
#   newton: x^2 = -1.0 from 0: nan, True, success
#   newton: four-bar from a row: [-inf -inf], True
#   fast_newton: the same, with the status converged_abstol_step
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet casadi==3.8.2
cat >"$folder/check.py" <<'CHECK'
import casadi
import numpy as np

x, p = casadi.SX.sym("x"), casadi.SX.sym("p")
angles, phi = casadi.SX.sym("angles", 2), casadi.SX.sym("phi")
square = {"x": x, "p": p, "g": x * x - p}
four_bar = {"x": angles, "p": phi, "g": casadi.vertcat(
    50 * casadi.cos(phi) + 140 * casadi.cos(angles[0]) - 140 - 50 * casadi.cos(angles[1]),
    50 * casadi.sin(phi) + 140 * casadi.sin(angles[0]) - 50 * casadi.sin(angles[1]))}
for solver in ("newton", "fast_newton"):
    root = casadi.rootfinder("root", solver, square)
    for right in (1.0, -1.0):
        found = float(root(0.0, right))
        print(f"{solver}: x^2 = {right} from 0: {found}, {root.stats()['success']}, {root.stats()['return_status']}")
        assert np.isnan(found) and root.stats()["success"]
    loop = casadi.rootfinder("loop", solver, four_bar)
    found = loop([0.0, 0.0], 0.1).full().ravel()
    print(f"{solver}: four-bar from a row: {found}, {loop.stats()['success']}")
    assert not np.isfinite(found).any() and loop.stats()["success"]
CHECK
"$folder/env/bin/python" "$folder/check.py" 2>/dev/null
