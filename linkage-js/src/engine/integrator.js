// Motion under forces: the explicit Runge-Kutta method of order 5 by Dormand and Prince, with control of steps. Steps end at the times of the rows, so that
// nothing is interpolated.

// Shares of the rates of earlier stages in each stage. The last one is the end of the step, whose rates are those of the next step's first stage.
const STAGE_SHARES = [
  [],
  [1 / 5],
  [3 / 40, 9 / 40],
  [44 / 45, -56 / 15, 32 / 9],
  [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
  [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
  [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
];
// Differences between the shares of the methods of orders 5 and 4.
const ERROR_SHARES = [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40];

// Growth of the next step: bounds, and a factor for safety. A step without rates is followed by a shorter one.
const LEAST_GROWTH = 0.2;
const MOST_GROWTH = 5;
const CAUTION = 0.9;
const SHORTER_STEP = 0.25;
// The shortest step, as a part of the whole time: a few units of its last digit.
const SHORTEST_STEP = 2e-15;
// A part of the time that counts as rounding.
const ROUNDED_TIME = 1e-12;

// One attempt after another, with room for all stages.
function stepperOf(rates, size) {
  const stages = STAGE_SHARES.map(() => new Float64Array(size));
  const middle = new Float64Array(size);
  // Writes the state after a step of this width to `to`, and its rates to `ends`. Returns the stages.
  return (from, begins, width, to, ends) => {
    stages[0].set(begins);
    for (let stage = 1; stage < stages.length; stage += 1) {
      const shares = STAGE_SHARES[stage];
      const place = stage === stages.length - 1 ? to : middle;
      for (let k = 0; k < size; k += 1) {
        let sum = 0;
        for (let j = 0; j < stage; j += 1) sum += shares[j] * stages[j][k];
        place[k] = from[k] + width * sum;
      }
      rates(place, stages[stage]);
    }
    ends.set(stages.at(-1));
    return stages;
  };
}

// The error of a step in units of the tolerance, the mean of all components; NaN without rates.
function errorOfStep(stages, from, to, width, tolerance) {
  let sum = 0;
  for (let k = 0; k < from.length; k += 1) {
    let error = 0;
    for (let j = 0; j < stages.length; j += 1) error += ERROR_SHARES[j] * stages[j][k];
    const scale = tolerance * (1 + Math.max(Math.abs(from[k]), Math.abs(to[k])));
    sum += ((width * error) / scale) ** 2;
  }
  return Math.sqrt(sum / from.length);
}

function areNumbers(list) {
  return list.every(Number.isFinite);
}

// The first step: short enough that the state changes by little.
function firstWidth(state, begins, span, tolerance) {
  const size = (list) => Math.sqrt(list.reduce((sum, x, k) => sum + (x / (tolerance * (1 + Math.abs(state[k])))) ** 2, 0) / state.length);
  const [height, slope] = [size(state), size(begins)];
  const width = height < 1e-5 || slope < 1e-5 ? 1e-6 : (0.01 * height) / slope;
  return Math.min(width, span);
}

// Integrates `state' = rates(state)` from the first of `times` to all others. `take(row, state, rates)` gets the states at the times, and
// `watch({ time, width, from, to, after })` each step, where `after(part)` is the state after a part of its width. Where `watch` returns an object, the motion ends.
// Returns null at the last time, else why the motion ends with the time and the state there.
function integrated({ rates, state, times, tolerance, mostSteps, take, watch = () => null }) {
  const size = state.length;
  const attempt = stepperOf(rates, size);
  const shortest = SHORTEST_STEP * Math.max(...times.map(Math.abs));
  let [from, to] = [Float64Array.from(state), new Float64Array(size)];
  let [begins, ends] = [new Float64Array(size), new Float64Array(size)];
  let time = times[0];
  rates(from, begins);
  if (!areNumbers(begins)) return { why: "undefined", time, state: from };
  take(0, from, begins);
  let proposed = firstWidth(from, begins, times.at(-1) - time, tolerance);
  let steps = 0;
  for (let row = 1; row < times.length; row += 1) {
    while (time < times[row]) {
      const left = times[row] - time;
      const isLast = proposed >= left * (1 - ROUNDED_TIME);
      const width = isLast ? left : proposed;
      const stages = attempt(from, begins, width, to, ends);
      const error = errorOfStep(stages, from, to, width, tolerance);
      const growth = CAUTION * error ** -0.2;
      if (!(error <= 1)) {
        proposed = Number.isNaN(growth) ? SHORTER_STEP * width : Math.max(LEAST_GROWTH, growth) * width;
        if (proposed < shortest) return { why: Number.isNaN(error) ? "undefined" : "tolerance", time, state: from, rates: begins, left };
        continue;
      }
      if (!areNumbers(ends)) {
        proposed = SHORTER_STEP * width;
        if (proposed < shortest) return { why: "undefined", time, state: from, rates: begins, left };
        continue;
      }
      steps += 1;
      const found = watch({ time, width, from, to, after: (part) => stateAfter(rates, from, begins, part) });
      if (found !== null) return found;
      if (steps >= mostSteps) return { why: "steps", time, state: from, rates: begins, left };
      const grown = Math.min(MOST_GROWTH, growth) * width;
      // A step that a row cuts short does not shorten the next one.
      proposed = width < proposed ? Math.max(proposed, grown) : grown;
      time = isLast ? times[row] : time + width;
      [from, to, begins, ends] = [to, from, ends, begins];
    }
    take(row, from, begins);
  }
  return null;
}

// The state after a single step of this width.
function stateAfter(rates, from, begins, width) {
  const [to, ends] = [new Float64Array(from.length), new Float64Array(from.length)];
  stepperOf(rates, from.length)(from, begins, width, to, ends);
  return to;
}

// The time within a step at which a function of the state is zero, which has other signs at its ends. Bisection, to the last digits.
function zeroWithin({ width, after }, height) {
  let [low, high] = [0, width];
  const sign = Math.sign(height(after(0)));
  for (let k = 0; k < 60 && high - low > 1e-16 * width; k += 1) {
    const middle = low + (high - low) / 2;
    if (Math.sign(height(after(middle))) === sign) low = middle;
    else high = middle;
  }
  return high;
}
