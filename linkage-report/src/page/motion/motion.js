// The motion with other dimensions, loads and starts: computed again, into the rows of the report.

// A motion takes no more steps here: a page answers within a second.
const MOST_MOTION_STEPS = 100000;

// Words about the end of the current motion; null for the whole time.
const motionEnd = { words: driven.end };

function startMotion() {
  // The columns of the state and of the energy have no program.
  live.tables[driven.state] = { table: report.tables[driven.state], why: null, fill: fillMotion };
  if (driven.energy !== null) live.tables[driven.energy.table] = { table: report.tables[driven.energy.table], why: null, fill: fillEnergy };
  for (const list of [input.values, ...course.values()]) if (!live.numbers.has(list)) live.numbers.set(list, [...list]);
  startCharts();
  onChange(showMotion);
}

// Rows at even distances up to the end.
function evenTimes(end) {
  return Array.from({ length: rowCount }, (_, row) => (row === rowCount - 1 ? end : (end * row) / (rowCount - 1)));
}

// Fills the lists of the state. A motion that ends early has all its rows up to there.
function fillMotion() {
  const programs = motionPrograms();
  const rates = motionRates(programs);
  const count = driven.inputs.length;
  const first = [...driven.inputs.map(({ name }) => live.given.get(name)), ...driven.inputs.map(({ speed }) => live.given.get(speed)), 0];
  const fastest = Float64Array.from(first.slice(count, 2 * count), Math.abs);
  const problem = { rates, state: first, tolerance: driven.tolerance, mostSteps: MOST_MOTION_STEPS };
  let end = integrated({ ...problem, times: evenTimes(driven.until), watch: watchedEnds(programs, rates, fastest), take: takeRow });
  if (end?.why === "undefined" && end.time > 0) end = deadPointAhead(rates, end, fastest, SLOW_SPEED.last, 0) ?? end;
  motionEnd.words = endWords(programs, end);
  const last = end?.last ?? end;
  const times = evenTimes(last?.time ?? driven.until);
  times.forEach((time, row) => (input.values[row] = time));
  if (end === null) return;
  // Where it cannot begin, every row is the start.
  for (let row = 0; row < rowCount; row += 1) takeRow(row, last.state, ratesAt(rates, last.state));
  if (last.time > 0) integrated({ ...problem, times: times.slice(0, -1), take: takeRow });
}

function ratesAt(rates, state) {
  const slopes = new Float64Array(state.length);
  rates(state, slopes);
  return slopes;
}

function takeRow(row, state, slopes) {
  const count = driven.inputs.length;
  driven.inputs.forEach(({ name, speed, acceleration }, k) => {
    course.get(name)[row] = state[k];
    course.get(speed)[row] = state[count + k];
    if (acceleration !== null) course.get(acceleration)[row] = slopes[count + k];
  });
  if (driven.energy !== null) energyColumn("work").values[row] = state[2 * count];
}

function energyColumn(name) {
  return report.tables[driven.energy.table].columns.find((column) => column.name === name);
}

function numberOrNull(value) {
  return Number.isFinite(value) ? value : null;
}

// Energies of all rows, and by how much their sum differs from the start and the work.
function fillEnergy() {
  const programs = motionPrograms();
  const energies = resultsOf(programs, driven.energy.loads);
  const count = driven.inputs.length;
  const [kinetic, potential, work, drift] = ["kinetic", "potential", "work", "drift"].map((name) => energyColumn(name).values);
  const state = new Float64Array(2 * count + 1);
  for (let row = 0; row < rowCount; row += 1) {
    driven.inputs.forEach(({ name, speed }, k) => {
      state[k] = course.get(name)[row];
      state[count + k] = course.get(speed)[row];
    });
    const results = energies(state);
    [kinetic[row], potential[row]] = [results[2 * count], results[2 * count + 1]].map(numberOrNull);
    drift[row] = numberOrNull(results[2 * count] + results[2 * count + 1] - kinetic[0] - potential[0] - work[row]);
  }
}

// The remark about the end of the motion that is shown.
function endOfMotion() {
  return isChanged() ? motionEnd.words : driven.end;
}

// Words and ranges of controls: inputs and speeds are those at the start, and loads and speeds that are zero reach as far as numbers of their unit.
function nameStarts() {
  byId("live").firstChild.textContent = "Change dimensions, loads and the start";
  for (const own of driven.inputs.flatMap(({ name, speed }) => [name, speed])) {
    const label = controls.rows.get(own).field.closest("label");
    label.querySelector(".name").append(element("small", {}, " at 0 s"));
    // A start does not run through its range.
    label.querySelector(".run")?.remove();
  }
  for (const [name, { unit, slider }] of controls.rows) {
    const most = columns.filter((own) => own.unit === unit).flatMap((own) => own.values).reduce((largest, value) => Math.max(largest, Math.abs(value ?? 0)), 0);
    if (valueInReport(name) !== 0 || unit === "rad" || most === 0) continue;
    set(slider, { min: -REACH.part * most, max: REACH.part * most });
    slider.value = valueNow(name);
  }
}

function showMotion() {
  player.period = Number(byId("speed").value) * span();
  showCharts();
}

live.starts.push(startMotion);
