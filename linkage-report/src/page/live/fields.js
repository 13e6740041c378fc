// Fields of dimensions: what is typed is taken, or it stays there with a mark and the reason.

// Digits of the nearest value that works.
const NEAREST_DIGITS = 6;

function takeTyped(row) {
  const { field, name, unit, put } = row;
  const text = field.value;
  if (text === row.written && row.refused === null) return;
  row.refused = null;
  const why = text.trim() === "" ? null : refusalOf(text, unit, (value) => put(value, stay), name);
  if (why !== null) {
    row.refused = { at: valueNow(name), why: `${name} = ${text.trim()} is refused: ${why}` };
    field.value = text;
  }
  keepStep();
  showControls();
  say(null);
}

// The dimensions stay as they are.
function stay() {}

// Why a text is not taken; null if it is.
function refusalOf(text, unit, put, name) {
  try {
    const value = typedValue(text, unit);
    const error = put(value);
    return error === null ? null : `${error.message}.${nearestWords(name, unit, value)}`;
  } catch (thrown) {
    if (!(thrown instanceof TypedError)) throw thrown;
    return `${thrown.message}.`;
  }
}

// The value next to a wanted one with which the mechanism can be assembled, on this side of it.
function nearestWords(name, unit, value) {
  const farthest = farthestTo(new Map([...live.dimensions, [name, value]]));
  if (farthest === null) return "";
  const [from, to] = [live.dimensions.get(name), farthest[0].get(name)].map((own) => plotValue(own, unit));
  const step = 10 ** (Math.floor(Math.log10(Math.abs(to))) + 1 - NEAREST_DIGITS);
  return ` The nearest value that works is ${digits(towards(from, to, step))} ${plotUnit(unit)}`.trimEnd() + ".";
}

// The whole step before a value, seen from another one.
function towards(from, to, step) {
  return toStep(to, step, to > from ? Math.floor : Math.ceil);
}

function refusals() {
  return [...controls.rows.values()].filter(({ refused }) => refused !== null).map(({ refused }) => refused.why);
}

// Coordinates and angles have both signs, and so may a length have that is negative in the report.
function negativeLengths() {
  const isLength = (name) => !/\.[xyz]$/.test(name) && report.dimensions.some((own) => own.name === name && QUANTITIES.length === UNITS.get(own.unit)?.powers);
  const found = changedOnes().filter(([name, value]) => value < 0 && valueInReport(name) > 0 && isLength(name));
  return found.map(([name]) => `${name} is negative: as a length it leads the other way.`);
}

function forgetRefusals() {
  for (const row of controls.rows.values()) row.refused = null;
}

function showField(row) {
  const { field, name, value } = row;
  // The dimension has been changed in another way.
  if (row.refused !== null && row.refused.at !== valueNow(name)) row.refused = null;
  if (row.marked !== row.refused) set(field, { "aria-invalid": row.refused !== null && "true", title: row.refused?.why ?? null });
  row.marked = row.refused;
  if (row.refused !== null) return;
  row.written = String(value);
  if (field.value !== row.written) field.value = row.written;
}

const FIELD_STEPS = { ArrowUp: 1, ArrowDown: -1 };

function onFieldKey(event, row) {
  const { field, value } = row;
  if (event.key === "Escape") field.value = row.written;
  else if (event.key in FIELD_STEPS) field.value = String(rounded(value + FIELD_STEPS[event.key], 12));
  else if (event.key !== "Enter") return;
  event.preventDefault();
  takeTyped(row);
}

// The power of ten below what a pixel is; null where nothing is seen.
function stepOfPixel(size) {
  return size > 0 && isFinite(size) ? 10 ** Math.floor(Math.log10(size)) : null;
}

// A number in whole steps. Steps are powers of ten, and so it has no more digits than they tell.
function toStep(value, step, round = Math.round) {
  return step === null ? value : rounded(round(value / step) * step, 12);
}

// Where the mechanism comes to its end, dimensions stop at the whole step before it.
function stopAtStep(names, step) {
  return (to) => {
    const farthest = farthestTo(to);
    if (farthest === null) return;
    const near = new Map(farthest[0]);
    for (const name of step === null ? [] : names) {
      const unit = report.dimensions.find((own) => own.name === name).unit;
      const [from, end] = [live.dimensions.get(name), near.get(name)].map((own) => plotValue(own, unit));
      near.set(name, fromPlot(towards(from, end, step), unit));
    }
    try {
      take(near, assembledWith(near, live.assemblies));
    } catch (thrown) {
      if (!(thrown instanceof engine.AssemblyError)) throw thrown;
      take(...farthest);
    }
  };
}
