#!/usr/bin/env bash
# scipy 1.17.1, `scipy.optimize.root` for the closure of a four-bar.
#
# Behaviour: `success` does not mean that the loop is closed. Where the crank is out of reach, `lm` returns success with
# a gap of 9.6 mm, while `hybr`, the default, returns failure. Next to the dead point of a parallelogram `hybr` returns
# failure for an exact root, with a gap below 1e-15, and `krylov` a success that is 0.09 degrees off.
#
# Guess before: success if and only if the equations are satisfied, as they are to be solved and not minimised.
#
# Source: the reference of `root` calls x the solution, and `success` a flag that the algorithm exited successfully. The
# page of the method `lm` adds that it solves in the sense of least squares.
#
# Seen:
#   out of reach: hybr False, gap 9.6 mm; lm True, gap 9.6 mm
#   dead point + 1e-9 rad: hybr False, gap 3.3e-16; krylov True, coupler off by 0.0888 degrees
#   0.5 rad: hybr True, lm True, krylov True
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet scipy==1.17.1 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

import numpy as np
from scipy.optimize import root


def solve(lengths, phi, start, method):
    """The flag, the gap and the angle of the coupler."""
    crank, coupler, rocker, frame = lengths

    def closure(angles):
        theta, psi = angles
        return [crank * math.cos(phi) + coupler * math.cos(theta) - frame - rocker * math.cos(psi),
                crank * math.sin(phi) + coupler * math.sin(theta) - rocker * math.sin(psi)]

    found = root(closure, start, method=method)
    return bool(found.success), float(np.hypot(*found.fun)), float(found.x[0])


OUT, PARALLELOGRAM = (50.0, 120.0, 60.0, 140.0), (1.0, 2.0, 1.0, 2.0)
out = {method: solve(OUT, 3.0, (0.5, 1.5), method) for method in ("hybr", "lm")}
print("out of reach: " + "; ".join(f"{name} {flag}, gap {gap:.1f} mm" for name, (flag, gap, _) in out.items()))
dead = {method: solve(PARALLELOGRAM, 1e-9, (0.1, 0.2), method) for method in ("hybr", "krylov")}
off = abs(math.degrees(dead["krylov"][2]))
print(f"dead point + 1e-9 rad: hybr {dead['hybr'][0]}, gap {dead['hybr'][1]:.1e}; "
      f"krylov {dead['krylov'][0]}, coupler off by {off:.4f} degrees")
usual = {method: solve(PARALLELOGRAM, 0.5, (0.1, 0.2), method)[0] for method in ("hybr", "lm", "krylov")}
print("0.5 rad:", usual)
assert [flag for flag, _, _ in out.values()] == [False, True] and all(gap > 9.0 for _, gap, _ in out.values())
assert not dead["hybr"][0] and dead["hybr"][1] < 1e-14
assert dead["krylov"][0] and off > 0.05
assert all(usual.values())
CHECK
"$folder/env/bin/python" "$folder/check.py"
