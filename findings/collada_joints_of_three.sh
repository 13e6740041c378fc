#!/usr/bin/env bash
# three 0.187.0, `ColladaLoader`: joints of a COLLADA file, moved by `kinematics.setJointValue`.
#
# Behaviour: if a rotation and a slide move one node, as for a cylindrical pair, the value of one puts the other back
# to its start. `getJointValue` returns both values. A joint that is bound to a transform whose `sid` does not contain
# the name of the joint does not move, and its value is returned as set. A crank without limits does not turn, with a
# warning that its limits are 0 and 0. One joint per node, with limits and with its own name in the transform, is
# right.
#
# Guess before: both joints keep their values, the bound transform moves, a joint without limits is free.
#
# Source: in COLLADA 1.5, `bind_joint_axis` names any transform by its path, and `limits` of `revolute` is optional.
# In loaders/collada/ColladaComposer.js `setJointValue` starts from the transforms of the file, and compares names by
# `transform.sid.indexOf(jointIndex)`. ColladaParser.js begins with limits of 0.
#
# Seen, the end of a lever of 1 m:
#   one joint at 90 degrees: 0.00 1.00 0.00
#   cylindrical pair at 90 degrees: 0.00 1.00 0.00
#   cylindrical pair, then 0.5 m: 1.00 0.00 0.50, values 90 and 0.5
#   another sid at 90 degrees: 1.00 0.00 0.00, value 90
#   without limits at 90 degrees: 1.00 0.00 0.00, value 0
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund three@0.187.0 jsdom@24.1.3
cat >check.mjs <<'CHECK'
import assert from "node:assert";

import { JSDOM } from "jsdom";
import { Vector3 } from "three";

globalThis.DOMParser = new JSDOM("").window.DOMParser;
globalThis.self = globalThis;
console.debug = console.warn = () => {}; // the version of the file, the warning about limits
const { ColladaLoader } = await import("three/examples/jsm/loaders/ColladaLoader.js");

const limits = (limit) => `<limits><min>${-limit}</min><max>${limit}</max></limits>`;
const joint = (name, kind, range) =>
  `<joint sid="${name}" name="${name}"><${kind} sid="axis0"><axis>0 0 1</axis>${range}</${kind}></joint>`;
const bind = (name, target) =>
  `<bind_joint_axis target="lever/${target}"><axis><param>model_inst_${name}.axis0</param></axis></bind_joint_axis>`;

/** Scene with one lever, whose joints and transforms are those given. */
function load(joints, transforms, binds) {
  const text = `<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">
  <asset><unit meter="1" name="meter"/><up_axis>Y_UP</up_axis></asset>
  <library_kinematics_models><kinematics_model id="model" name="model"><technique_common>${joints}
    <link sid="base" name="base"><attachment_full joint="model/turn"><link sid="lever" name="lever"/></attachment_full>
    </link></technique_common></kinematics_model></library_kinematics_models>
  <library_kinematics_scenes><kinematics_scene id="scene"><instance_kinematics_model url="#model" sid="model_inst"/>
  </kinematics_scene></library_kinematics_scenes>
  <library_visual_scenes><visual_scene id="visual" name="visual"><node id="lever" name="lever">${transforms}
    <node id="end" name="end"><translate>1 0 0</translate></node></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#visual"/><instance_kinematics_scene url="#scene">${binds}
  </instance_kinematics_scene></scene>
</COLLADA>`;
  return new ColladaLoader().parse(text, "");
}

function end(robot) {
  robot.scene.updateMatrixWorld(true);
  const place = new Vector3().setFromMatrixPosition(robot.scene.getObjectByName("end").matrixWorld);
  return place.toArray().map((value) => (Math.round(value * 100) / 100 + 0).toFixed(2)).join(" ");
}

const TURN = joint("turn", "revolute", limits(180));
const ROTATE = (sid) => `<rotate sid="${sid}">0 0 1 0</rotate>`;
const one = load(TURN, ROTATE("turn_axis0"), bind("turn", "turn_axis0"));
const pair = load(TURN + joint("slide", "prismatic", limits(1)),
  ROTATE("turn_axis0") + '<translate sid="slide_axis0">0 0 0</translate>',
  bind("turn", "turn_axis0") + bind("slide", "slide_axis0"));
const other = load(TURN, ROTATE("rotateZ"), bind("turn", "rotateZ"));
const free = load(joint("turn", "revolute", ""), ROTATE("turn_axis0"), bind("turn", "turn_axis0"));

const found = [];
for (const robot of [one, pair, other, free]) {
  robot.kinematics.setJointValue("turn", 90);
  found.push(end(robot));
}
console.log(`one joint at 90 degrees: ${found[0]}`);
console.log(`cylindrical pair at 90 degrees: ${found[1]}`);
pair.kinematics.setJointValue("slide", 0.5);
const values = [pair.kinematics.getJointValue("turn"), pair.kinematics.getJointValue("slide")];
console.log(`cylindrical pair, then 0.5 m: ${end(pair)}, values ${values.join(" and ")}`);
console.log(`another sid at 90 degrees: ${found[2]}, value ${other.kinematics.getJointValue("turn")}`);
console.log(`without limits at 90 degrees: ${found[3]}, value ${free.kinematics.getJointValue("turn")}`);

assert.deepEqual(found, ["0.00 1.00 0.00", "0.00 1.00 0.00", "1.00 0.00 0.00", "1.00 0.00 0.00"]);
assert.equal(end(pair), "1.00 0.00 0.50");
assert.deepEqual(values, [90, 0.5]);
assert.equal(other.kinematics.getJointValue("turn"), 90);
assert.equal(free.kinematics.getJointValue("turn"), 0);
CHECK
node check.mjs
