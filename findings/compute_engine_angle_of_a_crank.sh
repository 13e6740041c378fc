#!/usr/bin/env bash
# @cortex-js/compute-engine 0.140.0 (npm), `solve`: the closing equation of a loop with one angle.
#
# Behaviour: `3 cos x + 4 sin x = 2` has the two assemblies 2.0866 and -0.2320 rad, and `solve` returns an empty list,
# the same as for `3 cos x + 4 sin x = 10`, which has none. So does `3 cos(x - 0.5) = 2`. For `3 cos x = 2` it returns
# both angles. Nothing is raised.
#
# Guess before: two roots, or null for an equation that the solver cannot treat, as it returns null for two circles.
#
# Source: the declaration of `solve` in types-expression.d.ts has "For univariate equations, returns an array of
# solutions (roots)", and null as another possible result.
#
# Seen:
#   3 cos x = 2: 0.8411 -0.8411
#   3 cos x + 4 sin x = 2: none, although 2.0866 and -0.2320 solve it
#   3 cos(x - 0.5) = 2: none, although 1.3411 and -0.3411 solve it
#   3 cos x + 4 sin x = 10: none
#   two circles that meet: null
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund @cortex-js/compute-engine@0.140.0 >npm.log
cat >check.mjs <<'CHECK'
import assert from "node:assert";
import { ComputeEngine } from "@cortex-js/compute-engine";

const engine = new ComputeEngine();
const sum = ["Add", ["Multiply", 3, ["Cos", "x"]], ["Multiply", 4, ["Sin", "x"]]];
const lag = Math.atan2(4, 3);
const cases = [
  ["3 cos x = 2", ["Multiply", 3, ["Cos", "x"]], 2, [Math.acos(2 / 3), -Math.acos(2 / 3)], 2],
  ["3 cos x + 4 sin x = 2", sum, 2, [lag + Math.acos(2 / 5), lag - Math.acos(2 / 5)], 0],
  ["3 cos(x - 0.5) = 2", ["Multiply", 3, ["Cos", ["Subtract", "x", 0.5]]], 2,
    [0.5 + Math.acos(2 / 3), 0.5 - Math.acos(2 / 3)], 0],
  ["3 cos x + 4 sin x = 10", sum, 10, [], 0],
];
for (const [name, left, right, roots, count] of cases) {
  const found = engine.expr(["Equal", left, right]).solve("x").map((root) => root.N().re.toFixed(4));
  const exact = roots.map((root) => root.toFixed(4));
  const rest = exact.length > 0 ? `none, although ${exact.join(" and ")} solve it` : "none";
  console.log(`${name}: ${found.length > 0 ? found.join(" ") : rest}`);
  for (const root of roots) assert(Math.abs(engine.expr(left).subs({ x: root }).N().re - right) < 1e-12);
  assert.equal(found.length, count);
}
const circle = (x) => ["Equal", ["Add", ["Power", ["Subtract", "x", x], 2], ["Power", "y", 2]], 25];
const both = engine.expr(["List", circle(0), circle(6)]).solve(["x", "y"]);
console.log(`two circles that meet: ${both}`);
assert.equal(both, null);
CHECK
node check.mjs
