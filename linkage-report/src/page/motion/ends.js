// Ends of a motion before its time: stops of the command, dead points, positions without accelerations.

// Difference between slope and acceleration, as a part of the larger one, beyond which a reversal is a dead point: there the inertia is infinite, and the
// speed changes its sign without an acceleration for it.
const OTHER_SLOPE = 0.5;
// Changes of a speed below this multiple of its tolerance are rounding.
const SPEED_NOISE = 100;
// The part of a step over which a slope is taken.
const SLOPE_SPAN = 1e-3;
// Parts of the largest speed below which a dead point is looked for ahead: after each step, and after the last one. Nearer to it an input has no digits for its
// distance.
const SLOW_SPEED = { step: 1e-4, last: 0.05 };
// Multiples of the tolerance that are slow, too.
const SMALL_SPEED = 20;
// The change of the acceleration on half of the way to rest below which it is the same.
const STEADY_CHANGE = 0.05;

function isOtherSlope(slope, acceleration) {
  return Math.abs(slope - acceleration) > OTHER_SLOPE * Math.max(Math.abs(slope), Math.abs(acceleration));
}

// Looks at the steps of a motion: returns the first end within a step or directly after it, or null. `fastest` gets the largest speed of each input.
function watchedEnds(programs, rates, fastest) {
  const heights = stopHeights(programs);
  // A value that is zero keeps the sign before it.
  const last = heights.map(() => null);
  return (step) => {
    const found = [];
    heights.forEach((height, k) => {
      last[k] ??= height(step.from);
      const value = height(step.to);
      if (last[k] * value < 0) {
        const part = zeroWithin(step, height);
        found.push({ why: "stop", stop: k, part });
      }
      if (value !== 0) last[k] = value;
    });
    for (let k = 0; k < driven.inputs.length; k += 1) {
      const part = deadPointWithin(step, rates, k);
      if (part !== null) found.push({ why: "dead point", input: k, part });
    }
    if (found.length === 0) {
      const end = { time: step.time + step.width, state: step.to };
      noteSpeeds(fastest, end.state);
      return deadPointAhead(rates, end, fastest, SLOW_SPEED.step, driven.tolerance);
    }
    const first = found.reduce((best, own) => (own.part < best.part ? own : best));
    return { ...first, time: step.time + first.part, state: step.after(first.part) };
  };
}

// The time within a step at which an input is at its dead point; null if it is not.
function deadPointWithin(step, rates, k) {
  const place = driven.inputs.length + k;
  const [before, after] = [step.from[place], step.to[place]];
  if (!(before * after < 0)) return null;
  if (Math.abs(after - before) < SPEED_NOISE * driven.tolerance * (1 + Math.max(Math.abs(before), Math.abs(after)))) return null;
  const part = zeroWithin(step, (state) => state[place]);
  const span = SLOPE_SPAN * step.width;
  const slope = (step.after(part + span)[place] - step.after(part - span)[place]) / (2 * span);
  return isOtherSlope(slope, accelerationAt(rates, step.after(part), k)) ? part : null;
}

function noteSpeeds(fastest, state) {
  for (let k = 0; k < fastest.length; k += 1) fastest[k] = Math.max(fastest[k], Math.abs(state[fastest.length + k]));
}

function accelerationAt(rates, state, k) {
  const out = new Float64Array(state.length);
  rates(state, out);
  return out[driven.inputs.length + k];
}

// The input that comes to its dead point directly after a state, with the time and the state there, and that last state; null if none does. Speeds below `least` are rounding. A slow
// input that brakes comes to rest within `-v / a`. Where its acceleration is the same after half of that time, it is nearly the same at rest; at a dead point it is not.
function deadPointAhead(rates, { time, state }, fastest, slow, least) {
  const count = driven.inputs.length;
  for (let k = 0; k < count; k += 1) {
    const speed = Math.abs(state[count + k]);
    if (!(speed >= least && speed < Math.max(slow * fastest[k], SMALL_SPEED * least))) continue;
    const acceleration = accelerationAt(rates, state, k);
    const left = -state[count + k] / acceleration;
    if (!(left > 0 && Number.isFinite(left))) continue;
    const after = (part) => {
      const next = Float64Array.from(state);
      for (let i = 0; i < count; i += 1) next[i] += part * left * state[count + i] * (i === k ? 1 - 0.5 * part : 1);
      next[count + k] *= 1 - part;
      return next;
    };
    const isSteady = Math.abs(accelerationAt(rates, after(0.5), k) - acceleration) <= STEADY_CHANGE * Math.abs(acceleration);
    const atRest = accelerationAt(rates, after(1), k);
    if (isSteady && (Number.isNaN(atRest) || isOtherSlope(acceleration, atRest))) return { why: "dead point", input: k, time: time + left, state: after(1), last: { time, state } };
  }
  return null;
}

// The end as a sentence, as the command has it; null for the whole time.
function endWords(programs, end) {
  if (end === null) return null;
  const after = `after ${digits(rounded(end.time, 6))} s`;
  const at = driven.inputs.map(({ name }, k) => `${name} = ${stateText(programs, k, end.state[k])}`).join(", ");
  const words = {
    stop: () => `The motion stops at ${driven.stops[end.stop].text} ${after}.`,
    "dead point": () => `The motion ends ${after} at a dead point, ${driven.inputs[end.input].name} = ${stateText(programs, end.input, end.state[end.input])}.`,
    undefined: () => `The motion ends ${after} at ${at}: there are no accelerations beyond${openWords(programs, end)}.`,
    tolerance: () => `The motion ends ${after} at ${at}: no step is short enough for the tolerance.`,
    steps: () => `The motion ends ${after} at ${at}: it takes too many steps here; the command has --stiff for such motions.`,
  };
  return words[end.why]();
}

function stateText({ unit }, k, value) {
  const { unit: own } = unit.inputs[k];
  return `${digits(rounded(plotValue(value, own), 6))} ${plotUnit(own)}`.trim();
}

// The group that does not close a little later, if one does not.
function openWords({ number, unit }, { state, rates: slopes, left }) {
  if (slopes === undefined) return "";
  const own = live.assemblies[number];
  const group = [1e-9, 1e-6, 1e-3, 1].map((share) => {
    const beyond = Float64Array.from(driven.inputs, (_, k) => state[k] + share * left * slopes[k]);
    return engine.gapsAt(own, beyond).findIndex((gap) => gap > 0);
  }).find((index) => index >= 0);
  return group === undefined ? "" : `, where ${groupWords(unit.groups[group])} does not close`;
}
