#!/usr/bin/env bash
# urdf-loader 0.13.1 (npm): floating and planar joints of a URDF, whose origin is not at the one of its parent.
#
# Behaviour: the values of a floating and of a planar joint move the link in the frame of the parent, before the origin
# of the joint. A link at (1, 0, 0) that turns by 0.5 rad is carried to (0.88, 0.48, 0), where a continuous joint turns
# it in its place. Roll, pitch and yaw of a floating joint are turned about x, y and z of the body in this order, and
# those of an origin about z, y and x: with 0.4, 0.5 and 0.6 rad, the x axis is another one. Nothing is printed.
#
# Guess before: the joint moves at its origin, as other joints do, and three equal angles are the same rotation.
#
# Source: the URDF page of `joint` has the joint located at the origin of the child link, which `origin` gives, and
# `rpy` about fixed axes. In src/URDFClasses.js the pose of the values is multiplied from the left onto the origin,
# with 'XYZ'. A comment there has "X, Y, Z, R, P, Y".
#
# Seen, place of the link and direction of its x axis:
#   continuous at 1 0 0, 0.5 rad: 1.00 0.00 0.00, 0.88 0.48 0.00
#   floating at 1 0 0, 0.5 rad: 0.88 0.48 0.00, 0.88 0.48 0.00
#   planar at 1 0 0, 0.5 rad: 0.88 0.48 0.00, 0.88 0.48 0.00
#   rpy of an origin: 0.00 0.00 0.00, 0.72 0.50 -0.48
#   rpy of a floating joint: 0.00 0.00 0.00, 0.72 0.67 -0.14
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund urdf-loader@0.13.1 three@0.187.0 jsdom@24.1.3 >npm.log
cat >check.mjs <<'CHECK'
import assert from "node:assert";
import { JSDOM } from "jsdom";
import URDFLoader from "urdf-loader";

const { window } = new JSDOM("");
Object.assign(globalThis, { DOMParser: window.DOMParser, Document: window.Document, Element: window.Element });
const AT_ONE = '<origin xyz="1 0 0"/>';

/** Place of the link and its x axis, after a joint with an origin and values. */
function pose(kind, origin, values) {
  const robot = new URDFLoader().parse(`<robot name="r"><link name="base"/><link name="tip"/><joint name="j"
    type="${kind}"><parent link="base"/><child link="tip"/>${origin}<axis xyz="0 0 1"/></joint></robot>`);
  robot.setJointValue("j", ...values);
  robot.updateMatrixWorld(true);
  const matrix = robot.links.tip.matrixWorld.elements;
  return [matrix.slice(12, 15), matrix.slice(0, 3)].map((list) => list.map((value) => value.toFixed(2)).join(" "));
}

const cases = {
  "continuous at 1 0 0, 0.5 rad": pose("continuous", AT_ONE, [0.5]),
  "floating at 1 0 0, 0.5 rad": pose("floating", AT_ONE, [0, 0, 0, 0, 0, 0.5]),
  "planar at 1 0 0, 0.5 rad": pose("planar", AT_ONE, [0, 0, 0.5]),
  "rpy of an origin": pose("fixed", '<origin xyz="0 0 0" rpy="0.4 0.5 0.6"/>', []),
  "rpy of a floating joint": pose("floating", "", [0, 0, 0, 0.4, 0.5, 0.6]),
};
for (const [name, [place, axis]] of Object.entries(cases)) console.log(`${name}: ${place}, ${axis}`);
const [turned, floating, planar, origin, free] = Object.values(cases);
assert.deepEqual([turned[0], floating[0], planar[0]], ["1.00 0.00 0.00", "0.88 0.48 0.00", "0.88 0.48 0.00"]);
assert.deepEqual([origin[1], free[1]], ["0.72 0.50 -0.48", "0.72 0.67 -0.14"]);
CHECK
node check.mjs
