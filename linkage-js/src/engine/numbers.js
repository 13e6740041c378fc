// Operations that JavaScript does not have, or not with these results: those of generated Rust. Tangents and arcs of single numbers are the browser's.

const EIGHT_ROUNDOFFS = CORE.ROUNDINGS * Number.EPSILON;
// From here on a tangent is noise, as sines are (TOO_LARGE).
const LARGEST_ANGLE = 2 ** 30;
const TURN = 2 * Math.PI;

function tangent(x) {
  return Math.abs(x) < LARGEST_ANGLE ? Math.tan(x) : NaN;
}

// By how much rounding may turn negative what was computed from terms of the size x; NaN where that is infinite.
function slack(x) {
  return EIGHT_ROUNDOFFS * Math.abs(x) + 0 * x;
}

// The square root of a discriminant: 0 where it is negative by no more than slack times size, so that a group closes up to its dead point,
// and NaN beyond.
function root(q, slack, size) {
  return slack * size + q >= 0 ? Math.sqrt(Math.max(q, 0)) : NaN;
}

// a / b, and no number where that is infinite: a rate where the root of a discriminant is 0.
function quotient(a, b) {
  return a / b + 0 * (a / b);
}

// a where s is not negative, b where it is, NaN where it is NaN.
function select(s, a, b) {
  if (s >= 0) return a;
  return s < 0 ? b : NaN;
}

function signOf(s) {
  return select(s, 1, -1);
}

// A power of two near 1/|x|, 1 for zero and what is not finite: scales lengths without rounding.
function inverseScale(x) {
  if (!(x !== 0 && Math.abs(x) < Infinity)) return 1;
  doubles[0] = x;
  // Powers whose reciprocals are no subnormal numbers.
  const exponent = Math.min(Math.max((words[HIGH] >>> 20) & 0x7ff, 1), 2045);
  words[HIGH] = (2046 - exponent) << 20;
  words[1 - HIGH] = 0;
  return doubles[0];
}

// The length of (a, b), without overflow on the way.
function hypot(a, b) {
  const scale = inverseScale(Math.max(Math.abs(a), Math.abs(b)));
  const x = a * scale;
  const y = b * scale;
  return Math.sqrt(x * x + y * y) * inverseScale(scale);
}

// The nearest integer; a half goes to the even one.
function whole(x) {
  return x + ROUND - ROUND;
}

// A turn in two parts: products of the first one with whole numbers are exact.
const TURN_HIGH = 6.2831853069365025;
const TURN_LOW = 2.430840202602477e-10;

// The direction of (x, y), with the whole turns that bring it nearest to guide.
function angleNear(y, x, guide) {
  const angle = angleOf(y, x);
  const turns = whole((guide - angle) * (1 / TURN));
  return angle + turns * TURN_LOW + turns * TURN_HIGH;
}
