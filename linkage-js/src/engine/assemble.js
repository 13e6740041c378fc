// Closing the loops, and evaluating functions.

class AssemblyError extends Error {
  // `why` is open, undefined, lost, turns or dimension; `group` the number of the group, `miss` by how much it misses closing.
  constructor(why, message, details = {}) {
    super(message);
    this.name = "AssemblyError";
    Object.assign(this, { why, ...details });
  }
}

// An assembly's numbers, without what is found of them.
function numbersOf(unit, dimensions, modes) {
  return {
    unit,
    dimensions: Float64Array.from(dimensions),
    modes: Float64Array.from(modes),
    centres: new Float64Array(unit.angles.length),
    windings: new Float64Array(unit.angles.length * unit.inputs.length),
    prepared: new Float64Array(unit.slots),
    // The inputs and arguments of the position that is computed.
    position: new Float64Array(unit.inputs.length + unit.arguments.length),
    statesAt: () => [],
    known: () => [],
    ends: () => [],
  };
}

// The assembly with these dimensions and modes, closed at the reference inputs. Groups without a closed form are followed from `before`,
// another assembly.
function assembled(unit, dimensions, modes, before) {
  checkNumbers(unit, dimensions);
  const own = numbersOf(unit, dimensions, modes);
  if (unit.coupled.length > 0) solve(own, before ?? declared(unit));
  const lost = wind(own, unit.angles.length, unit.reference);
  if (lost !== null) noTurns(own);
  close(own, unit.reference);
  if (lost !== null) {
    throw new AssemblyError("turns", `${unit.name}: the turns of ${lost} cannot be followed over the ranges of its inputs`);
  }
  return own;
}

// What the declaration's assembly knows of groups without a closed form.
function declared(unit) {
  const own = numbersOf(unit, unit.dimensions.map(({ value }) => value), unit.modes);
  own.known = () => unit.coupled.map(({ state, determinant }) => ({ state: Float64Array.from(state), determinant }));
  return own;
}

function solve(own, before) {
  const { unit } = own;
  const known = carriedOver(before, [...own.dimensions], (dimensions) => numbersOf(unit, dimensions, own.modes));
  if (known === null) {
    const names = unit.coupled.flatMap(({ group }) => unit.groups[group].unknowns).join(", ");
    throw new AssemblyError("lost", `${unit.name}: on the way to these dimensions the assembly of ${names} ends`);
  }
  const found = solutions(own, known);
  own.statesAt = (x) => found.statesAt(x);
  own.known = found.known;
  own.ends = found.ends;
}

function checkNumbers(unit, dimensions) {
  for (const group of unit.groups) {
    for (const index of group.dimensions) {
      if (Number.isFinite(dimensions[index])) continue;
      throw new AssemblyError("dimension", `${unit.name}: ${unit.dimensions[index].name} is ${dimensions[index]}, which is no number`, { dimension: index });
    }
  }
}

// Fails at the first group that does not close at these inputs.
function close(own, x) {
  const { unit } = own;
  gapsAt(own, x).forEach((miss, group) => {
    if (miss <= 0) return;
    const { kind, loops, joints, unknowns, unit: measure } = unit.groups[group];
    const of = `${unit.name}: the ${kind} group of ${unknowns.join(", ")} (${joints || `loop ${loops.join(", ")}`})`;
    if (Number.isNaN(miss)) {
      throw new AssemblyError("undefined", `${of} is undefined: something before it has no value`, { group });
    }
    const by = `${Number(miss.toPrecision(3))} ${measure}`.trim();
    throw new AssemblyError("open", `${of} cannot be closed: ${by} missing`, { group, miss });
  });
}

// By how much each group misses closing: positive where it does.
function gapsAt(own, x) {
  const gaps = new Float64Array(own.unit.groups.length);
  own.unit.gaps(own, x, own.statesAt(x), gaps);
  return gaps;
}

// The states of a mechanism whose groups all have closed forms.
const NO_STATES = [];

// Writes the results of a function to `out`. Arguments stand as the function takes them.
function evaluate(own, fn, values, out) {
  const x = own.position;
  const { reference } = own.unit;
  // What a function does not take, its groups do not depend on. Loops, since `set` and closures take longer than the function.
  for (let k = 0; k < reference.length; k += 1) x[k] = reference[k];
  for (let k = 0; k < fn.arguments.length; k += 1) x[fn.arguments[k]] = values[k];
  fn.run(own, x, fn.coupled ? own.statesAt(x) : NO_STATES, out);
}
