#!/usr/bin/env bash
# bvhio 1.5.4, bvhsdk 0.2.1, three 0.187.0 (`BVHLoader`): a BVH with a joint that slides, as a piston in its cylinder.
#
# Behaviour: the joint has the offset 10 and the value 12 in its position channel. It is 12 from its parent in bvhio
# and bvhsdk, which take the channel in place of the offset, and 22 in three, which adds both. The root has the offset
# 100 in z and the value 3: it is at 3 in bvhio and bvhsdk, and at 103 in three. A joint with rotations alone is at
# its offset in all of them. Nothing is raised or printed.
#
# Guess before: one place of the piston in all readers.
#
# Source: BVHLoader.js, lines 424 to 426, adds the offset of the bone to each value. bvhio/lib/Parser.py has the
# position "given as overwrite". The format has no standard; files of joints with rotations alone do not differ.
#
# Seen, places of cylinder (root), piston and rod:
#   bvhio: 1 2 3, 1 14 3, 1 19 3
#   bvhsdk: 1 2 3, 1 14 3, 1 19 3
#   three: 1 2 103, 1 24 103, 1 29 103
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"${PYTHON:-python3.11}" -m venv env
env/bin/pip install --quiet --no-compile bvhio==1.5.4 bvhsdk==0.2.1 numpy==2.4.6
npm install --silent --no-audit --no-fund three@0.187.0
cat >piston.bvh <<'BVH'
HIERARCHY
ROOT cylinder
{
  OFFSET 0 0 100
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT piston
  {
    OFFSET 0 10 0
    CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
    JOINT rod
    {
      OFFSET 0 5 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 0 1 0
      }
    }
  }
}
MOTION
Frames: 1
Frame Time: 0.1
1 2 3 0 0 0 0 12 0 0 0 0 0 0 0
BVH
cat >check.py <<'CHECK'
import bvhio
import bvhsdk

EXPECTED = "1 2 3, 1 14 3, 1 19 3"


def text(places):
    return ", ".join(" ".join(f"{value:.0f}" for value in place) for place in places)


root = bvhio.readAsHierarchy("piston.bvh")
root.loadPose(0)
animation = bvhsdk.ReadFile("piston.bvh")
for name, places in (("bvhio", [joint.PositionWorld for joint, _, _ in root.layout()]),
                     ("bvhsdk", [joint.getPosition(0) for joint in animation.getlistofjoints()])):
    print(f"{name}: {text(places)}")
    assert text(places) == EXPECTED
CHECK
cat >check.mjs <<'CHECK'
import assert from "node:assert";
import { readFileSync } from "node:fs";

import { AnimationMixer, Group, Vector3 } from "three";
import { BVHLoader } from "three/examples/jsm/loaders/BVHLoader.js";

const { skeleton, clip } = new BVHLoader().parse(readFileSync("piston.bvh", "utf8"));
const group = new Group().add(skeleton.bones[0]);
const mixer = new AnimationMixer(skeleton.bones[0]);
mixer.clipAction(clip).play();
mixer.setTime(0);
group.updateMatrixWorld(true);
const places = skeleton.bones.slice(0, 3).map((bone) => new Vector3().setFromMatrixPosition(bone.matrixWorld));
const text = places.map((place) => place.toArray().join(" ")).join(", ");
console.log(`three: ${text}`);
assert.equal(text, "1 2 103, 1 24 103, 1 29 103");
CHECK
env/bin/python check.py
node check.mjs
