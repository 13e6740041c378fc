// The tables of the report for other dimensions. The engine computes, and this puts the numbers
// where everything else reads them.

const live = {
  ...stateOf(report, allNumbers(report).map((numbers) => [...numbers])),
  // An assembly for each of the programs: as they are now, and of the report.
  assemblies: [],
  firstAssemblies: [],
  tables: [],
  // Figures that the page has found of the report.
  reason: null,
  changePoints: null,
  listeners: [],
  // Functions that begin with the numbers of the report, of parts that not every page has.
  starts: [],
};

// The state of a page that shows a report as it is. `numbers` are those of the report, for the time when they are changed.
function stateOf(own, numbers) {
  return {
    // Dimensions by name: of the report, and as they are now.
    declared: new Map(own.dimensions.map(({ name, value }) => [name, value])),
    dimensions: new Map(own.dimensions.map(({ name, value }) => [name, value])),
    // Arguments beside the input, by name: as they are now, and of the report.
    given: new Map(Object.entries(own.live.given)),
    stands: new Map(Object.entries(own.live.given)),
    // Modes of the first programs: the current ones, and those of the report.
    modes: own.live.modes,
    firstModes: own.live.modes,
    // 0 for the report's solution of groups without a closed form; another number for each choice of another one.
    choice: 0,
    // Figures, errors, gaps, and numbers of the report.
    summary: own.summary,
    accuracy: own.accuracy,
    gaps: own.gaps,
    numbers: new Map(allNumbers(own).map((list, k) => [list, numbers[k]])),
  };
}

function allNumbers({ tables, true: rates, bands }) {
  const rows = [...tables.flatMap((table) => table.columns), ...(rates ?? [])].map((column) => column.values);
  return [...rows, ...(bands ?? []).map((band) => band.half)];
}

function onChange(listener) {
  live.listeners.push(listener);
}

// A dimension or an argument: its current value, and that of the report.
function valueNow(name) {
  return live.dimensions.get(name) ?? live.given.get(name);
}

function valueInReport(name) {
  return live.declared.get(name) ?? live.stands.get(name);
}

// Names with values that are not those of the report.
function changedOnes() {
  const all = [...live.dimensions, ...live.given];
  return all.filter(([name, value]) => value !== valueInReport(name));
}

function areOtherModes() {
  return live.modes.join() !== live.firstModes.join();
}

function isChanged() {
  return changedOnes().length > 0 || areOtherModes() || live.choice !== 0;
}

// Numbers are changed in place: each column needs its own. The picture shows the columns of its
// table.
function ownNumbers({ tables, true: rates, bands, picture: shown, live: { picture: place } }) {
  for (const { columns } of tables) {
    for (const column of columns) column.values = [...column.values];
  }
  for (const rate of rates ?? []) rate.values = [...rate.values];
  for (const band of bands ?? []) band.half = [...band.half];
  if (!shown) return;
  const all = tables[place.table].columns.slice(place.first);
  const vectors = [...shown.points, ...shown.directions];
  vectors.forEach((vector, k) => {
    vector.at = vector.at.map((_, i) => all[k * shown.dimension + i].values);
  });
}

// The function and the programs that give a table, the sources of its arguments, and what fills it.
// `why` has the reason if something is missing.
function bind(table) {
  for (const [number, unit] of engine.programs.entries()) {
    const fn = unit.functions.find((own) => own.name === table.function && namesAreThose(own.columns, table.columns));
    if (fn === undefined) continue;
    const names = fn.arguments.map((place) => [...unit.inputs, ...unit.arguments][place].name);
    const missing = names.filter((name) => !isKnown(name));
    const why = missing.length > 0 ? `nothing is known of ${missing.join(", ")}` : null;
    return { table, number, fn, names, why, fill: fillTable };
  }
  return { table, why: "its programs are not part of the page" };
}

function namesAreThose(own, others) {
  return own.length === others.length && own.every(({ name }, k) => name === others[k].name);
}

// The numbers of a mechanism's dimensions; dimensions that the report does not have are as
// declared.
function valuesOf(unit, dimensions) {
  return unit.dimensions.map(({ name, value }) => dimensions.get(name) ?? value);
}

// Assemblies with these dimensions; throws the errors of the engine.
function assembledWith(dimensions, before) {
  return assembledOf(engine.programs, dimensions, live.modes, before);
}

// The modes are those of the first programs.
function assembledOf(units, dimensions, firstModes, before) {
  return units.map((unit, number) => {
    const values = valuesOf(unit, dimensions);
    const modes = number === 0 ? firstModes : unit.modes;
    return engine.assembled(unit, values, modes, before[number] ?? null);
  });
}

