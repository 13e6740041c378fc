#!/usr/bin/env bash
# Rapier 0.21.0 (npm: rapier2d-compat, rapier3d-compat): bodies that are placed in a pose and then joined.
#
# Behaviour: a multibody joint forgets the pose. A crank that is placed at 0.5 rad is at 0 rad after one step without
# forces, in the plane and in space; an impulse joint keeps it at 0.5 rad. A four-bar that is placed in a closed pose,
# with three multibody joints and one impulse joint for the loop, jumps into the row of its links. Its loop has a gap
# of 0.7 there, for a crank of 0.5, which is the same after five seconds. With four impulse joints the gap stays below
# 1e-3. Nothing is thrown or printed.
#
# Guess before: the coordinates of a multibody joint are taken from the bodies, as an impulse joint does, and the loop
# closes.
#
# Source: the declarations describe `createMultibodyJoint` and `createImpulseJoint` with the same parameters and name no
# pose.
#
# Seen:
#   2d, impulse joint: 0.5000 rad; multibody joint: 0.0000 rad
#   3d, impulse joint: 0.5000 rad; multibody joint: 0.0000 rad
#   four-bar of impulse joints: gap 0.0000
#   four-bar of multibody joints, closed by an impulse joint: gap 0.7000 at first, 0.7000 after 5 s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund @dimforge/rapier2d-compat@0.21.0 @dimforge/rapier3d-compat@0.21.0 >npm.log
cat >check.mjs <<'CHECK'
import assert from "node:assert";
import * as plane from "@dimforge/rapier2d-compat";
import * as space from "@dimforge/rapier3d-compat";

await plane.init();
await space.init();
const PHI = 0.5;

/** The angle of a crank of length 1 that is placed at `PHI`, after one step without forces. */
function inPlane(create) {
  const world = new plane.World({ x: 0, y: 0 });
  const frame = world.createRigidBody(plane.RigidBodyDesc.fixed());
  const [x, y] = [Math.cos(PHI) / 2, Math.sin(PHI) / 2];
  const crank = world.createRigidBody(plane.RigidBodyDesc.dynamic().setTranslation(x, y).setRotation(PHI));
  world.createCollider(plane.ColliderDesc.cuboid(0.5, 0.02), crank);
  world[create](plane.JointData.revolute({ x: 0, y: 0 }, { x: -0.5, y: 0 }), frame, crank, true);
  world.step();
  return crank.rotation();
}

function inSpace(create) {
  const world = new space.World({ x: 0, y: 0, z: 0 });
  const frame = world.createRigidBody(space.RigidBodyDesc.fixed());
  const half = { x: 0, y: 0, z: Math.sin(PHI / 2), w: Math.cos(PHI / 2) };
  const place = [Math.cos(PHI) / 2, Math.sin(PHI) / 2, 0];
  const crank = world.createRigidBody(space.RigidBodyDesc.dynamic().setTranslation(...place).setRotation(half));
  world.createCollider(space.ColliderDesc.cuboid(0.5, 0.02, 0.02), crank);
  const ends = [{ x: 0, y: 0, z: 0 }, { x: -0.5, y: 0, z: 0 }, { x: 0, y: 0, z: 1 }];
  world[create](space.JointData.revolute(...ends), frame, crank, true);
  world.step();
  return 2 * Math.atan2(crank.rotation().z, crank.rotation().w);
}

/** The largest gap between coupler and rocker after the first step, and from then on for five seconds. */
function fourBar(create) {
  const [crank, coupler, rocker, base] = [0.5, 1.2, 1.0, 1.4];
  const pin = [crank * Math.cos(PHI), crank * Math.sin(PHI)];
  const distance = Math.hypot(base - pin[0], pin[1]);
  const inner = Math.acos((coupler ** 2 + distance ** 2 - rocker ** 2) / (2 * coupler * distance));
  const theta = Math.atan2(-pin[1], base - pin[0]) + inner;
  const psi = Math.atan2(pin[1] + coupler * Math.sin(theta), pin[0] + coupler * Math.cos(theta) - base);
  const world = new plane.World({ x: 0, y: 0 });
  const frame = world.createRigidBody(plane.RigidBodyDesc.fixed());
  const links = [[crank, PHI, 0, 0], [coupler, theta, ...pin], [rocker, psi, base, 0]];
  const [a, b, c] = links.map(([length, turn, x, y]) => {
    const place = [x + (length / 2) * Math.cos(turn), y + (length / 2) * Math.sin(turn)];
    const body = world.createRigidBody(plane.RigidBodyDesc.dynamic().setTranslation(...place).setRotation(turn));
    world.createCollider(plane.ColliderDesc.cuboid(length / 2, 0.02).setCollisionGroups(0x00010000), body);
    return body;
  });
  const join = (how, first, x, second, other) =>
    world[how](plane.JointData.revolute({ x, y: 0 }, { x: other, y: 0 }), first, second, true);
  join(create, frame, 0, a, -crank / 2);
  join(create, a, crank / 2, b, -coupler / 2);
  join(create, frame, base, c, -rocker / 2);
  join("createImpulseJoint", b, coupler / 2, c, rocker / 2);
  const end = (body, x) => {
    const [{ x: left, y: up }, turn] = [body.translation(), body.rotation()];
    return [left + x * Math.cos(turn), up + x * Math.sin(turn)];
  };
  const gaps = [];
  for (let step = 0; step < 300; step += 1) {
    world.step();
    const [first, second] = [end(b, coupler / 2), end(c, rocker / 2)];
    gaps.push(Math.hypot(first[0] - second[0], first[1] - second[1]));
  }
  return [gaps[0], gaps.at(-1), Math.max(...gaps)];
}

for (const [name, crank] of [["2d", inPlane], ["3d", inSpace]]) {
  const [kept, lost] = [crank("createImpulseJoint"), crank("createMultibodyJoint")];
  console.log(`${name}, impulse joint: ${kept.toFixed(4)} rad; multibody joint: ${lost.toFixed(4)} rad`);
  assert(Math.abs(kept - PHI) < 1e-5 && Math.abs(lost) < 1e-5);
}
const [, , closed] = fourBar("createImpulseJoint");
console.log(`four-bar of impulse joints: gap ${closed.toFixed(4)}`);
const [first, last] = fourBar("createMultibodyJoint");
console.log("four-bar of multibody joints, closed by an impulse joint: "
  + `gap ${first.toFixed(4)} at first, ${last.toFixed(4)} after 5 s`);
assert(closed < 1e-3 && first > 0.5 && last > 0.5);
CHECK
node check.mjs 2>/dev/null
