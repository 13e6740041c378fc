// Another report of the same structure in the place of the one that is shown: the elements stay, and their numbers are exchanged.

const renewal = { fixed: null };

// Shows another report with the data of its programs. False if it needs other elements: nothing is changed then. `isFrozen` holds the picture's size
// and position. Throws the errors of the engine.
function renewed(text, programs, isFrozen) {
  const other = reportFrom(text);
  const units = programs.map(engine.revived);
  renewal.fixed ??= fixedPart(report, engine.programs);
  if (isStanding() || fixedPart(other, units) !== renewal.fixed) return false;
  const modes = modesOf(other, units);
  const assemblies = assembledOf(units, new Map(other.dimensions.map(({ name, value }) => [name, value])), modes, []);
  exchange(text, other, units);
  live.modes = live.firstModes = modes;
  beginWithReport(assemblies);
  showRenewed(isFrozen);
  return true;
}

// Everything that elements are made of, as text. The rest is numbers that are shown again after each change.
function fixedPart({ tables, true: rates, bands, picture: shown, summary, accuracy, gaps, dimensions, live: computed, reason, changePoints, ...rest }, units) {
  const heads = tables.map(({ columns: all, ...table }) => [table, all.map(({ values: numbers, ...column }) => [column, numbers.some((x) => x !== null)])]);
  const withoutNumbers = (series) => (series ?? []).map(({ values: numbers, half, ...head }) => head);
  const places = shown && { ...shown, points: shown.points.map(({ at, ...point }) => point), directions: shown.directions.length };
  const programs = units.map(({ name, inputs, arguments: given, coupled, modes }) => [name, inputs.map(({ reference, ...head }) => head), given, coupled.length > 0, modes.length]);
  return JSON.stringify([
    rest, heads, withoutNumbers(rates), withoutNumbers(bands), places, summary.length > 0, accuracy.map(({ quantity, unit }) => [quantity, unit]),
    dimensions.map(({ name, unit }) => [name, unit]), Object.keys(computed.given), computed.picture, programs,
  ]);
}

// The numbers of the other report in the lists of this one, to which all parts of the page refer.
function exchange(text, other, units) {
  const theirs = allNumbers(other);
  allNumbers(report).forEach((numbers, k) => theirs[k].forEach((value, row) => (numbers[row] = value)));
  const { summary, accuracy, gaps, dimensions, live: computed } = other;
  Object.assign(report, { summary, accuracy, gaps, dimensions, live: computed });
  source = text;
  byId("report").textContent = text;
  engine.programs.splice(0, Infinity, ...units);
  Object.assign(live, stateOf(report, theirs));
  effects.clear();
  forgetRefusals();
  choices.of = null;
  Object.assign(past, { steps: [], next: [], last: snapshot() });
}

function showRenewed(isFrozen) {
  for (const row of controls.rows.values()) centre(row);
  if (picture) renewPicture(isFrozen);
  showChange();
  showControls();
  showChanges();
}

function renewPicture(isFrozen) {
  reaches.clear();
  ghost.ofReport = placesNow();
  if (kept.columns === null) ghost.places = ghost.ofReport;
  for (const [index, node] of drawing.points) node.classList.toggle("moving", isMoving(index));
  if (isFrozen) return;
  camera.box = extent();
  showScale();
}
