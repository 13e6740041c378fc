#!/usr/bin/env bash
# py-gearworks 0.0.24, `PlanetaryGearset.get_ratio`: speeds of a planetary gear with 20, 20 and 60 teeth.
#
# Behaviour: a sun that drives at 1 turns the carrier at 1/4, and a carrier that drives at 1 turns the sun at -4, to the
# other side. It is the same for a ring: a sun at 1 drives it at -1/3, and a ring at 1 drives the sun at +3. The speed
# of the planets is wrong in five of six cases: with the carrier at rest and the sun at 1, a planet of the same size
# turns at 1/3 in place of -1. Nothing is raised.
#
# Guess before: each case satisfies the equation of Willis, and the planet meshes with the ring.
#
# Source: the head of planetary_gearset.py has `w_ring * n_ring = w_carry * (n_ring + n_sun) - w_sun * n_sun`. Both
# cases with a driven sun divide by `-n_sun`. The planet has the mean of sun and ring, and a comment there has that its
# speed is the average of both.
#
# Seen, for a driver at 1, with the residual of the equation of Willis:
#   SUN drives, CARRY at rest: sun 1.00, carrier 0.00, ring -0.33, residual 0; planet 0.33, by the ring -1.00
#   SUN drives, RING at rest: sun 1.00, carrier 0.25, ring 0.00, residual 0; planet 0.50, by the ring -0.50
#   RING drives, CARRY at rest: sun 3.00, carrier 0.00, ring 1.00, residual 120; planet 2.00, by the ring 3.00
#   RING drives, SUN at rest: sun 0.00, carrier 0.75, ring 1.00, residual 0; planet 0.50, by the ring 1.50
#   CARRY drives, SUN at rest: sun 0.00, carrier 1.00, ring 1.33, residual 0; planet 0.67, by the ring 2.00
#   CARRY drives, RING at rest: sun -4.00, carrier 1.00, ring 0.00, residual -160; planet -2.00, by the ring -2.00
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile numpy==2.4.6 scipy==1.17.1
"$folder/env/bin/pip" install --quiet --no-compile --no-deps py-gearworks==0.0.24 # its solids alone need build123d
cat >"$folder/check.py" <<'CHECK'
import importlib.metadata
import sys
import types

package = types.ModuleType("py_gearworks")  # the package without the import of its solids
package.__path__ = [str(importlib.metadata.distribution("py-gearworks").locate_file("py_gearworks"))]
sys.modules["py_gearworks"] = package

from py_gearworks.planetary_gearset import PlanetaryGearset, PlanetaryGearType

SUN, RING, PLANET = 20, 60, 20
PARTS = {"SUN": {"CARRY": (0, True), "RING": (0, True)}, "RING": {"CARRY": (120, True), "SUN": (0, True)},
         "CARRY": {"SUN": (0, True), "RING": (-160, False)}}

gears = PlanetaryGearset(SUN, RING, PLANET, 3)
for driver, others in PARTS.items():
    for fixed, (expected, is_wrong) in others.items():
        speeds = gears.get_ratio(1, PlanetaryGearType[driver], PlanetaryGearType[fixed])
        residual = round(speeds.ring * RING - speeds.carry * (RING + SUN) + speeds.sun * SUN, 9)
        planet = speeds.carry + (speeds.ring - speeds.carry) * RING / PLANET
        print(f"{driver} drives, {fixed} at rest: sun {speeds.sun:.2f}, carrier {speeds.carry:.2f}, "
              f"ring {speeds.ring:.2f}, residual {residual:g}; planet {speeds.planet:.2f}, by the ring {planet:.2f}")
        assert residual == expected and (abs(speeds.planet - planet) > 0.5) == is_wrong
CHECK
"$folder/env/bin/python" "$folder/check.py"
