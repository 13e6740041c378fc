#!/usr/bin/env bash
# GTC 1.5.1, `function.implicit` for the rocker of a four-bar whose crank has an uncertain length.
#
# Behaviour: the function can return the value of the equation in place of its root. If the root is at a limit of the
# search range, the rocker is at 0 rad and not at 1.4755 rad, with the uncertainty of that wrong place. The limit
# counts as a root if the equation is below `epsilon` there, in the unit of the equation: a four-bar with a crank of
# 0.5 mm that is written in metres is at 2e-7 rad with an `epsilon` of 1e-6, though the root is in the middle of the
# range. The same in millimetres is right. No case raises.
#
# Guess before: a root at a limit is returned as that limit, with the uncertainty.
#
# Source: GTC/function.py, `nr_get_root`: for a small value `fl` at the lower limit it returns `fl`, and `fu` at the
# upper one; its documentation string promises the location of the root.
#
# Seen:
#   around the root: 1.4754957 rad, uncertainty 0.000113
#   from the root: 0.0000000 rad, uncertainty 0.000083
#   to the root: 0.0000000 rad, uncertainty 0.000083
#   a small one in mm: 1.4754957 rad, uncertainty 0.000113
#   a small one in m: 0.0000002 rad, uncertainty 0.000080
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet GTC==1.5.1 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import math

from GTC import cos, function, ureal

PHI, FOUR_BAR, UNCERTAIN = 1.0, (50.0, 120.0, 60.0, 140.0), 0.01


def rocker(scale, low, high, epsilon):
    """The angle of the rocker by Freudenstein's equation, which has the square of the unit of length."""
    crank, coupler, rocker, frame = (length / scale for length in FOUR_BAR)
    crank = ureal(crank, UNCERTAIN / scale)

    def closure(psi):
        return ((crank**2 - coupler**2 + rocker**2 + frame**2) / 2 - crank * frame * math.cos(PHI)
                + rocker * frame * cos(psi) - crank * rocker * cos(PHI - psi))

    return function.implicit(closure, low, high, epsilon)


def show(name, found):
    print(f"{name}: {found.x:.7f} rad, uncertainty {found.u:.6f}")
    return found


around = show("around the root", rocker(1, 1.2, 2.0, 1e-12))
start = show("from the root", rocker(1, around.x, 2.0, 1e-8))
end = show("to the root", rocker(1, 1.2, around.x, 1e-8))
millimetres = show("a small one in mm", rocker(100, 1.2, 2.0, 1e-6))
metres = show("a small one in m", rocker(100000, 1.2, 2.0, 1e-6))
assert abs(around.x - 1.4754957) < 1e-6 and abs(around.u / 1.1302e-4 - 1) < 1e-3
assert abs(millimetres.x - around.x) < 1e-6 and abs(millimetres.u / around.u - 1) < 1e-3
assert all(abs(found.x) < 1e-5 and abs(found.u / around.u - 1) > 0.2 for found in (start, end, metres))
CHECK
"$folder/env/bin/python" "$folder/check.py"
