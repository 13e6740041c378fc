#!/usr/bin/env bash
# odex 2.0.4, npm: the places of a swing on a grid of times, integrated forwards and backwards.
#
# Behaviour: the solver integrates from 2 s to 0 s as well as from 0 s to 2 s, with an error of 1e-10 at the end. Its
# callback `grid(0.25, out)` calls `out` nine times forwards, and once backwards, for the start alone. The outcome is
# the same in both cases, `Converged`. With an own callback each step of the backward motion arrives. Nothing is
# raised.
#
# Guess before: nine times in both directions, or an error for a grid against its step.
#
# Source: the README introduces `grid` as a canned callback for a regular grid, without a direction. In src/odex.js,
# lines 53 to 85, the next time of the grid is `x + dt`, and points are made for times below that of the step.
#
# Seen:
#   forwards: 9 places, the last at 2.00 s, error at the end below 1e-9 true, outcome 0
#   backwards: 1 place, the last at 2.00 s, error at the end below 1e-9 true, outcome 0
#   backwards, own callback: the last step at 0.00 s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund odex@2.0.4
cat >check.mjs <<'CHECK'
import assert from "node:assert";

import { Solver } from "odex";

const END = 2;
const swing = (time, [angle, speed]) => [speed, -angle];
const state = (time) => [Math.cos(time), -Math.sin(time)];

function create() {
  const solver = new Solver(2);
  solver.absoluteTolerance = solver.relativeTolerance = 1e-11;
  solver.denseOutput = true;
  return solver;
}

for (const [name, from, to, count] of [["forwards", 0, END, 9], ["backwards", END, 0, 1]]) {
  const times = [];
  const solver = create();
  const grid = solver.grid(0.25, (time) => { times.push(time); });
  const { y, outcome } = solver.solve(swing, from, state(from), to, grid);
  const isClose = Math.abs(y[0] - Math.cos(to)) < 1e-9;
  console.log(`${name}: ${times.length} place${times.length > 1 ? "s" : ""}, the last at ${times.at(-1).toFixed(2)} s, ` +
    `error at the end below 1e-9 ${isClose}, outcome ${outcome}`);
  assert(isClose && times.length === count && outcome === 0);
}

let last;
create().solve(swing, END, state(END), 0, (step, before, time) => { last = time; });
console.log(`backwards, own callback: the last step at ${last.toFixed(2)} s`);
assert.equal(last, 0);
CHECK
node check.mjs
