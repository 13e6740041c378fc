#!/usr/bin/env bash
# dxf 5.3.1 and dxf-parser 1.1.2 (npm), with ezdxf 1.4.5 as writer and reference: entities seen from below, whose
# extrusion is (0, 0, -1).
#
# Behaviour: a contour that was mirrored by turning it over comes apart. `toPolylines` of dxf mirrors arcs and circles
# in x, as it should; it leaves polylines with bulges on the side where they were; and it mirrors ellipses too, whose
# centre and axis are world coordinates, so an ellipse is on the wrong side. dxf-parser keeps the extrusion of arcs and
# polylines and leaves out that of circles, so a hole that was mirrored cannot be distinguished from one that was not.
# Nothing is printed.
#
# Guess before: all entities that have object coordinates are mirrored, or none; and dxf-parser keeps the content of
# the file.
#
# Source: the DXF reference gives arcs, circles and polylines in object coordinates, whose x axis points to -x for this
# extrusion, and ellipses and lines in world coordinates. ezdxf reads them in this way.
#
# Seen:
#   ARC: ezdxf from -15 0 to -10 5, dxf from -15 0 to -10 5
#   CIRCLE: ezdxf from -22 0 to -22 0, dxf from -22 0 to -22 0
#   LWPOLYLINE: ezdxf from -30 0 to -34 0, dxf from 30 0 to 34 0
#   ELLIPSE: ezdxf from 44 0 to 40 -2, dxf from -44 0 to -40 2
#   LINE: ezdxf from 50 0 to 54 3, dxf from 50 0 to 54 3
#   dxf-parser has the extrusion of: ARC LWPOLYLINE LINE
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet ezdxf==1.4.5
cd "$folder"
npm install --silent --no-audit --no-fund dxf@5.3.1 dxf-parser@1.1.2 >npm.log
cat >write.py <<'WRITE'
import json
import math

import ezdxf
from ezdxf import path

drawing = ezdxf.new("R2010")
space = drawing.modelspace()
below = {"extrusion": (0, 0, -1)}
space.add_arc((10, 0), 5, 0, 90, dxfattribs=below)
space.add_circle((20, 0), 2, dxfattribs=below)
space.add_lwpolyline([(30, 0, 0, 0, 1), (34, 0, 0, 0, 0)], dxfattribs=below)
space.add_ellipse((40, 0), (4, 0), 0.5, 0, math.pi / 2, dxfattribs=below)
space.add_line((50, 0), (54, 3), dxfattribs=below)
drawing.saveas("below.dxf")
read = ezdxf.readfile("below.dxf").modelspace()
paths = [(entity.dxftype(), path.make_path(entity)) for entity in read]
print(json.dumps([[kind, [[round(value, 6) for value in (end.x, end.y)] for end in (made.start, made.end)]]
                  for kind, made in paths]))
WRITE
env/bin/python write.py >reference.json
cat >check.mjs <<'CHECK'
import assert from "node:assert";
import { readFileSync } from "node:fs";
import { Helper } from "dxf";
import Parser from "dxf-parser";

const reference = JSON.parse(readFileSync("reference.json", "utf8"));
const drawing = readFileSync("below.dxf", "utf8");
const polylines = new Helper(drawing).toPolylines().polylines.map(({ vertices }) => [vertices[0], vertices.at(-1)]);
const text = ([from, to]) => `from ${from.join(" ")} to ${to.join(" ")}`;
const equal = {};
reference.forEach(([kind, ends], index) => {
  const found = polylines[index].map((end) => end.slice(0, 2).map((value) => Math.round(value * 1e6) / 1e6 + 0));
  console.log(`${kind}: ezdxf ${text(ends)}, dxf ${text(found)}`);
  equal[kind] = ends.flat().every((value, at) => Math.abs(value - found.flat()[at]) < 1e-6);
});
const kept = new Parser().parseSync(drawing).entities
  .filter((entity) => entity.extrusionDirectionZ === -1 || entity.extrusionDirection?.z === -1)
  .map((entity) => entity.type);
console.log(`dxf-parser has the extrusion of: ${kept.join(" ")}`);
assert.deepStrictEqual(equal, { ARC: true, CIRCLE: true, LWPOLYLINE: false, ELLIPSE: false, LINE: true });
assert.deepStrictEqual(kept, ["ARC", "LWPOLYLINE", "LINE"]);
CHECK
node check.mjs
