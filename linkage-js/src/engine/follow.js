// How an angle turns while an input runs through its range.

// Remainders should stay below this, so that inputs a little outside the range are served too.
const COMFORT = CORE.COMFORTABLE_STRAY * Math.PI;
// Remainders must stay below this.
const MOST_STRAY = CORE.MOST_STRAY * Math.PI;
// Longer walks are not begun: thousands of turns of the fastest rate.
const MOST_RADIANS = 16384;
const HALVINGS = 30;
// An angle that turns by more in one step is looked at in between.
const MOST_TURN = 0.5;

// The line of one of these rates, or of the mean slope, from which the angle strays by less than half a turn over low .. high; null if there
// is none. Among lines that it strays little from the slowest whole rate is taken, since that serves beyond the range, too. direction(x) is a
// vector at the angle.
function followed(low, high, reference, estimate, rates, direction) {
  const fastest = Math.max(0, ...rates.map(Math.abs));
  if (!((high - low) * fastest <= MOST_RADIANS)) return null;
  // A part of the range, short enough that the fastest rate turns by a quarter radian.
  const range = high - low;
  const step = Math.max(Math.min(range / 256, 0.25 / Math.max(fastest, 1)), range / 65536);
  const path = { reference, estimate, direction };
  const strays = rates.map(strayFrom);
  const slope = walk(path, low, high, step, strays);
  if (slope === null) return null;
  let best = strays.reduce((best, stray) => (best === null || better(stray, best) ? stray : best), null);
  if (best === null || !(width(best) < MOST_STRAY)) {
    best = strayFrom(slope);
    walk(path, low, high, step, [best]);
  }
  return width(best) < MOST_STRAY ? { rate: best.rate, middle: (best.least + best.most) / 2 } : null;
}

function strayFrom(rate) {
  return { rate, least: Infinity, most: -Infinity };
}

function width(stray) {
  return (stray.most - stray.least) / 2;
}

function better(other, own) {
  const [its, mine] = [width(other), width(own)];
  if (mine < COMFORT && its < COMFORT) {
    const isWhole = Number.isInteger(own.rate);
    if (isWhole !== Number.isInteger(other.rate)) return !isWhole;
    const faster = Math.abs(other.rate) - Math.abs(own.rate);
    return faster < 0 || (faster === 0 && its < mine);
  }
  if (mine < COMFORT) return false;
  return its < COMFORT || its < mine;
}

// Follows the angle from the reference to both ends; its mean slope, null if it does not exist at the reference.
function walk(path, low, high, step, strays) {
  const angle = near(path, path.reference, path.estimate);
  if (Number.isNaN(angle)) return null;
  const [lower, upper] = [low, high].map((end) => oneWay(path, end, step, angle, strays));
  return upper.x > lower.x ? (upper.angle - lower.angle) / (upper.x - lower.x) : 0;
}

// To one end, as far as the angle exists.
function oneWay(path, end, step, angle, strays) {
  const run = end - path.reference;
  const steps = step > 0 ? Math.floor(Math.abs(run) / step) + 1 : 1;
  let last = { x: path.reference, angle };
  include(strays, last);
  for (let k = 1; k <= steps; k += 1) {
    const target = k === steps ? end : path.reference + run * (k / steps);
    while (last.x !== target) {
      const next = advance(path, last, target);
      if (Number.isNaN(next.angle)) return last;
      last = next;
      include(strays, last);
    }
  }
  return last;
}

function include(strays, { x, angle }) {
  for (const stray of strays) {
    const rest = angle - stray.rate * x;
    stray.least = Math.min(stray.least, rest);
    stray.most = Math.max(stray.most, rest);
  }
}

// A step towards target, halved while the angle turns by much: the nearest of the angles that fit is the one that was meant.
function advance(path, from, target) {
  let next = { x: target, angle: near(path, target, from.angle) };
  for (let halvings = 0; halvings < HALVINGS; halvings += 1) {
    const middle = from.x + 0.5 * (next.x - from.x);
    if (Math.abs(next.angle - from.angle) <= MOST_TURN || middle === from.x || middle === next.x) break;
    next = { x: middle, angle: near(path, middle, from.angle) };
  }
  return next;
}

// The angle at x that is nearest to guide; NaN where there is none.
function near(path, x, guide) {
  const [cosine, sine] = path.direction(x);
  if (!Number.isFinite(cosine) || !Number.isFinite(sine) || (cosine === 0 && sine === 0)) return NaN;
  const turn = angleOf(sine, cosine) - guide;
  return guide + (turn - TURN * whole(turn / TURN));
}
