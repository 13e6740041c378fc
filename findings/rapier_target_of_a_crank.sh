#!/usr/bin/env bash
# Rapier 0.21.0 (npm: rapier2d-compat, rapier3d-compat): a crank on a revolute joint that a motor turns by its angle.
#
# Behaviour: the crank follows a target that grows by 2 rad/s for one turn and a half. As soon as the target is beyond
# 3 pi, the crank runs away: at a target of 16 rad it has turned by more than 100 rad, in the plane, in space, and for
# the negative direction. A constant target of 9.4 rad is reached, as the same place of the next turn; a constant 12.566
# rad, two turns, keeps the crank turning for ever at more than 20 rad/s. The difference of target and angle, whose
# angle is between -pi and pi, is brought back by at most one turn.
#
# Guess before: the crank follows the target over all turns, or stands at the target less whole turns.
#
# Source: the type declarations list `configureMotorPosition(targetPos, stiffness, damping)` without a comment and
# without a range; `setLimits` beside it speaks of the joint's free coordinate.
#
# Seen:
#   2d, 2 rad/s: 1.8 3.8 5.8 7.8 15.2 51.0 96.3 142.8
#   2d, target 9.400: 3.117 rad, 0.00 rad/s
#   2d, target 12.566: 447.297 rad, 47.60 rad/s
#   3d: nearly the same; -2 rad/s: the same with the other sign
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

/** Turns a bar about its middle by a motor, and lists its summed angle and speed after each second. */
function crank({ World, RigidBodyDesc, ColliderDesc, JointData }, target, seconds) {
  const flat = World === plane.World;
  const zero = { x: 0, y: 0, ...(flat ? {} : { z: 0 }) };
  const world = new World(zero);
  const frame = world.createRigidBody(RigidBodyDesc.fixed());
  const bar = world.createRigidBody(RigidBodyDesc.dynamic());
  world.createCollider(flat ? ColliderDesc.cuboid(0.5, 0.1) : ColliderDesc.cuboid(0.5, 0.1, 0.1), bar);
  const axis = flat ? [] : [{ x: 0, y: 0, z: 1 }];
  const joint = world.createImpulseJoint(JointData.revolute(zero, zero, ...axis), frame, bar, true);
  const angle = () => (flat ? bar.rotation() : 2 * Math.atan2(bar.rotation().z, bar.rotation().w));
  const rows = [];
  let [sum, last] = [0, 0];
  for (let step = 1; step <= 60 * seconds; step += 1) {
    joint.configureMotorPosition(target(step / 60), 1000, 100);
    world.step();
    sum += Math.atan2(Math.sin(angle() - last), Math.cos(angle() - last));
    last = angle();
    if (step % 60 === 0) rows.push({ sum, speed: flat ? bar.angvel() : bar.angvel().z });
  }
  return rows;
}

for (const [name, engine] of Object.entries({ "2d": plane, "3d": space })) {
  for (const speed of [2, -2]) {
    const rows = crank(engine, (time) => speed * time, 8);
    console.log(`${name}, ${speed} rad/s: ${rows.map(({ sum }) => sum.toFixed(1)).join(" ")}`);
    assert(rows.slice(0, 4).every(({ sum }, index) => Math.abs(sum - speed * (index + 1)) < 0.4));
    assert(rows[7].sum * Math.sign(speed) > 100);
  }
  for (const target of [9.4, 4 * Math.PI]) {
    const { sum, speed } = crank(engine, () => target, 10).at(-1);
    console.log(`${name}, target ${target.toFixed(3)}: ${sum.toFixed(3)} rad, ${speed.toFixed(2)} rad/s`);
    assert(target < 3 * Math.PI ? Math.abs(sum - target + 2 * Math.PI) < 0.02 && Math.abs(speed) < 1e-3 : speed > 20);
  }
}
CHECK
node check.mjs 2>/dev/null
