#!/usr/bin/env bash
# gcode-toolpath 3.0.0 (npm), paths of a G-code program: arcs in the planes of G18 and G19, and centres of G90.1.
#
# Behaviour: the points of an arc in the x-z plane come with their coordinates in another order: x is the z of the
# program, y its x, and z its y. Lines keep the order, so a path of a line and an arc comes apart: the line ends at
# (10, 0, 0) and the arc begins at (0, 10, 0). In the y-z plane it is y, z, x. With G90.1, absolute centres of arcs, a
# half circle about (10, 0) has its centre at (30, 0), 10 from its beginning and 30 from its end. No message is printed.
#
# Guess before: the points of an arc are points of the program, as those of lines are; G90.1 is read, as the modal state
# has a place for it.
#
# Source: the README has the arguments of both functions as "a 3D vector of the start point" and "of the end point". Its
# example is in the plane of G17, where no coordinate is moved. `arc: 'G91.1'` is in the modal state of Toolpath.js, and
# G90.1 is not among its functions.
#
# Seen:
#   G17: line to 10 0 0, arc from 10 0 0 to 0 10 0 about 0 0 0
#   G18: line to 10 0 0, arc from 0 10 0 to 10 0 0 about 0 0 0
#   G19: line to 0 10 0, arc from 10 0 0 to 0 10 0 about 0 0 0
#   G17 G90.1: line to 20 0 0, arc from 20 0 0 to 0 0 0 about 30 0 0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund gcode-toolpath@3.0.0 >npm.log
cat >check.cjs <<'CHECK'
const assert = require("node:assert");
const Toolpath = require("gcode-toolpath");

const PROGRAMS = {
  "G17": ["G1 X10 Y0", "G3 X0 Y10 I-10 J0"],
  "G18": ["G1 X10 Z0", "G2 X0 Z10 I-10 K0"],
  "G19": ["G1 Y10 Z0", "G3 Y0 Z10 J-10 K0"],
  "G17 G90.1": ["G1 X20 Y0", "G3 X0 Y0 I10 J0"],
};
const EXPECTED = {
  "G17": "line to 10 0 0, arc from 10 0 0 to 0 10 0 about 0 0 0",
  "G18": "line to 10 0 0, arc from 0 10 0 to 10 0 0 about 0 0 0",
  "G19": "line to 0 10 0, arc from 10 0 0 to 0 10 0 about 0 0 0",
  "G17 G90.1": "line to 20 0 0, arc from 20 0 0 to 0 0 0 about 30 0 0",
};
const shown = (point) => [point.x, point.y, point.z].map((value) => Math.round(value * 1e6) / 1e6 + 0).join(" ");

async function main() {
  for (const [plane, lines] of Object.entries(PROGRAMS)) {
    const parts = [];
    const toolpath = new Toolpath({
      addLine: (modal, from, to) => parts.push(`line to ${shown(to)}`),
      addArcCurve: (modal, from, to, centre) =>
        parts.push(`arc from ${shown(from)} to ${shown(to)} about ${shown(centre)}`),
    });
    const text = [`G21 G90 ${plane}`, ...lines].join("\n");
    await new Promise((done, fail) => toolpath.loadFromString(text, (error) => (error ? fail(error) : done())));
    console.log(`${plane}: ${parts.join(", ")}`);
    assert.equal(parts.join(", "), EXPECTED[plane]);
  }
}

main();
CHECK
node check.cjs
