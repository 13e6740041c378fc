#!/usr/bin/env bash
# pyball-arithmetic 0.1.0 (module pyball): certified roots of 2 cos x = 2 + e, a crank next to its dead point.
#
# Behaviour: for e = 0 the only root is 0. `isolate_roots` returns two intervals with `certified=True`, one on each
# side, and 0 is in none of them. For e = 1e-16 no root exists, and two are certified as well. With `max_bisect=20`
# the list for e = 0 is empty, as for an equation out of reach. Roots away from a dead point are right.
#
# Guess before: for e = 0 an uncertified candidate, for e = 1e-16 a candidate or nothing, with `max_bisect` a
# candidate.
#
# Source: the documentation of `isolate_roots` has "Certified entries guarantee a unique root inside their interval"
# and "Candidate entries (unproven) only appear when the budget runs out". pyball/newton.py certifies a small interval
# if the enclosure of the function contains 0, which is no change of sign, and drops intervals that are left at the
# end.
#
# Seen:
#   e = 0: certified -1.7e-08 to -5.8e-11 and 1.2e-10 to 1.7e-08
#   e = 1e-16: certified -1.0e-08 to -5.8e-11 and 1.2e-10 to 1.1e-08
#   e = 0, 20 bisections: 0 entries
#   2 cos x = 1: certified -1.0471975512 and 1.0471975512
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile pyball-arithmetic==0.1.0 mpmath==1.3.0
cat >"$folder/check.py" <<'CHECK'
import math

from pyball import isolate_roots


def roots(right, excess, low, high, **options):
    """Certified intervals, and the number of all entries, of 2 cos x = right + excess."""
    found = isolate_roots(lambda x: 2 * x.cos() - right - excess, lambda x: -2 * x.sin(), low, high, **options)
    return [(root.interval.lo, root.interval.hi) for root in found if root.certified], len(found)


for excess in (0, 1e-16):
    certified, _ = roots(2, excess, -1.0, 2.0)
    print(f"e = {excess}: certified " + " and ".join(f"{low:.1e} to {high:.1e}" for low, high in certified))
    assert len(certified) == 2 and all(low > 0 or high < 0 for low, high in certified)

_, count = roots(2, 0, -1.0, 2.0, max_bisect=20)
print(f"e = 0, 20 bisections: {count} entries")
assert count == 0

certified, _ = roots(1, 0, -2.0, 2.0)
print("2 cos x = 1: certified " + " and ".join(f"{(low + high) / 2:.10f}" for low, high in certified))
angle = math.pi / 3
assert all(low <= value <= high for (low, high), value in zip(certified, (-angle, angle), strict=True))
CHECK
"$folder/env/bin/python" "$folder/check.py"
