#!/usr/bin/env bash
# planck 1.4.2, Box2D 2.3.10 (Python), pymunk 7.3.1, p2-es 1.2.3 and cannon-es 0.20.0: a motor and a pair of gears.
#
# Behaviour: a motor of 1 rad/s between the frame, as body A, and a wheel, as body B, turns the wheel by 10 rad in ten
# seconds in planck and Box2D, and by -10 rad in pymunk, p2-es and cannon-es. A gear of ratio 2 from that wheel to a
# second one turns the second at -1/2 of its speed in planck and Box2D, at +1/2 in pymunk, and at +2 in p2-es.
#
# Guess before: a positive motor turns body B to the left relative to body A, and the ratio is the speed of B over the
# speed of A, as in p2-es, or minus that for gears that mesh.
#
# Source: Box2D's reference has coordinate1 + ratio * coordinate2 as the constant. pymunk's text says that the ratio is
# "always measured in absolute terms"; p2-es calls it "the gear ratio". No text of a motor has a sign.
#
# Seen:
#   planck: first 10.00, second -5.00
#   Box2D: first 10.00, second -5.00
#   pymunk: first -9.98, second -4.99
#   p2-es: first -10.00, second -19.99
#   cannon-es: first -10.00
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3.11}" -m venv "$folder/env"
"$folder/env/bin/pip" install --quiet Box2D==2.3.10 pymunk==7.3.1
cd "$folder"
npm install --silent --no-audit --no-fund planck@1.4.2 p2-es@1.2.3 cannon-es@0.20.0 >npm.log
cat >check.py <<'CHECK'
import Box2D
import pymunk

STEPS, STEP = 600, 1 / 60


def in_box2d():
    world = Box2D.b2World(gravity=(0, 0))
    frame = world.CreateStaticBody()
    wheels = [world.CreateDynamicBody(position=(x, 0)) for x in (0, 3)]
    for wheel in wheels:
        wheel.CreateCircleFixture(radius=0.5, density=1)
    motor = {"enableMotor": True, "motorSpeed": 1, "maxMotorTorque": 1e4}
    joints = [world.CreateRevoluteJoint(bodyA=frame, bodyB=wheel, anchor=wheel.position, **options)
              for wheel, options in zip(wheels, (motor, {}))]
    world.CreateGearJoint(bodyA=wheels[0], bodyB=wheels[1], joint1=joints[0], joint2=joints[1], ratio=2)
    for _ in range(STEPS):
        world.Step(STEP, 8, 3)
    return [wheel.angle for wheel in wheels]


def in_pymunk():
    space = pymunk.Space()
    wheels = [pymunk.Body(1, 1) for _ in range(2)]
    wheels[1].position = 3, 0
    space.add(*wheels, *(pymunk.PivotJoint(space.static_body, wheel, wheel.position) for wheel in wheels),
              pymunk.SimpleMotor(space.static_body, wheels[0], 1.0), pymunk.GearJoint(*wheels, 0.0, 2))
    for _ in range(STEPS):
        space.step(STEP)
    return [wheel.angle for wheel in wheels]


for name, (first, second), sign, ratio in (("Box2D", in_box2d(), 1, -0.5), ("pymunk", in_pymunk(), -1, 0.5)):
    print(f"{name}: first {first:.2f}, second {second:.2f}")
    assert abs(first - 10 * sign) < 0.1 and abs(second / first - ratio) < 0.01
CHECK
cat >check.mjs <<'CHECK'
import assert from "node:assert";
import * as cannon from "cannon-es";
import * as p2 from "p2-es";
import * as planck from "planck";

const [STEPS, STEP] = [600, 1 / 60];

function inPlanck() {
  const world = new planck.World({ gravity: { x: 0, y: 0 } });
  const frame = world.createBody();
  const wheels = [0, 3].map((x) => world.createDynamicBody({ x, y: 0 }));
  wheels.forEach((wheel) => wheel.createFixture(new planck.Circle(0.5), { density: 1 }));
  const joints = [{ enableMotor: true, motorSpeed: 1, maxMotorTorque: 1e4 }, {}].map((options, index) =>
    world.createJoint(new planck.RevoluteJoint(options, frame, wheels[index], wheels[index].getPosition())));
  world.createJoint(new planck.GearJoint({}, ...wheels, ...joints, 2));
  for (let count = 0; count < STEPS; count += 1) world.step(STEP);
  return wheels.map((wheel) => wheel.getAngle());
}

function inP2() {
  const world = new p2.World({ gravity: [0, 0] });
  const frame = new p2.Body({ mass: 0 });
  const wheels = [0, 3].map((x) => new p2.Body({ mass: 1, position: [x, 0], angularDamping: 0 }));
  wheels.forEach((wheel) => wheel.addShape(new p2.Circle({ radius: 0.5 })));
  [frame, ...wheels].forEach((body) => world.addBody(body));
  const joints = wheels.map((wheel) => new p2.RevoluteConstraint(frame, wheel, { worldPivot: [...wheel.position] }));
  joints.forEach((joint) => world.addConstraint(joint));
  joints[0].enableMotor();
  joints[0].setMotorSpeed(1);
  world.addConstraint(new p2.GearConstraint(...wheels, { ratio: 2 }));
  for (let count = 0; count < STEPS; count += 1) world.step(STEP);
  return wheels.map((wheel) => wheel.angle);
}

function inCannon() {
  const world = new cannon.World({ gravity: new cannon.Vec3(0, 0, 0) });
  const frame = new cannon.Body({ mass: 0 });
  const wheel = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.5), angularDamping: 0 });
  [frame, wheel].forEach((body) => world.addBody(body));
  const axis = new cannon.Vec3(0, 0, 1);
  const hinge = new cannon.HingeConstraint(frame, wheel, { axisA: axis, axisB: axis });
  world.addConstraint(hinge);
  hinge.enableMotor();
  hinge.setMotorSpeed(1);
  let sum = 0;
  for (let count = 0; count < STEPS; count += 1) {
    world.step(STEP);
    sum += wheel.angularVelocity.z * STEP;
  }
  return [sum];
}

for (const [name, angles, sign, ratio] of [["planck", inPlanck(), 1, -0.5], ["p2-es", inP2(), -1, 2]]) {
  console.log(`${name}: first ${angles[0].toFixed(2)}, second ${angles[1].toFixed(2)}`);
  assert(Math.abs(angles[0] - 10 * sign) < 0.1 && Math.abs(angles[1] / angles[0] - ratio) < 0.01);
}
const [turned] = inCannon();
console.log(`cannon-es: first ${turned.toFixed(2)}`);
assert(Math.abs(turned + 10) < 0.1);
CHECK
node check.mjs 2>/dev/null
env/bin/python check.py
