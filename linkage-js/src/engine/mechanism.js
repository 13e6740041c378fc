// A mechanism as other people's programs see it.

function mechanismOf(unit) {
  const { name, dimensions, inputs, modes } = unit;
  const functions = unit.functions.map((fn) => ({
    name: fn.name,
    arguments: fn.arguments.map((place) => [...unit.inputs, ...unit.arguments][place].name),
    columns: fn.columns,
  }));
  return {
    name,
    dimensions,
    inputs: inputs.map(({ name, unit, reference, range }) => ({ name, unit, reference, range })),
    modes,
    functions,
    assemble: (changed = {}, options = {}) => assemblyOf(unit, changed, options),
    dimensionsOf(assembly) {
      const own = numbersBehind(assembly);
      return Object.fromEntries(dimensions.map(({ name }, k) => [name, own.dimensions[k]]));
    },
    checkRange: (assembly) => rangeOf(numbersBehind(assembly)),
    gaps: (assembly, ...x) => gapsAt(numbersBehind(assembly), Float64Array.from(x)),
    columns: (assembly, name, ...given) => columnsOf(numbersBehind(assembly), functionOf(unit, name), given),
  };
}

// Assemblies have nothing but the user's functions, which may have any name.
const numbers = new WeakMap();

function numbersBehind(assembly) {
  const own = numbers.get(assembly);
  if (own === undefined) throw new TypeError("not what assemble gave");
  return own;
}

// `changed` are dimensions by name; all others are as declared.
function assemblyOf(unit, changed, { modes = unit.modes, from = null }) {
  const names = unit.dimensions.map(({ name }) => name);
  const unknown = Object.keys(changed).find((name) => !names.includes(name));
  if (unknown !== undefined) throw new RangeError(`${unit.name} has no dimension ${unknown}; it has ${names.join(", ")}`);
  if (modes.length !== unit.modes.length) {
    throw new RangeError(`${unit.name} has ${unit.modes.length} modes, and ${modes.length} are given`);
  }
  const dimensions = unit.dimensions.map(({ name, value }) => (Object.hasOwn(changed, name) ? changed[name] : value));
  const own = assembled(unit, dimensions, modes, from === null ? null : numbersBehind(from));
  const evaluators = unit.functions.map((fn) => [fn.name, evaluator(own, fn)]);
  const assembly = Object.freeze(Object.fromEntries(evaluators));
  numbers.set(assembly, own);
  return assembly;
}

function evaluator(own, fn) {
  return (...given) => {
    const out = new Float64Array(fn.columns.length);
    evaluate(own, fn, given, out);
    return shaped(fn.fields, out);
  };
}

function functionOf(unit, name) {
  const fn = unit.functions.find((own) => own.name === name);
  if (fn !== undefined) return fn;
  throw new RangeError(`${unit.name} has no function ${name}; it has ${unit.functions.map((own) => own.name).join(", ")}`);
}

// The columns of a function over many positions: arguments are lists, or numbers that are the same at all positions.
function columnsOf(own, fn, given) {
  const lists = given.filter((argument) => typeof argument !== "number");
  const count = lists.length === 0 ? 1 : Math.min(...lists.map((list) => list.length));
  const columns = fn.columns.map(() => new Float64Array(count));
  const out = new Float64Array(fn.columns.length);
  // Arguments that are the same at all positions stay. Nothing is allocated for a position.
  const values = given.map((argument) => (typeof argument === "number" ? argument : NaN));
  for (let row = 0; row < count; row += 1) {
    for (let k = 0; k < given.length; k += 1) {
      if (typeof given[k] !== "number") values[k] = given[k][row];
    }
    evaluate(own, fn, values, out);
    for (let k = 0; k < columns.length; k += 1) columns[k][row] = out[k];
  }
  return columns;
}

// Numbers as the function's fields: a vector is a list of components, an array one of its entries, a frame one of its origin and axes.
function shaped(fields, out) {
  let next = 0;
  const take = (shape) => (shape === null ? out[next++] : Array.from({ length: shape[0] }, () => take(shape[1])));
  return Object.fromEntries(fields.map(([name, shape]) => [name, take(shape)]));
}
