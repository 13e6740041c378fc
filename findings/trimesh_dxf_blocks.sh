#!/usr/bin/env bash
# trimesh 5.2.0, `load_path` of a DXF drawing with blocks; compared with ezdxf 1.4.5, which also writes the drawing.
#
# Behaviour: a block that is inserted at (3, 4) with a rotation of 90 degrees is turned clockwise. With a scale of 2 it
# is inserted at (6, 8), and with a scale of -1, a mirrored plate, at (-3, 4). The base point of the block is left out.
# A half circle with the extrusion (0, 0, -1), as in mirrored drawings, is at x = 5 instead of -5. Nothing is printed.
#
# Guess before: the same points as in ezdxf, or a message about entities that are not supported.
#
# Source: the reference of DXF has counter-clockwise angles, and the insertion point in the coordinates of the drawing.
# trimesh/path/exchange/dxf.py, `convert_insert`, leaves the order of shift, turn and scale to `planar_matrix`, which
# turns clockwise and scales the shift; the group codes of base point and extrusion do not occur in that file.
#
# Seen, the ends of a line from (0, 0) to (1, 0), or the box of the half circle:
#   turned by 90: trimesh (3, 3) (3, 4), ezdxf (3, 4) (3, 5)
#   scaled by 2: trimesh (6, 8) (8, 8), ezdxf (3, 4) (5, 4)
#   mirrored: trimesh (-4, 4) (-3, 4), ezdxf (2, 4) (3, 4)
#   base point (1, 0): trimesh (3, 4) (4, 4), ezdxf (2, 4) (3, 4)
#   half circle: trimesh (3, 0) (7, 2), ezdxf (-7, 0) (-3, 2)
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet trimesh==5.2.0 ezdxf==1.4.5 numpy==2.4.6 scipy==1.17.1 \
    networkx==3.6.1 shapely==2.2.0
cat >"$folder/check.py" <<'CHECK'
import sys

import ezdxf
import numpy as np
import trimesh
from ezdxf import bbox

path = sys.argv[1] + "/drawing.dxf"


def boxes(fill):
    """The corners of the drawing that `fill` makes, as trimesh and as ezdxf read it."""
    drawing = ezdxf.new("R2010", units=4)
    fill(drawing, drawing.modelspace())
    drawing.saveas(path)
    box = bbox.extents(ezdxf.readfile(path).modelspace())
    corners = np.array([box.extmin, box.extmax])[:, :2]
    return [[tuple(int(x) for x in corner.round()) for corner in found]
            for found in (trimesh.load_path(path).bounds, corners)]


def inserted(base=(0, 0), **settings):
    def fill(drawing, space):
        drawing.blocks.new("plate", base_point=base).add_line((0, 0), (1, 0))
        space.add_blockref("plate", (3, 4), dxfattribs=settings)
    return boxes(fill)


def half_circle(_, space):
    space.add_arc((5, 0), 2, 0, 180, dxfattribs={"extrusion": (0, 0, -1)})


seen = {
    "only shifted": inserted(),
    "turned by 90": inserted(rotation=90),
    "scaled by 2": inserted(xscale=2, yscale=2),
    "mirrored": inserted(xscale=-1),
    "base point (1, 0)": inserted(base=(1, 0)),
    "half circle": boxes(half_circle),
}
for name, (first, second) in seen.items():
    print(f"{name}: trimesh {first[0]} {first[1]}, ezdxf {second[0]} {second[1]}")
assert list(seen.values()) == [
    [[(3, 4), (4, 4)], [(3, 4), (4, 4)]],
    [[(3, 3), (3, 4)], [(3, 4), (3, 5)]],
    [[(6, 8), (8, 8)], [(3, 4), (5, 4)]],
    [[(-4, 4), (-3, 4)], [(2, 4), (3, 4)]],
    [[(3, 4), (4, 4)], [(2, 4), (3, 4)]],
    [[(3, 0), (7, 2)], [(-7, 0), (-3, 2)]],
]
CHECK
"$folder/env/bin/python" "$folder/check.py" "$folder"
