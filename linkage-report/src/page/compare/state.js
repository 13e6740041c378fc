// The compared designs, the choice of those that are shown, and their position.

const data = JSON.parse(byId("comparison").textContent);
const CURVES = 7;
// The first designs are shown, and no more: lines over lines could not be told apart.
const AT_FIRST = 3;
const DASHES = [null, "7 3", "2 3", "9 3 2 3"];

const state = { shown: new Set([...data.designs.keys()].slice(0, AT_FIRST)), row: 0 };
const watchers = [];

function changed() {
  for (const watcher of watchers) watcher();
}

// One at least stays.
function toggle(index) {
  if (!state.shown.has(index)) state.shown.add(index);
  else if (state.shown.size > 1) state.shown.delete(index);
  changed();
}

function stand(row) {
  state.row = Math.min(Math.max(row, 0), data.input.values.length - 1);
  changed();
}

// In the order of the page, so that the others are still compared with the first one.
function shown() {
  return [...state.shown].sort((a, b) => a - b);
}

function hue(index) {
  return `var(--curve-${index % CURVES})`;
}

// Colours come again after the last one; dashes tell who has one for the second time.
function line(index) {
  return { stroke: hue(index), "stroke-dasharray": DASHES[Math.floor(index / CURVES) % DASHES.length] };
}

function swatch(index) {
  return shape("svg", { class: "swatch", viewBox: "0 0 26 10", "aria-hidden": "true" }, shape("path", { d: "M1 5H25", ...line(index) }));
}
