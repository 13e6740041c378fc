// Why rows are missing, in words of who draws mechanisms: which length is too short or too long where, or where a group comes to its end.

// Lengths are tried with this part of the largest one more. A length is only blamed if as much as is said of it closes the group.
const BLAMED_STEP = 1e-6;
const BLAMED_MORE = 1.001;
// The number of lengths that are named.
const MOST_BLAMED = 2;
// A length that hardly moves the gap is not the cause.
const LEAST_SLOPE = 0.2;

// Null where no group is known to be the reason, as at a dead point where only rates have no value.
function reasonOfGap() {
  if (report.gaps.length === 0) return null;
  const rows = input.values.filter((x) => report.gaps.some(({ from, to }) => (x - from) * (x - to) <= 0));
  for (const [number, unit] of engine.programs.entries()) {
    const reason = whatMisses(number, unit, rows) ?? whatEnds(number, unit, rows);
    if (reason !== null) return reason;
  }
  return null;
}

// All inputs of a mechanism where the input of the report is `x`.
function inputsAt(unit, x) {
  return Float64Array.from(unit.inputs, ({ name, reference }) => (name === input.name ? x : live.given.get(name) ?? reference));
}

// The first group that misses closing, where it misses most.
function whatMisses(number, unit, rows) {
  const own = live.assemblies[number];
  let [group, at, miss] = [Infinity, null, 0];
  for (const x of rows) {
    const gaps = engine.gapsAt(own, inputsAt(unit, x));
    const first = gaps.findIndex((gap) => gap > 0);
    if (first < 0 || first > group || (first === group && gaps[first] <= miss)) continue;
    [group, at, miss] = [first, x, gaps[first]];
  }
  if (at === null) return null;
  const place = `at ${input.name} = ${inputShort(at)}`;
  const blamed = unit.coupled.length === 0 ? lengthsToBlame(own, group, inputsAt(unit, at), miss) : [];
  if (blamed.length > 0) return `${blamed.map(blameWords).join(" or ")} ${place}`;
  return `${groupWords(unit.groups[group])} misses closing by ${amountOf(miss, unit.groups[group].unit)} ${place}`;
}

// Lengths are short or long, coordinates small or large.
function blameWords({ name, by, unit }) {
  const words = name.includes(".") ? ["small", "large"] : ["short", "long"];
  return `${name} ${amountOf(Math.abs(by), unit)} too ${words[by > 0 ? 0 : 1]}`;
}

function amountOf(amount, unit) {
  return `${digits(rounded(amount, 3))} ${unit}`.trim();
}

function groupWords({ kind, unknowns, loops, joints }) {
  return `the ${kind} group of ${unknowns.join(", ")} (${joints || `loop ${loops.join(", ")}`})`;
}

// Lengths with whose change the group would just close: changed ones before all others, then the
// smallest changes.
function lengthsToBlame(own, group, x, miss) {
  const { unit } = own;
  const { dimensions, unit: measure } = unit.groups[group];
  const step = BLAMED_STEP * largestDimension(measure);
  const gapWith = (index, by) => {
    const other = Float64Array.from(own.dimensions);
    other[index] += by;
    return gapsWith(own, other, x)[group];
  };
  const found = [];
  for (const index of dimensions) {
    const { name, unit: its } = unit.dimensions[index];
    if (its !== measure || !live.dimensions.has(name)) continue;
    const slope = (gapWith(index, step) - miss) / step;
    if (!(Math.abs(slope) > LEAST_SLOPE)) continue;
    const by = -miss / slope;
    // A gap goes on through length 0, to lengths that are none; coordinates have both signs.
    if (!name.includes(".") && own.dimensions[index] * (own.dimensions[index] + by) < 0) continue;
    if (gapWith(index, BLAMED_MORE * by) <= 0) found.push({ name, by, unit: its, changed: valueNow(name) !== valueInReport(name) });
  }
  const changed = found.filter((one) => one.changed);
  return (changed.length > 0 ? changed : found).sort((a, b) => Math.abs(a.by) - Math.abs(b.by)).slice(0, MOST_BLAMED);
}

// Closure errors of groups with other dimensions, whether these close at the reference or not;
// nothing is followed.
function gapsWith(own, dimensions, x) {
  const other = { ...own, dimensions, prepared: new Float64Array(own.unit.slots) };
  own.unit.prepare(other, other.prepared);
  return engine.gapsAt(other, x);
}

// The first group without a closed form whose solution cannot be followed to all rows.
function whatEnds(number, unit, rows) {
  const own = live.assemblies[number];
  for (const [index, { group, inputs }] of unit.coupled.entries()) {
    const isLost = (x) => Number.isNaN(own.statesAt(inputsAt(unit, x))[index][0]);
    const lost = rows.find(isLost);
    if (lost === undefined) continue;
    const words = groupWords(unit.groups[group]);
    // Between the last row that there is and the first that there is not.
    const ends = own.ends()[index].filter(Number.isFinite);
    if (ends.length === 0) return `${words} cannot be followed to ${input.name} = ${inputShort(lost)} in this assembly`;
    const measured = unit.inputs[inputs[0]];
    const places = ends.map((end) => `${digits(rounded(plotValue(end, measured.unit), 5))} ${plotUnit(measured.unit)}`.trim());
    return `${words} comes to a dead point at ${measured.name} = ${places.join(" and ")}, where this assembly ends`;
  }
  return null;
}
