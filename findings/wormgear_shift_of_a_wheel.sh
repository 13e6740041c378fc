#!/usr/bin/env bash
# wormgear 0.0.8, design of worm gears: a wheel with a profile shift.
#
# Behaviour: the teeth of the wheel are moved outwards by the shift, and the centre distance stays. A pair of module 2
# and ratio 30 has a clearance of 0.5 mm between tips and roots; with a shift of 0.2 of the wheel it has 0.1 mm, with
# 0.25 none, and with 0.3 the wheel's tips are 0.1 mm within the worm. `validate_design` calls the pairs valid up to
# 0.25, and finds an interference from there on. `design_from_centre_distance` keeps the distance and the module with a
# shift of 0.5 as well, with 0.64 mm of interference.
#
# Guess before: a shift of x moves the worm by x times the module, as it is for a wheel whose cutter is moved by that,
# so that the clearance stays 0.5 mm.
#
# Source: the README has calculations by DIN 3975, and the functions the profile shift coefficient of the wheel as an
# argument. `calculate_centre_distance` is half of the sum of both pitch diameters.
#
# Seen:
#   shift 0.0: centre distance 38.144, wheel tip to worm root 0.50 mm, valid
#   shift 0.2: centre distance 38.144, wheel tip to worm root 0.10 mm, valid
#   shift 0.25: centre distance 38.144, wheel tip to worm root 0.00 mm, valid
#   shift 0.3: centre distance 38.144, wheel tip to worm root -0.10 mm, not valid
#   shift 0.5 at a centre distance of 50: module 2.5641, wheel tip to worm root -0.64 mm
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile pydantic==2.14.4
"$folder/env/bin/pip" install --quiet --no-compile --no-deps wormgear==0.0.8 # its geometry alone needs build123d
cat >"$folder/check.py" <<'CHECK'
from wormgear.calculator import design_from_centre_distance, design_from_module, validate_design

MODULE, RATIO, CLEARANCE = 2.0, 30, 0.5


def gap(design):
    """Distance between the tips of the wheel and the roots of the worm in mm."""
    return design.assembly.centre_distance_mm - (design.worm.root_diameter_mm + design.wheel.tip_diameter_mm) / 2


for shift in (0.0, 0.2, 0.25, 0.3):
    design = design_from_module(module=MODULE, ratio=RATIO, profile_shift=shift)
    is_valid = validate_design(design).valid
    print(f"shift {shift}: centre distance {design.assembly.centre_distance_mm:.3f}, "
          f"wheel tip to worm root {gap(design) + 0.0:.2f} mm, {'valid' if is_valid else 'not valid'}")
    assert design.wheel.profile_shift == shift and abs(design.assembly.centre_distance_mm - 38.1443) < 1e-4
    assert abs(gap(design) - (CLEARANCE - shift * MODULE)) < 1e-9 and is_valid == (shift < 0.3)
design = design_from_centre_distance(centre_distance=50.0, ratio=RATIO, profile_shift=0.5)
print(f"shift 0.5 at a centre distance of 50: module {design.worm.module_mm:.4f}, "
      f"wheel tip to worm root {gap(design):.2f} mm")
assert abs(gap(design) + design.worm.module_mm / 4) < 1e-9
CHECK
"$folder/env/bin/python" "$folder/check.py"
