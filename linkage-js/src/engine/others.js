// Other solutions of groups without a closed form, by Newton's method from many places: each that is found is one, and hardly any is missed.

// So many places, and steps from each.
const PLACES = 600;
const MOST_STEPS_THERE = 40;
// Lengths in states are about 1.
const FARTHEST = 3;
// Solutions that are nearer to each other are one; numbers of a unit vector that differ more from one are none.
const ALIKE = 1e-6;

// For all groups together: a list of states, one for each group, for each solution at the reference inputs.
function solutionsAt(unit, dimensions, modes) {
  let found = [[]];
  for (const [number, group] of unit.coupled.entries()) {
    found = found.flatMap((states) => {
      const correct = correctionBehind(unit, dimensions, modes, states, number);
      return correct === null ? [] : zerosOf(group, correct).map((state) => [...states, state]);
    });
  }
  return found;
}

// The correction of a group behind others whose states are known; null where an angle before it cannot be followed.
function correctionBehind(unit, dimensions, modes, states, number) {
  const own = standing(unit, dimensions, modes, states);
  const floors = own.statesAt();
  return wind(own, unit.coupled[number].turning, unit.reference) === null
    ? (state, next) => unit.coupled[number].correct(own, unit.reference, [...floors, state], next)
    : null;
}

function corrected(unit, own, states, number, state) {
  const group = unit.coupled[number];
  if (wind(own, group.turning, unit.reference) !== null) return null;
  const next = new Float64Array(group.size + 2);
  group.correct(own, unit.reference, [...states, Float64Array.from(state)], next);
  return next;
}

function zerosOf(group, correct) {
  const zeros = [];
  for (let place = 1; place <= PLACES; place += 1) {
    const zero = zeroFrom(group, correct, startAt(group, place));
    if (zero !== null && !zeros.some((other) => other.every((x, k) => Math.abs(x - zero[k]) < ALIKE))) zeros.push(zero);
  }
  // In an order that does not depend on the places.
  return zeros.sort((a, b) => angleOf(a[1], a[0]) - angleOf(b[1], b[0]));
}

// Evenly scattered: multiples of numbers that fit to each other badly.
function startAt(group, place) {
  const share = (k) => (place * Math.sqrt(2 + 3 * k)) % 1;
  const state = new Float64Array(group.size);
  for (let k = 0; k < group.size; k += 1) {
    if (group.lengths[k]) state[k] = FARTHEST * (2 * share(k) - 1);
    else if (k + 1 < group.size && isFirstOfUnit(group, k)) [state[k], state[k + 1]] = [cosine(TURN * share(k)), sine(TURN * share(k))];
  }
  return state;
}

// Unit vectors are pairs of numbers that are no lengths.
function isFirstOfUnit({ lengths }, k) {
  return lengths.slice(0, k + 1).filter((own) => !own).length % 2 === 1;
}

function zeroFrom(group, correct, state) {
  const next = new Float64Array(group.size + 2);
  for (let k = 0; k < MOST_STEPS_THERE; k += 1) {
    correct(state, next);
    const change = Math.sqrt(next[group.size]);
    if (!(change < Infinity)) return null;
    state.set(next.subarray(0, group.size));
    if (change <= SETTLED) return isProper(group, state) ? [...state] : null;
  }
  return null;
}

function isProper(group, state) {
  return group.lengths.every((isLength, k) => isLength || !isFirstOfUnit(group, k) || Math.abs(hypot(state[k], state[k + 1]) - 1) < ALIKE);
}

// What another assembly with these dimensions is followed from, by states near to its own.
function standing(unit, dimensions, modes, states) {
  const own = numbersOf(unit, dimensions, modes);
  const before = [];
  const known = [];
  own.statesAt = () => before;
  for (const [number, state] of states.entries()) {
    const next = corrected(unit, own, before, number, state);
    const determinant = next === null ? NaN : next[state.length + 1];
    known.push({ state: Float64Array.from(state), determinant });
    before.push(Float64Array.of(...state, 0.5 * determinant));
  }
  own.known = () => known;
  return own;
}
