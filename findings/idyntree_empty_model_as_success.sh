#!/usr/bin/env bash
# idyntree 15.1.0 (iDynTree), `ModelLoader`: a URDF with a planar joint after a revolute one.
#
# Behaviour: `loadModelFromString` and `loadModelFromFile` return True, `isValid` returns True, and the model has no
# link, no joint and no degree of freedom. `KinDynComputations.loadRobotModel` takes that model with True as well.
# With a revolute joint in the place of the planar one, the model has three links. A message on the error stream names
# the planar joint. A text that is no URDF returns False.
#
# Guess before: False, as the loader has a status, or the model without its second link.
#
# Source: the URDF page of `joint` has six types, and `planar` is one of them. The message is "Joint b has type planar
# that is not currently supported by iDynTree".
#
# Seen:
#   revolute: loaded True, valid True, links 3, degrees of freedom 2, computations True
#   planar: loaded True, valid True, links 0, degrees of freedom 0, computations True
#   a text: loaded False
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet --no-compile idyntree==15.1.0 numpy==2.4.6
cat >"$folder/check.py" <<'CHECK'
import idyntree.bindings as idyntree

LINK = ('<link name="{}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
        "</inertial></link>")
JOINT = ('<joint name="{}" type="{}"><parent link="{}"/><child link="{}"/><axis xyz="0 0 1"/>'
         '<limit lower="-3" upper="3" effort="1" velocity="1"/></joint>')

for kind, links in (("revolute", 3), ("planar", 0)):
    text = ('<robot name="arm">' + "".join(LINK.format(name) for name in ("base", "first", "second"))
            + JOINT.format("a", "revolute", "base", "first") + JOINT.format("b", kind, "first", "second") + "</robot>")
    loader = idyntree.ModelLoader()
    is_loaded = loader.loadModelFromString(text, "urdf")
    model = loader.model()
    is_taken = idyntree.KinDynComputations().loadRobotModel(model)
    print(f"{kind}: loaded {is_loaded}, valid {loader.isValid()}, links {model.getNrOfLinks()}, "
          f"degrees of freedom {model.getNrOfDOFs()}, computations {is_taken}")
    assert is_loaded and loader.isValid() and is_taken and model.getNrOfLinks() == links
is_loaded = idyntree.ModelLoader().loadModelFromString("a text", "urdf")
print(f"a text: loaded {is_loaded}")
assert not is_loaded
CHECK
"$folder/env/bin/python" "$folder/check.py"
