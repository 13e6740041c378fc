// The equation of motion of the report's mechanism, from its programs. A state has all inputs, then all speeds, then the work of loads without a potential.

// The programs and the function of the accelerations; further functions by name.
function motionPrograms() {
  const { number } = live.tables[driven.table];
  const unit = engine.programs[number];
  return { number, unit, functionOf: (name) => unit.functions.find((own) => own.name === name) };
}

// A function of the state that returns the results of one of the programs, always in the same list. Accelerations count as zero.
function resultsOf({ number, unit, functionOf }, name) {
  const fn = functionOf(name);
  const names = fn.arguments.map((place) => [...unit.inputs, ...unit.arguments][place].name);
  const at = names.map((own) => live.given.get(own) ?? 0);
  const running = [];
  driven.inputs.forEach((own, k) => {
    if (names.includes(own.name)) running.push([names.indexOf(own.name), k]);
    if (names.includes(own.speed)) running.push([names.indexOf(own.speed), driven.inputs.length + k]);
  });
  for (const { acceleration } of driven.inputs) if (names.includes(acceleration)) at[names.indexOf(acceleration)] = 0;
  const out = new Float64Array(fn.columns.length);
  return (state) => {
    for (const [place, k] of running) at[place] = state[k];
    engine.evaluate(live.assemblies[number], fn, at, out);
    return out;
  };
}

// True if a loop does not close at this state: then there is no motion, whether accelerations depend on that loop or not.
function isOpenAt({ number }) {
  const own = live.assemblies[number];
  const x = new Float64Array(driven.inputs.length);
  const gaps = new Float64Array(own.unit.groups.length);
  return (state) => {
    for (let k = 0; k < x.length; k += 1) x[k] = state[k];
    own.unit.gaps(own, x, own.statesAt(x), gaps);
    return gaps.some((gap) => gap > 0);
  };
}

// The power of all loads less that of weights and springs, which is what the potential energy loses.
function powerOf(programs) {
  const count = driven.inputs.length;
  if (driven.energy === null) return () => 0;
  const [loads, weights] = [driven.energy.loads, driven.energy.weights].map((name) => resultsOf(programs, name));
  return (state) => {
    const [forces, held] = [loads(state), weights(state)];
    let sum = 0;
    for (let k = 0; k < count; k += 1) sum += state[count + k] * (forces[k] + forces[count + k] - held[k]);
    return sum;
  };
}

// Writes the rates of a state: NaN where there are no accelerations.
function motionRates(programs) {
  const count = driven.inputs.length;
  const [accelerations, isOpen, power] = [resultsOf(programs, report.tables[driven.table].function), isOpenAt(programs), powerOf(programs)];
  return (state, rates) => {
    const results = accelerations(state);
    const open = isOpen(state);
    for (let k = 0; k < count; k += 1) {
      rates[k] = state[count + k];
      rates[count + k] = open ? NaN : results[driven.inputs[k].column];
    }
    rates[2 * count] = power(state);
  };
}

// The functions of the state whose zeros end the motion.
function stopHeights(programs) {
  const count = driven.inputs.length;
  const results = resultsOf(programs, report.tables[driven.table].function);
  return driven.stops.map(({ input: own, speed, column, value }) => {
    if (own !== null) return (state) => state[own] - value;
    if (speed !== null) return (state) => state[count + speed] - value;
    return (state) => resultsWithAccelerations(programs, results(state), state)[column] - value;
  });
}

// The results of the function at a state if it takes the accelerations, which it returns, too.
function resultsWithAccelerations({ number, unit, functionOf }, results, state) {
  const fn = functionOf(report.tables[driven.table].function);
  const names = fn.arguments.map((place) => [...unit.inputs, ...unit.arguments][place].name);
  if (driven.inputs.every(({ acceleration }) => !names.includes(acceleration))) return results;
  const at = names.map((name) => {
    const k = driven.inputs.findIndex((own) => [own.name, own.speed, own.acceleration].includes(name));
    if (k < 0) return live.given.get(name);
    const { name: own, speed, column } = driven.inputs[k];
    return name === own ? state[k] : name === speed ? state[driven.inputs.length + k] : results[column];
  });
  const out = new Float64Array(fn.columns.length);
  engine.evaluate(live.assemblies[number], fn, at, out);
  return out;
}