// Dimensions on the way from where they are to others; share 1 is there.
function dimensionsBetween(to, share) {
  if (share === 1) return to;
  return new Map([...to].map(([name, value]) => [name, live.dimensions.get(name) + share * (value - live.dimensions.get(name))]));
}

const BISECTIONS = 24;

// Changes dimensions as far as the mechanism can be assembled at its reference: there it stops, and the error that is returned says by how much the
// wanted ones miss. Null if all is well. `stop` takes the dimensions at which it stops.
function change(changes, stop = goAsFarAsPossible) {
  const to = new Map([...live.dimensions, ...changes]);
  const begin = performance.now();
  let error = null;
  try {
    take(to, assembledWith(to, live.assemblies));
  } catch (thrown) {
    if (!(thrown instanceof engine.AssemblyError)) throw thrown;
    error = thrown;
    stop(to);
  }
  fillTables();
  const computed = performance.now();
  for (const listener of live.listeners) listener();
  // For who measures: milliseconds of computing, and of showing.
  Object.assign(document.body.dataset, { computed: computed - begin, shown: performance.now() - computed });
  return error;
}

function take(dimensions, assemblies) {
  live.dimensions = dimensions;
  live.assemblies = assemblies;
}

// The start of each design of an address: it is the same whatever was shown before.
function backToReport() {
  live.given = new Map(live.stands);
  live.modes = live.firstModes;
  live.choice = 0;
  forgetRefusals();
  take(live.declared, live.firstAssemblies);
}

function goAsFarAsPossible(to) {
  const farthest = farthestTo(to);
  if (farthest !== null) take(...farthest);
}

// The last dimensions on the way to others with which the mechanism can be assembled, with the assemblies; null where there are none.
function farthestTo(to) {
  let [low, high, best] = [0, 1, null];
  for (let k = 0; k < BISECTIONS; k += 1) {
    const share = (low + high) / 2;
    const dimensions = dimensionsBetween(to, share);
    try {
      best = [dimensions, assembledWith(dimensions, live.assemblies)];
      low = share;
    } catch (thrown) {
      if (!(thrown instanceof engine.AssemblyError)) throw thrown;
      high = share;
    }
  }
  return best;
}

// Another value of an argument beside the input.
function give(name, value) {
  live.given.set(name, value);
  return change(new Map());
}

// The numbers of the report, to the last digit, where nothing is changed.
function fillTables() {
  if (!isChanged()) {
    for (const [numbers, declared] of live.numbers) declared.forEach((value, row) => (numbers[row] = value));
    Object.assign(report, { accuracy: live.accuracy, gaps: live.gaps, reason: live.reason, changePoints: live.changePoints });
    return;
  }
  for (const own of live.tables) if (own.why === null) own.fill(own);
  fillRates();
  fillBands();
  report.accuracy = live.accuracy.map(accuracyNow);
  report.gaps = gapsNow();
  report.reason = reasonOfGap();
  report.changePoints = changePointWords();
}

// A function of the input that returns the arguments of these names.
function argumentsOf(names) {
  const at = names.map((name) => live.given.get(name));
  const place = names.indexOf(input.name);
  return (x) => {
    at[place] = x;
    return at;
  };
}

function fillTable({ table, number, fn, names }) {
  const own = live.assemblies[number];
  const at = argumentsAt(names);
  const out = new Float64Array(fn.columns.length);
  const lists = table.columns.map((column) => column.values);
  for (let row = 0; row < rowCount; row += 1) {
    engine.evaluate(own, fn, at(row), out);
    for (let k = 0; k < out.length; k += 1) lists[k][row] = Number.isFinite(out[k]) ? out[k] : null;
  }
}

// The mechanism as the report has it, until something is changed.
function startModel() {
  live.modes = live.firstModes = modesOf(report, engine.programs);
  beginWithReport(assembledWith(live.dimensions, []));
  for (const start of live.starts) start();
  startSaving();
  sayGaps();
}

// Modes of the first programs in a report; those of the declaration if it has others.
function modesOf({ live: { modes } }, [unit]) {
  return modes.length === unit.modes.length ? modes : [...unit.modes];
}

// The numbers of the report, with its assemblies.
function beginWithReport(assemblies) {
  live.firstAssemblies = live.assemblies = assemblies;
  live.tables = report.tables.map(bind);
  report.reason = live.reason = reasonOfGap();
  report.changePoints = live.changePoints = changePointWords();
  startDwells();
}
