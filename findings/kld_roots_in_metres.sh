#!/usr/bin/env bash
# kld-polynomial 0.3.0 (npm), real roots of polynomials: sextics, as for the points where the coupler curve of a
# four-bar crosses a line, in millimetres and in metres.
#
# Behaviour: `getRootsInInterval` returns the six roots of a sextic in millimetres, and other numbers in metres: the
# lower end of the interval, pairs of equal numbers, and roots that are off by millimetres. It takes a place for a root
# where the polynomial is below 1e-6, which a sextic with roots of some centimetres is at most places in metres. Of 500
# sextics with roots from -50 to 50 mm, all are wrong in metres, half in decimetres, and none in millimetres.
#
# Guess before: roots are found to a share of their size or of the interval, so that a unit changes nothing but
# rounding.
#
# Source: the README lists the function without a tolerance. `bisection` in lib/Polynomial.js has 1e-6 as the default of
# a parameter, which it compares with the value of the polynomial; its callers in the package do not give another one.
#
# Seen:
#   in mm: 500 sextics, 0 wrong, the first one in mm -39 -31 -19 -9 15 22
#   in cm: 500 sextics, 0 wrong, the first one in mm -39 -31 -19 -9 15 22
#   in dm: 500 sextics, 246 wrong, the first one in mm -39 -31.11 -18.83 -8.88 14.97 21.97
#   in m: 500 sextics, 500 wrong, the first one in mm -60 -31.19 -31.19 -19.05 -1.71 14.16
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund kld-polynomial@0.3.0 >npm.log
cat >check.cjs <<'CHECK'
const assert = require("node:assert");
const { Polynomial } = require("kld-polynomial");

const COUNT = 500, DEGREE = 6, END = 60;

/** Coefficients of the polynomial with these roots, the highest power first. */
function coefficients(roots) {
  return roots.reduce((known, root) => {
    const next = [...known, 0];
    known.forEach((value, index) => { next[index + 1] -= root * value; });
    return next;
  }, [1]);
}

let state = 1;

/** Roots in whole millimetres from -50 to 50, at least 5 apart. */
function apart() {
  const roots = [];
  while (roots.length < DEGREE) {
    state = (state * 16807) % 2147483647;
    const next = (state % 101) - 50;
    if (roots.every((root) => Math.abs(root - next) >= 5)) roots.push(next);
  }
  return roots.sort((a, b) => a - b);
}

/** The roots that are found in a unit of so many millimetres, in millimetres and in order. */
function found(roots, unit) {
  const polynomial = new Polynomial(...coefficients(roots.map((root) => root / unit)));
  return polynomial.getRootsInInterval(-END / unit, END / unit).map((root) => root * unit).sort((a, b) => a - b);
}

const sextics = Array.from({ length: COUNT }, apart);
const isRight = (roots, others) =>
  others.length === DEGREE && others.every((root, index) => Math.abs(root - roots[index]) < 0.1);
const wrong = {};
for (const [name, unit] of [["mm", 1], ["cm", 10], ["dm", 100], ["m", 1000]]) {
  const all = sextics.map((roots) => found(roots, unit));
  wrong[name] = all.filter((others, index) => !isRight(sextics[index], others)).length;
  console.log(`in ${name}: ${COUNT} sextics, ${wrong[name]} wrong, the first one in mm ` +
    all[0].map((root) => Number(root.toFixed(2))).join(" "));
}
assert(wrong.mm === 0 && wrong.cm === 0 && wrong.dm > COUNT / 10 && wrong.m === COUNT);
CHECK
node check.cjs
