#!/usr/bin/env bash
# @salusoft89/planegcs 1.3.0, the 2D constraint solver of FreeCAD in WebAssembly: mechanisms that are drawn at a dead
# point.
#
# Behaviour: the list of conflicting constraints depends on the drawn pose. A slider-crank that is drawn at its dead
# point and driven to a stroke within its reach has the conflicting constraints `crank`, `rod` and `drive`,
# and the solver fails. Drawn a little away from the dead point, it has none and is solved. A parallelogram that is
# drawn flat and driven to 10 degrees is solved, with the status of success, and has three conflicting constraints.
# A caller who deletes a conflicting constraint removes a link of a correct mechanism.
#
# A fair guess: constraints conflict if they have no common solution, so a drawing that was solved has no conflict.
#
# Source: the README does not name the list. `has_gcs_conflicting_constraints` and
# `get_gcs_conflicting_constraints` are declared beside the redundant ones, without a comment.
#
# Seen:
#   slider at its dead point, stroke 2.9: status 2, gap 0.1000, conflicting crank rod drive
#   slider 1 degree away, stroke 2.9: status 0, gap 0.0000, conflicting none
#   flat parallelogram, 10 degrees: status 0, gap 0.0000, conflicting a b c
#   parallelogram at 1 degree, 10 degrees: status 0, gap 0.0000, conflicting none
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund @salusoft89/planegcs@1.3.0 >npm.log
cat >check.mjs <<'CHECK'
import assert from "node:assert";
import { GcsWrapper, SolveStatus, init_planegcs_module } from "@salusoft89/planegcs";

const module = await init_planegcs_module();
const DEGREE = Math.PI / 180;

const point = (id, [x, y], fixed = false) => ({ id, type: "point", x, y, fixed });
const distance = (id, p1_id, p2_id, value) => ({ id, type: "p2p_distance", p1_id, p2_id, distance: value });

/** Solves a drawing, and returns the status, the largest error of a distance and the conflicting constraints. */
function solve(primitives) {
  const wrapper = new GcsWrapper(new module.GcsSystem());
  wrapper.push_primitives_and_params(primitives);
  const status = wrapper.solve();
  wrapper.apply_solution();
  const solved = Object.fromEntries(wrapper.sketch_index.get_primitives().map((item) => [item.id, item]));
  const errors = primitives.filter(({ type }) => type === "p2p_distance").map(({ p1_id, p2_id, distance: wanted }) =>
    Math.abs(Math.hypot(solved[p1_id].x - solved[p2_id].x, solved[p1_id].y - solved[p2_id].y) - wanted));
  const conflicting = wrapper.get_gcs_conflicting_constraints();
  wrapper.destroy_gcs_module();
  return { status, gap: Math.max(...errors), conflicting };
}

/** A crank of 1 and a rod of 2, drawn at an angle of the crank, whose slider is driven to a stroke. */
function slider(angle, stroke) {
  const [x, y] = [Math.cos(angle), Math.sin(angle)];
  return [point("O", [0, 0], true), point("X", [9, 0], true), point("A", [x, y]),
    point("B", [x + Math.sqrt(4 - y * y), 0]), { id: "line", type: "line", p1_id: "O", p2_id: "X" },
    distance("crank", "O", "A", 1), distance("rod", "A", "B", 2),
    { id: "guide", type: "point_on_line_pl", p_id: "B", l_id: "line" }, distance("drive", "O", "B", stroke)];
}

/** A parallelogram with cranks of 1 and a base of 3, drawn at an angle and driven to another one. */
function parallelogram(angle, target) {
  const [x, y] = [Math.cos(angle), Math.sin(angle)];
  return [point("O", [0, 0], true), point("Q", [3, 0], true), point("A", [x, y]), point("B", [x + 3, y]),
    distance("a", "O", "A", 1), distance("b", "A", "B", 3), distance("c", "B", "Q", 1),
    { id: "motor", type: "p2p_angle", p1_id: "O", p2_id: "A", angle: target }];
}

function check(name, primitives, status, conflicting) {
  const found = solve(primitives);
  const list = found.conflicting.join(" ") || "none";
  console.log(`${name}: status ${found.status}, gap ${found.gap.toFixed(4)}, conflicting ${list}`);
  assert.equal(found.status, status);
  assert.equal(found.gap < 1e-6, status === SolveStatus.Success);
  assert.equal(list, conflicting);
}

check("slider at its dead point, stroke 2.9", slider(0, 2.9), SolveStatus.Failed, "crank rod drive");
check("slider 1 degree away, stroke 2.9", slider(DEGREE, 2.9), SolveStatus.Success, "none");
check("flat parallelogram, 10 degrees", parallelogram(0, 10 * DEGREE), SolveStatus.Success, "a b c");
check("parallelogram at 1 degree, 10 degrees", parallelogram(DEGREE, 10 * DEGREE), SolveStatus.Success, "none");
CHECK
node check.mjs | grep -v -e "Sketcher" -e '^$'
