#!/usr/bin/env bash
# mathjs 15.2.0 (npm), `polynomialRoot`: the three roots of a cubic, as for strokes of some millimetres, in metres.
#
# Behaviour: for half of 2000 cubics with roots from -5 to 5 mm, at least 0.5 mm apart, the list has two roots in place
# of three in metres, as for a double root. Strokes of -0.1, 2.4 and 4.8 mm come out as 2.27 and 2.42 mm. In millimetres
# and in centimetres all are right. The discriminant counts as zero where both of its parts differ by less than 1e-15,
# and it grows with the sixth power of the roots. Nothing is raised.
#
# Guess before: rounding decides if roots are equal, so that a scale of the roots does not count.
#
# Source: the documentation of `polynomialRoot` has the distinct roots, by the standard formulas. Its source compares
# with `equalScalar`, whose absolute tolerance of 1e-15, `absTol` of the configuration, has no scale of the numbers.
# With an `absTol` of 0 the three strokes are right.
#
# Seen:
#   in mm: 2000 cubics, 0 without a root
#   in cm: 2000 cubics, 0 without a root
#   in m: 2000 cubics, 1051 without a root
#   strokes of -0.1, 2.4 and 4.8 mm in metres: 0.002267 0.002417
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund mathjs@15.2.0 >npm.log
cat >check.cjs <<'CHECK'
const assert = require("node:assert");
const { polynomialRoot } = require("mathjs");

const COUNT = 2000;

/** Coefficients of the polynomial with these roots, the constant first. */
function coefficients(roots) {
  return roots.reduce((known, root) => {
    const next = [0, ...known];
    known.forEach((value, index) => { next[index] -= root * value; });
    return next;
  }, [1]);
}

let state = 1;

/** Roots in tenths of a millimetre from -5 to 5 mm, at least 0.5 mm apart. */
function apart() {
  const roots = [];
  while (roots.length < 3) {
    state = (state * 16807) % 2147483647;
    const next = (state % 101) / 10 - 5;
    if (roots.every((root) => Math.abs(root - next) > 0.49)) roots.push(next);
  }
  return roots;
}

const found = (roots, unit) =>
  polynomialRoot(...coefficients(roots.map((root) => root / unit))).map((root) => root.re ?? root);
const isMissing = (roots, unit) => {
  const others = found(roots, unit);
  return roots.some((root) => others.every((other) => Math.abs(other * unit - root) > 0.01));
};
const cubics = Array.from({ length: COUNT }, apart);
const missing = {};
for (const [name, unit] of [["mm", 1], ["cm", 10], ["m", 1000]]) {
  missing[name] = cubics.filter((roots) => isMissing(roots, unit)).length;
  console.log(`in ${name}: ${COUNT} cubics, ${missing[name]} without a root`);
}
const strokes = found([-0.1, 2.4, 4.8], 1000).sort((a, b) => a - b);
console.log(`strokes of -0.1, 2.4 and 4.8 mm in metres: ${strokes.map((value) => value.toFixed(6)).join(" ")}`);
assert(missing.mm === 0 && missing.cm === 0 && missing.m > COUNT / 3);
assert.deepEqual(strokes.map((value) => Math.round(value * 1e6)), [2267, 2417]);
CHECK
node check.cjs
