// Numbers as words: all the digits that they have, few to read, and round ones for axes.

// The shortest decimals that mean this very number; a value that does not exist is said to be none.
function digits(value) {
  return value === null || value === undefined ? "none" : String(value);
}

function rounded(value, significant) {
  return value === null ? null : Number(value.toPrecision(significant));
}

// Digits of tables and legends: a micrometre of a metre. Files and copies have all digits.
const SIGNIFICANT = 6;
// Whole numbers below this are shown with all digits: counts, and numbers from the program.
const LARGEST_WHOLE = 1e9;

function short(value) {
  if (value === null || value === undefined) return "none";
  if (Number.isInteger(value) && Math.abs(value) < LARGEST_WHOLE) return digits(value);
  const round = rounded(value, SIGNIFICANT);
  // Zeros in the place of digits that were left out would seem to be known.
  return Math.abs(round) < 10 ** SIGNIFICANT ? digits(round) : round.toExponential();
}

function toDegrees(radians) {
  return radians === null ? null : (radians * 180) / Math.PI;
}

// Degrees never stand without the radians that they come from.
function withUnit(value, unit) {
  if (value === null || value === undefined) return "none";
  if (unit === "rad") return `${short(toDegrees(value))} deg (${short(value)} rad)`;
  return unit ? `${short(value)} ${unit}` : short(value);
}

// Angles are plotted in degrees, everything else as it is.
function plotUnit(unit) {
  return unit === "rad" ? "deg" : unit;
}

// A number of a plot as it is.
function fromPlot(value, unit) {
  return unit === "rad" ? (value * Math.PI) / 180 : value;
}

function plotValue(value, unit) {
  return unit === "rad" ? toDegrees(value) : value;
}

// A round step with at most `most` steps between the ends.
function roundStep(low, high, most, unit) {
  const least = (high - low) / Math.max(1, most);
  const turn = [1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360].find((step) => step >= least);
  if (unit === "deg" && least > 0.5 && turn !== undefined) return turn;
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= least * (1 - 1e-9));
}

function ticks(low, high, most, unit) {
  if (!(high > low)) return [low];
  const step = roundStep(low, high, most, unit);
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  const places = [];
  // Multiplied and not added up, so that zero is zero; counted from zero, since beyond 2^53 there is no next number.
  for (let n = 0; n <= last - first; n += 1) places.push(rounded((first + n) * step, 12));
  return places;
}

// Something like 1, 2, 5, 10, 20, ... not above `most`: lengths of scale bars.
function roundBelow(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * [5, 2, 1].find((factor) => factor * power <= most * (1 + 1e-9));
}
