// Groups without a closed form: a solution that is known is followed, by steps of Newton's method that cannot jump to another one.

// A first correction must not be larger, in radians or scaled lengths.
const FIRST_CORRECTION = CORE.FIRST_CORRECTION;
// Each correction is below this part of the one before, as where Newton's method is certain to find the nearest solution.
const CONTRACTION = CORE.ALLOWED_CONTRACTION;
// Corrections of a step, at most, and one that leaves rounding only.
const CORRECTIONS = CORE.CORRECTIONS;
const SETTLED = CORE.SETTLED;
// Lengths in states are scaled by a power of two, which changes on the way as links grow.
const SCALES = CORE.SCALES;
// The first step, as a share of the way; a step that succeeds is doubled. Steps that are a smaller share are not tried.
const FIRST_STEP = 0.125;
const SHORTEST_STEP = 1e-6;
// The largest correction of a state from which results are computed.
const CORRECTION_LIMIT = CORE.CORRECTION_LIMIT;
// Beyond its range by less than this part of it, an input counts as within.
const BESIDE = 1e-9;

// The solution that lies nearest to `before`, if steps are certain to find it; null otherwise. `correct` writes to `next` the state after a step
// from a state, the square of its change, the determinant before.
function settled(group, correct, before) {
  const scales = group.lengths.includes(true) ? SCALES : SCALES.slice(0, 1);
  for (const scale of scales) {
    const state = before.state.map((number, k) => (group.lengths[k] ? scale * number : number));
    const determinant = settle(group.size, correct, state, before.determinant);
    if (determinant !== null) return { state, determinant };
  }
  return null;
}

function settle(size, correct, state, before) {
  const next = new Float64Array(size + 2);
  let allowed = FIRST_CORRECTION;
  for (let k = 0; k < CORRECTIONS; k += 1) {
    correct(state, next);
    const change = Math.sqrt(next[size]);
    const determinant = next[size + 1];
    if (!(change <= allowed && determinant * before >= 0 && determinant !== 0)) return null;
    state.set(next.subarray(0, size));
    if (change <= SETTLED) return determinant;
    allowed = CONTRACTION * change;
  }
  return null;
}

// Goes from share 0 to share 1 of a way; `step(share, before)` gives what there is at a share near to where `before` is, or null. Returns what
// there is at the end, or null and the share that was reached.
function gone(before, step) {
  let [share, length] = [0, FIRST_STEP];
  // What lies near is reached at once.
  const end = step(1, before);
  if (end !== null) return { end, share: 1 };
  while (length >= SHORTEST_STEP) {
    const next = Math.min(share + length, 1);
    const there = step(next, before);
    if (there === null) {
      length /= 2;
      continue;
    }
    [share, before] = [next, there];
    if (share === 1) return { end: before, share };
    length *= 2;
  }
  return { end: null, share };
}

// The solutions of all groups of an assembly, found from the one at the reference: `known` has a state for each group.
function solutions(own, known) {
  const { coupled } = own.unit;
  const strands = coupled.map((group, number) => {
    const first = { x: placesOf(group, own.unit.reference), ...known[number] };
    return { first, last: first, low: -Infinity, high: Infinity };
  });

  function correctAt(number, x) {
    const states = statesAt(x, number);
    return (state, next) => {
      states[number] = state;
      coupled[number].correct(own, x, states, next);
    };
  }

  // The states of the first `count` groups, each with half of its determinant behind it; NaN where there is none.
  function statesAt(x, count = coupled.length) {
    const states = [];
    for (let number = 0; number < count; number += 1) {
      const place = found(number, x);
      const state = new Float64Array(coupled[number].size + 1).fill(NaN);
      if (place !== null) {
        state.set(place.state);
        state[state.length - 1] = 0.5 * place.determinant;
      }
      states.push(state);
    }
    return states;
  }

  function found(number, x) {
    const group = coupled[number];
    const strand = strands[number];
    const place = placesOf(group, x);
    if (place === null || !place.every(Number.isFinite)) return null;
    if (place.length === 1 && !(place[0] > strand.low && place[0] < strand.high)) return null;
    const from = distance(strand.first.x, place) < distance(strand.last.x, place) ? strand.first : strand.last;
    const all = Float64Array.from(x);
    const way = gone(from, (share, before) => {
      const there = share === 1 ? place : from.x.map((start, k) => start + share * (place[k] - start));
      group.inputs.forEach((input, k) => (all[input] = there[k]));
      const solution = settled(group, correctAt(number, all), before);
      return solution && { x: there, ...solution };
    });
    if (way.end !== null) strand.last = way.end;
    // Over one input the strand ends there: the solutions beyond, if there are any, are others.
    else if (place.length === 1) {
      const end = from.x[0] + Math.min(way.share + SHORTEST_STEP, 1) * (place[0] - from.x[0]);
      if (place[0] > from.x[0]) strand.high = Math.min(strand.high, end);
      else strand.low = Math.max(strand.low, end);
    }
    return way.end;
  }

  return {
    statesAt,
    known: () => strands.map(({ first }) => first),
    // Where the solutions were found to end; infinite where they were not, and over several inputs.
    ends: () => strands.map(({ low, high }) => [low, high]),
  };
}

function distance(a, b) {
  return a.reduce((sum, x, k) => sum + Math.abs(x - b[k]), 0);
}

// The inputs of a group, within their ranges; null beside them.
function placesOf(group, x) {
  const places = group.inputs.map((input, k) => {
    const { middle, length, repeats } = group.axes[k];
    const from = x[input] - middle;
    const place = repeats === 0 ? from : from - whole(from * repeats) / repeats;
    return Math.abs(place) <= (0.5 + BESIDE) * length ? middle + place : null;
  });
  return places.includes(null) ? null : places;
}

// States for other dimensions: those of `before`, an assembly, followed while the dimensions go straight to these. `assembled(dimensions)`
// gives an assembly without states. Null where the way ends.
function carriedOver(before, dimensions, numbersOf) {
  const { unit } = before;
  const x = unit.reference;
  const way = gone(before.known(), (share, known) => {
    const between = dimensions.map((number, k) => before.dimensions[k] + share * (number - before.dimensions[k]));
    const own = numbersOf(between);
    const states = [];
    const next = [];
    for (const [number, group] of unit.coupled.entries()) {
      own.statesAt = () => states;
      if (wind(own, group.turning, x) !== null) return null;
      const correct = (state, after) => group.correct(own, x, [...states, state], after);
      const solution = settled(group, correct, known[number]);
      if (solution === null) return null;
      next.push({ x: placesOf(group, x), ...solution });
      states.push(Float64Array.of(...solution.state, 0.5 * solution.determinant));
    }
    return next;
  });
  return way.end;
}
