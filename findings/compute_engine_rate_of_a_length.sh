#!/usr/bin/env bash
# @cortex-js/compute-engine 0.140.0 (npm): the derivative of the length of a cylinder, as the norm of a vector.
#
# Behaviour: the norm of a list of two coordinates is a number, and its derivative is a list of two: the derivatives of
# the absolute values of both. A cylinder from a pin to a crank of 3 has the length 7.77 at 0.5 rad, and the rate
# [-1.44, 2.63] in place of -0.93. The list has a value everywhere, and nothing is raised. The derivative of the square
# root of the sum of squares is right, and those of `Hypot` and `Dot` stay symbolic.
#
# Guess before: the derivative of a number is a number, the product of the unit vector and the rate of the coordinates,
# or an expression that is not evaluated.
#
# Source: `Norm` is the Euclidean norm of a vector, as its value shows. The derivative maps over the elements of the
# list and has the one of `Abs` for each.
#
# Seen:
#   norm: 7.7671 at 0.5, rate [-1.4383, 2.6327], by differences -0.9259
#   root of squares: 7.7671 at 0.5, rate -0.9259
#   hypot: 7.7671 at 0.5, rate symbolic
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund @cortex-js/compute-engine@0.140.0 >npm.log
cat >check.mjs <<'CHECK'
import assert from "node:assert";
import { ComputeEngine } from "@cortex-js/compute-engine";

const engine = new ComputeEngine();
const x = ["Add", 5, ["Multiply", 3, ["Cos", "t"]]];
const y = ["Multiply", 3, ["Sin", "t"]];
const at = (expression, t) => engine.expr(expression).subs({ t }).N();
const rate = (expression) => engine.expr(["D", expression, "t"]).evaluate().subs({ t: 0.5 }).N();

const norm = ["Norm", ["List", x, y]];
const differences = (at(norm, 0.50001).re - at(norm, 0.49999).re) / 2e-5;
const list = rate(norm).ops.map((value) => value.re.toFixed(4));
console.log(`norm: ${at(norm, 0.5).re.toFixed(4)} at 0.5, rate [${list.join(", ")}], `
  + `by differences ${differences.toFixed(4)}`);
const root = ["Sqrt", ["Add", ["Power", x, 2], ["Power", y, 2]]];
console.log(`root of squares: ${at(root, 0.5).re.toFixed(4)} at 0.5, rate ${rate(root).re.toFixed(4)}`);
const hypot = ["Hypot", x, y];
const isSymbolic = JSON.stringify(rate(hypot).json).includes("Derivative");
console.log(`hypot: ${at(hypot, 0.5).re.toFixed(4)} at 0.5, rate ${isSymbolic ? "symbolic" : rate(hypot).re}`);
assert.equal(rate(norm).operator, "List");
assert.deepEqual(list, ["-1.4383", "2.6327"]);
assert(Math.abs(differences - rate(root).re) < 1e-6 && isSymbolic);
CHECK
node check.mjs
