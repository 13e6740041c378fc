#!/usr/bin/env bash
# urdf-usd-converter 0.3.4 and newton-usd-schemas 0.6.0: a rack and its pinion, from URDF to USD.
#
# Behaviour: a rack that follows its pinion by 0.02 m/rad has the coefficient 0.02 in USD. Angles of USD are in degrees,
# and the schema states the equation `joint0 = coef0 + coef1 * joint1` with degrees or distance. With the numbers of
# the file, the rack is at 1.246 m where the pinion reaches its limit of 57.3 degrees; by the URDF it is at 0.12 m. The
# offset is converted to degrees, the multiplier is not. Two revolute joints agree, as the factor is then a ratio.
# Newton 1.8.0 reads 0.02 as metres per radian, so it moves a rack right that came from the converter, and moves one
# that is written by the schema, as 0.000349 m per degree, by a 57th of its way.
#
# Guess before: the converter writes 0.02 * pi / 180 for the rack, as it converts limits, velocities and the offset.
#
# Source: the documentation of `newton:mimicCoef0` in the schema has "distance or degrees", the one of
# `newton:mimicCoef1` "dimensionless". The function `_convert_mimic_offset` of the converter has the same word.
#
# Seen:
#   rack: coef0 0.1, coef1 0.02, at the limit 1.2459 by the file, 0.12 by the URDF; in Newton: 0.02
#   wheel: coef0 5.7296, coef1 -2.0, at the limit -108.862 by the file, -108.862 by the URDF; in Newton: -2.0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet urdf-usd-converter==0.3.4 newton-usd-schemas==0.6.0 newton==1.8.0
cat >"$folder/check.py" <<'CHECK'
import glob
import math
import os
import sys

os.environ["WARP_CACHE_PATH"] = sys.argv[1] + "/cache"

import newton
import newton_usd_schemas
import urdf_usd_converter
from pxr import Usd

FOLLOWERS = {"rack": ("prismatic", 0.02, 0.1), "wheel": ("revolute", -2.0, 0.1)}


def joint(name, kind, mimic=""):
    return (f'<link name="{name}_link"/><joint name="{name}" type="{kind}"><parent link="base"/>'
            f'<child link="{name}_link"/><axis xyz="0 0 1"/>'
            f'<limit lower="-1" upper="1" effort="1" velocity="1"/>{mimic}</joint>')


path = sys.argv[1] + "/rack.urdf"
with open(path, "w") as file:
    file.write('<robot name="drive"><link name="base"/>' + joint("pinion", "revolute"))
    for name, (kind, multiplier, offset) in FOLLOWERS.items():
        file.write(joint(name, kind, f'<mimic joint="pinion" multiplier="{multiplier}" offset="{offset}"/>'))
    file.write("</robot>")
urdf_usd_converter.Converter().convert(path, sys.argv[1] + "/usd")
[name_of_stage] = glob.glob(sys.argv[1] + "/usd/*.usda")
stage = Usd.Stage.Open(name_of_stage)
prims = {prim.GetName(): prim for prim in stage.Traverse()}
limit = prims["pinion"].GetAttribute("physics:upperLimit").Get()
builder = newton.ModelBuilder()
builder.add_usd(name_of_stage)
model = builder.finalize(device="cpu")
rows = zip(model.joint_label, model.joint_mimic_coeffs.numpy().tolist())
in_newton = {label.split("/")[-1]: row for label, row in rows}
found = {}
for name, (kind, multiplier, offset) in FOLLOWERS.items():
    first, second = (prims[name].GetAttribute(f"newton:mimicCoef{index}").Get() for index in (0, 1))
    by_urdf = offset + multiplier * 1.0
    by_urdf = by_urdf if kind == "prismatic" else math.degrees(by_urdf)
    found[name] = first + second * limit, by_urdf, second, in_newton[name][1]
    print(f"{name}: coef0 {first:.5g}, coef1 {second:.4g}, at the limit {found[name][0]:.6g} by the file, "
          f"{by_urdf:.6g} by the URDF; in Newton: {in_newton[name][1]:.4g}")
assert abs(limit - math.degrees(1.0)) < 1e-3
assert abs(found["rack"][0] - 1.2459) < 1e-4 and abs(found["rack"][1] - 0.12) < 1e-9
assert abs(found["rack"][3] - 0.02) < 1e-6 and abs(found["wheel"][0] - found["wheel"][1]) < 1e-3
with open(os.path.dirname(newton_usd_schemas.__file__) + "/generatedSchema.usda") as file:
    schema = file.read()
for name, unit in (("0", "Units: distance or degrees"), ("1", "Units: dimensionless")):
    assert unit in schema.split(f"float newton:mimicCoef{name}", 1)[1].split('"""', 2)[1]
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder" 2>&1 | grep -E '^(rack|wheel):|Error'
