// Centres and windings of angles: an angle is the one of its direction that is nearest to centre + the sum of winding * input.

// See followed: the middle of several motions may not be larger.
const MOST_MIDDLE = CORE.MOST_MIDDLE * Math.PI;
// The vectors beside the longest one turn their sum by less than 0.45 pi if they add up to no more than this part of its length.
const MOST_BESIDE = 0.9876883405951378;

// Each angle at its estimate, and no turns: right at the reference.
function noTurns(own) {
  own.windings.fill(0);
  own.unit.angles.forEach((angle, index) => (own.centres[index] = angle.estimate));
  own.unit.prepare(own, own.prepared);
}

// Finds the turns of the first `count` angles from the inputs `at`, and prepares what depends on them; the name of the one that cannot be followed, or null.
function windFrom(own, count, at) {
  const { unit } = own;
  noTurns(own);
  if (count === 0) return null;
  const vectors = new Float64Array(unit.bearingNumbers);
  unit.bearings(own, vectors);
  const directions = new Float64Array(2 * unit.angles.length);
  let first = 0;
  for (let index = 0; index < count; index += 1) {
    const angle = unit.angles[index];
    const here = near({ direction: directionOf(own, index, at, directions) }, null, angle.estimate);
    if (Number.isNaN(here)) return angle.name;
    const turns = uniform(angle, vectors, first, at, here) ?? alongInputs(own, index, at, here, directions);
    if (turns === null) return angle.name;
    own.centres[index] = turns.centre;
    own.windings.set(turns.windings, index * unit.inputs.length);
    unit.prepare(own, own.prepared);
    first += angle.phases.length;
  }
  return null;
}

// The same from the reference or, where it does not assemble there, from `at`.
function wind(own, count, at) {
  const { reference } = own.unit;
  const lost = windFrom(own, count, reference);
  if (lost === null || at.every((x, index) => x === reference[index])) return lost;
  return windFrom(own, count, at);
}

// A vector at angle `index`, as a function of one input; of none at the inputs themselves.
function directionOf(own, index, at, directions, input = null) {
  const x = Float64Array.from(at);
  return (value) => {
    if (input !== null) x[input] = value;
    own.unit.directions(own, x, own.statesAt(x), directions);
    return [directions[2 * index], directions[2 * index + 1]];
  };
}

// By a vector of fixed length that is longer than all others together, if it turns with the inputs alone: the angle turns with it. Null if no
// vector decides.
function uniform(angle, vectors, first, at, here) {
  const lengths = angle.phases.map((_, k) => hypot(vectors[2 * (first + k)], vectors[2 * (first + k) + 1]));
  const all = lengths.reduce((sum, length) => sum + length, 0);
  const longest = lengths.findIndex((length) => length > 0 && all - length <= MOST_BESIDE * length);
  const windings = angle.phases[longest] ?? null;
  if (windings === null) return null;
  const turned = windings.reduce((sum, turns, input) => sum + turns * at[input], 0);
  const centre = angleOf(vectors[2 * (first + longest) + 1], vectors[2 * (first + longest)]);
  return { centre: centre + TURN * whole((here - (centre + turned)) / TURN), windings };
}

// By following the angle along each of its inputs. The middles of these motions add up.
function alongInputs(own, index, at, here, directions) {
  const { unit } = own;
  const angle = unit.angles[index];
  const windings = new Float64Array(unit.inputs.length);
  let [middle, turned, inputs] = [0, 0, 0];
  for (const input of angle.inputs) {
    const { followed: range, rates } = unit.inputs[input];
    const x = at[input];
    const [low, high] = [Math.min(range[0], x), Math.max(range[1], x)];
    if (low === high) continue;
    const direction = directionOf(own, index, at, directions, input);
    const line = followed(low, high, x, here, rates, direction);
    if (line === null) return null;
    windings[input] = line.rate;
    middle += line.middle + line.rate * x - here;
    turned += line.rate * x;
    inputs += 1;
  }
  // A larger sum would leave the angle at the start too little of its half turn.
  if (Math.abs(middle) > MOST_MIDDLE) middle /= inputs;
  return { centre: here + middle - turned, windings };
}
