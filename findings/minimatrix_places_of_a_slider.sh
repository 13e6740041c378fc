#!/usr/bin/env bash
# minimatrix-polyroots 3.0.5 (npm), roots of polynomials up to the fourth degree: the two places of a slider, and the
# four assemblies of a mechanism.
#
# Behaviour: the roots of x^2 - c are returned as +c and -c, without the square root. A rod of 5 on a crank pin at
# (0, 3) has its slider at +4 and -4; `getQuadraticRoots(1, 0, -16)` returns -16 and 16. With the pin at (1e-9, 3) they
# are 4 and -4. The cubic x^3 - c x is wrong in the same way. Quartics with four real roots, at least 0.5 apart, have
# five to ten roots in one of ten cases: copies, numbers that are no roots, infinity and NaN. Nothing is raised.
#
# Guess before: each root makes its polynomial zero up to rounding, and there are at most as many as the degree.
#
# Source: the README has an implementation of Kahan's numerically stable method for cubics, a finder of quadratic roots
# that it is based on, and one for quartics that is based on it in turn.
#
# Seen:
#   pin at (0, 3): -16 16
#   pin at (1e-9, 3): -4 4
#   x^3 - 25 x: -25 0 25
#   roots -4.1, 0.3, 1.5, 3.5: -Infinity -Infinity -4.1 0.3 0.55441 1.5 3.5 4.44559 NaN NaN
#   10000 quartics: 983 with more than four roots
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund minimatrix-polyroots@3.0.5 >npm.log
cat >check.cjs <<'CHECK'
const assert = require("node:assert");
const polyroots = require("minimatrix-polyroots");

const { getQuadraticRoots, getCubicRoots, getQuarticRoots } = polyroots.default ?? polyroots;
const ROD = 5, COUNT = 10000;

/** Coefficients of the polynomial with these roots, the highest power first. */
function coefficients(roots) {
  return roots.reduce((known, root) => {
    const next = [...known, 0];
    known.forEach((value, index) => { next[index + 1] -= root * value; });
    return next;
  }, [1]);
}

/** The real parts of roots, in order, as text. */
function shown(roots) {
  const parts = roots.map(({ real }) => real);
  const numbers = parts.filter((value) => !Number.isNaN(value)).sort((a, b) => a - b);
  return [...numbers, ...parts.filter(Number.isNaN)].map((value) => Number(value.toFixed(5))).join(" ");
}

function check(name, roots, expected) {
  console.log(`${name}: ${shown(roots)}`);
  assert.equal(shown(roots), expected);
}

const slider = (x, y) => getQuadraticRoots(1, -2 * x, x * x + y * y - ROD * ROD);
check("pin at (0, 3)", slider(0, 3), "-16 16");
check("pin at (1e-9, 3)", slider(1e-9, 3), "-4 4");
check("x^3 - 25 x", getCubicRoots(1, 0, -25, 0), "-25 0 25");
const found = getQuarticRoots(...coefficients([3.5, 0.3, -4.1, 1.5]));
check("roots -4.1, 0.3, 1.5, 3.5", found, "-Infinity -Infinity -4.1 0.3 0.55441 1.5 3.5 4.44559 NaN NaN");

let state = 1;

/** Four roots in tenths from -5 to 5, at least 0.5 apart. */
function apart() {
  const roots = [];
  while (roots.length < 4) {
    state = (state * 16807) % 2147483647;
    const next = (state % 101) / 10 - 5;
    if (roots.every((root) => Math.abs(root - next) > 0.49)) roots.push(next);
  }
  return roots;
}

const lengths = Array.from({ length: COUNT }, () => getQuarticRoots(...coefficients(apart())).length);
const many = lengths.filter((length) => length > 4).length;
console.log(`${COUNT} quartics: ${many} with more than four roots`);
assert(many > COUNT / 20);
CHECK
node check.cjs
