#!/usr/bin/env bash
# interval-arithmetic 1.1.3 (npm): the cosine of an angle of several turns, and an angle modulo a turn.
#
# Behaviour: the interval for cos(-100) does not contain it, though the one for cos(100) does. Bounds are 3e-16 apart
# and 2e-15 off; for -10000 rad they are 7e-14 off, and the error grows with the angle. Of the whole degrees from -10
# to -1 turns, 1479 of 3241 have a cosine outside of their interval; of the positive ones none. `fmod` of the interval
# 350 to 370 degrees by a turn is 350 to 370: it contains neither 0 nor 5, which is 365 modulo 360.
#
# Guess before: each result contains all values, only wider than needed for large angles; the angle modulo a turn is
# 0 to 360.
#
# Source: the text of `round.disable`: most operations carry the rounding error, "so that the resulting interval
# correctly represents all the possible values". The text of `fmod` gives x - k * y, with one k for all x.
#
# Seen:
#   cos(100): 0.8623188722876738 to 0.8623188722876977, contains 0.8623188722876839
#   cos(-100): 0.8623188722876858 to 0.8623188722876861, does not contain 0.8623188722876839
#   cos(-10000): -0.952155368259087 to -0.9521553682590865, does not contain -0.9521553682590148
#   degrees from -10 to -1 turns: 1479 of 3241 missed; from 1 to 10 turns: 0
#   350 to 370 modulo 360: 349.99999999999994 to 370.00000000000006
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund interval-arithmetic@1.1.3 >npm.log
cat >check.cjs <<'CHECK'
const assert = require("node:assert");
const Interval = require("interval-arithmetic").default;

/** Cosines to 18 digits. */
const COSINES = { 100: 0.862318872287683934, 10000: -0.952155368259014851 };
const contains = ({ lo, hi }, value) => lo <= value && value <= hi;

for (const [angle, sign, right] of [[100, 1, true], [100, -1, false], [10000, 1, true], [10000, -1, false]]) {
  const found = Interval.cos(Interval(sign * angle));
  const verb = contains(found, COSINES[angle]) ? "contains" : "does not contain";
  console.log(`cos(${sign * angle}): ${found.lo} to ${found.hi}, ${verb} ${COSINES[angle]}`);
  assert.strictEqual(contains(found, COSINES[angle]), right);
}
/* One unit of the last place is left to `Math.cos`. */
const missed = { [-1]: 0, 1: 0 };
for (let degrees = 360; degrees <= 3600; degrees += 1) {
  const angle = (degrees * Math.PI) / 180;
  for (const sign of [-1, 1]) {
    const { lo, hi } = Interval.cos(Interval(sign * angle));
    const off = Math.max(lo - Math.cos(angle), Math.cos(angle) - hi);
    missed[sign] += off > 2 ** -52;
  }
}
console.log(`degrees from -10 to -1 turns: ${missed[-1]} of 3241 missed; from 1 to 10 turns: ${missed[1]}`);
assert(missed[-1] > 100 && missed[1] === 0);
const turned = Interval.fmod(Interval(350, 370), Interval(360));
console.log(`350 to 370 modulo 360: ${turned.lo} to ${turned.hi}`);
assert(!contains(turned, 365 % 360) && !contains(turned, 0));
CHECK
node check.cjs
