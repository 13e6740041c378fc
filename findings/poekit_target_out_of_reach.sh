#!/usr/bin/env bash
# poekit 0.1.0, Paden-Kahan subproblems: a target that the joints cannot reach.
#
# Behaviour: `paden_kahan_2` returns two pairs of angles for a target that no pair reaches, and the tip ends 0.36 m from
# it. The zeros that are documented for a case without a solution appear for parallel axes, and not for such a target.
# A target within reach has two right pairs. Nothing is raised.
#
# Guess before: zeros for a target out of reach, as documented.
#
# Source: the docstring of `paden_kahan_2` in poekit/paden_kahan.py has "returns zeros matrix when no solution". The
# code compares the square below the root, `g2`, with a negative limit after it has taken its absolute value.
#
# Seen:
#   in reach: 0.700 0.400, off by 0.000; 2.956 2.347, off by 0.000
#   too far: 0.888 0.807, off by 0.361; 2.768 1.940, off by 0.361
#   too near: 0.645 0.088, off by 0.295; 3.011 2.659, off by 0.295
#   parallel axes: all zero
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile poekit==0.1.0 numpy==2.4.6 sympy==1.14.0
cat >"$folder/check.py" <<'CHECK'
import numpy as np
from poekit import ExpMapping, PadenKahan, TwistUtils

FIRST = TwistUtils.joint_2_twist([0, 0, 1], [0, 0, 0], "rot")
SECOND = TwistUtils.joint_2_twist([1, 0, 0], [0, 0, 0], "rot")
PARALLEL = TwistUtils.joint_2_twist([0, 0, 1], [1, 0, 0], "rot")
START = np.array([0.2, 0.5, 0.1])


def tip(angles):
    """The point that begins at START, after the turn about the second and then the first axis."""
    first, second = (ExpMapping.exp_screw(np.append(twist, angle)) for twist, angle in zip((FIRST, SECOND), angles))
    return (first @ second @ np.append(START, 1.0))[:3]


reached = tip((0.7, 0.4))
for name, factor, error in (("in reach", 1.0, 0.0), ("too far", 1.5, 0.361), ("too near", 0.5, 0.2953)):
    pairs = PadenKahan.paden_kahan_2(FIRST, SECOND, START, factor * reached)
    errors = [np.linalg.norm(tip(pair) - factor * reached) for pair in pairs]
    print(f"{name}: " + "; ".join(f"{pair[0]:.3f} {pair[1]:.3f}, off by {off:.3f}"
                                  for pair, off in zip(pairs, errors)))
    assert np.abs(np.array(errors) - error).max() < 1e-4 and np.abs(pairs).min() > 0.01
assert np.all(PadenKahan.paden_kahan_2(FIRST, PARALLEL, START, reached) == 0)
print("parallel axes: all zero")
CHECK
"$folder/env/bin/python" "$folder/check.py"
