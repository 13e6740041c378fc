#!/usr/bin/env bash
# urdf-to-mjcf 0.1.1, urdf2mjcf 0.2.39, urdf2any 0.3.0, truerig 0.1.1: a URDF with a mimic joint as MJCF, in MuJoCo
# 4.0.0.
#
# Behaviour: a wheel that mimics a pinion with the factor -0.5 and the offset 0.1 is at -0.15 rad for 0.5 rad of the
# pinion. The MJCF of urdf-to-mjcf has the two joints in each other's place: the wheel is at -0.8 rad, with the
# inverse ratio. urdf2mjcf and urdf2any leave the coupling out and print nothing about it. truerig is right. A hinge
# without an axis turns about x in a URDF: it turns about z in the MJCF of urdf-to-mjcf and urdf2mjcf.
#
# Guess before: one equality of joints with these numbers from each converter, or a warning, and the axis x.
#
# Source: in an MJCF, `joint1` is the polynomial `polycoef` of `joint2` (page of `equality/joint`), and the axis of a
# joint is z by default; the page `joint` of URDF has x. `add_mimic_equality_constraints` of urdf-to-mjcf, in
# conversion/mjcf_assembly.py, writes the mimicked joint as `joint1`. urdf2any warns for USD only (backends/usd.py).
#
# Seen:
#   urdf-to-mjcf: wheel at -0.80, idler about [0. 0. 1.]
#   urdf2mjcf: wheel free, idler about [0. 0. 1.]
#   urdf2any: wheel free, idler about [1. 0. 0.]
#   truerig: wheel at -0.15, idler about [1. 0. 0.]
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile urdf-to-mjcf==0.1.1 urdf2mjcf==0.2.39 urdf2any==0.3.0 \
    truerig==0.1.1 mujoco==4.0.0 numpy==2.4.6 scipy==1.17.1
cat >"$folder/write.py" <<'WRITE'
LINK = ('<link name="{0}"><inertial><origin xyz="0 0 0"/><mass value="1"/>'
        '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
        '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>')
JOINT = ('<joint name="{0}" type="continuous"><origin xyz="{1} 0 0"/><parent link="base"/><child link="{0}_body"/>'
         "{2}</joint>")
print('<robot name="gears">' + "".join(map(LINK.format, ("base", "pinion_body", "wheel_body", "idler_body")))
      + JOINT.format("pinion", 1, '<axis xyz="0 0 1"/>')
      + JOINT.format("wheel", 2, '<axis xyz="0 0 1"/><mimic joint="pinion" multiplier="-0.5" offset="0.1"/>')
      + JOINT.format("idler", 3, "") + "</robot>")
WRITE
cat >"$folder/check.py" <<'CHECK'
import sys

import mujoco

EXPECTED = {"urdf-to-mjcf": (-0.8, [0, 0, 1]), "urdf2mjcf": (None, [0, 0, 1]), "urdf2any": (None, [1, 0, 0]),
            "truerig": (-0.15, [1, 0, 0])}
PINION = 0.5

for name, (place, axis) in EXPECTED.items():
    model = mujoco.MjModel.from_xml_path(f"{sys.argv[1]}/{name}/gears.xml")
    found = None
    if model.neq:
        names = [model.joint(joint[0]).name for joint in (model.eq_obj1id, model.eq_obj2id)]
        offset, factor = model.eq_data[0][:2]
        found = offset + factor * PINION if names == ["wheel", "pinion"] else (PINION - offset) / factor
    about = model.joint("idler").axis
    print(f"{name}: wheel {'free' if found is None else f'at {found:.2f}'}, idler about {about}")
    assert about.tolist() == axis and (found is None) == (place is None) and abs((found or 0) - (place or 0)) < 1e-9
CHECK
mkdir "$folder"/{urdf-to-mjcf,urdf2mjcf,urdf2any,truerig}
"$folder/env/bin/python" "$folder/write.py" >"$folder/gears.urdf"
cd "$folder"
{
    env/bin/urdf-to-mjcf gears.urdf -o urdf-to-mjcf/gears.xml
    env/bin/urdf2mjcf gears.urdf --output urdf2mjcf/gears.xml
    env/bin/urdf2any gears.urdf -o urdf2any/gears.xml
} >messages 2>&1
if grep -i mimic messages; then exit 1; fi
env/bin/truerig convert gears.urdf truerig/gears.xml >/dev/null
env/bin/python check.py "$folder"
