#!/usr/bin/env bash
# nerdamer 1.1.13 (npm), symbolic computation: the derivative of a direction `atan2(y, x)`.
#
# Behaviour: the derivative is the one with respect to the first argument alone. `diff(atan2(2, x), x)` is 0, and the
# direction of a crank, `atan2(sin(t), cos(t))`, changes by cos(t)^2 in place of 1. The direction of a rod that is held
# at (-2, 0) and led by a crank of 3 is off by 21 % at 0.6 rad. Nothing is printed. The values of `atan2` are right, and
# so is the derivative of `atan(y/x)`.
#
# Guess before: both arguments count, or the derivative stays a symbol, as that of `max(x, 0)` does.
#
# Source: the README has `diff` for derivatives, and names no function that it cannot differentiate. The rule of `atan2`
# in Calculus.js has the partial derivative of the first argument, and the chain rule goes on with that one alone.
#
# Seen:
#   atan2(2,x): slope 0.000000, of the values -0.458716
#   atan2(x,2): slope 0.458716, of the values 0.458716
#   atan2(sin(x),cos(x)): slope 0.681179, of the values 1.000000
#   atan2(3*sin(x),2+3*cos(x)): slope 0.483872, of the values 0.609151
#   atan(3*sin(x)/(2+3*cos(x))): slope 0.609151, of the values 0.609151
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund nerdamer@1.1.13 >npm.log
cat >check.cjs <<'CHECK'
const assert = require("node:assert");
const nerdamer = require("nerdamer/all");

const AT = 0.6;
const STEP = 1e-5;
const value = (text, x) => Number(nerdamer(text, { x }).evaluate().text("decimals"));

/** Whether the derivative agrees with the quotient of differences. */
function isRight(text) {
  const slope = value(nerdamer.diff(text, "x").toString(), AT);
  const quotient = (value(text, AT + STEP) - value(text, AT - STEP)) / (2 * STEP);
  console.log(`${text}: slope ${slope.toFixed(6)}, of the values ${quotient.toFixed(6)}`);
  return Math.abs(slope - quotient) < 1e-6;
}

assert.equal(nerdamer.diff("atan2(2,x)", "x").toString(), "0");
const found = ["atan2(2,x)", "atan2(x,2)", "atan2(sin(x),cos(x))", "atan2(3*sin(x),2+3*cos(x))",
  "atan(3*sin(x)/(2+3*cos(x)))"].map(isRight);
assert.deepEqual(found, [false, true, false, false, true]);
CHECK
node check.cjs
