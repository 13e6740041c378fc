// Sine, cosine and the angle of a vector by the operations of generated Rust, in its order, without fused multiply-adds: the same numbers, to the
// last bit, in every browser.

// Added and taken away again, it leaves whole numbers.
const ROUND = 1.5 * 2 ** 52;
// From 2^30 on neighbouring numbers are so far apart that a sine is noise: multiplied by this one, they become infinite.
const TOO_LARGE = 2 ** 994;
// Right angles in parts: 23 bits twice and 36, whose products with whole numbers are exact, and the rest.
const RIGHT = [1.570796251296997, 7.549789415861596e-08, 5.390302858141673e-15, 1.6446256936324258e-26];
const SINE = [-0.1666666666666663, 0.008333333333322116, -0.00019841269829588127, 2.7557313620878265e-6, -2.5050747680755826e-8, 1.5896225253711582e-10];
const COSINE = [0.041666666666666595, -0.0013888888888873054, 2.4801587288850152e-5, -2.75573141788365e-7, 2.0875700777873804e-9, -1.1358533125225159e-11];

// The cosine of the angle whose sine was asked for last: the two are found together.
let beside = NaN;

function sine(x) {
  const n = x * (2 / Math.PI) + ROUND - ROUND;
  const rest = x - n * RIGHT[0] - n * RIGHT[1];
  const product = n * RIGHT[2];
  const high = rest - product;
  const low = x * TOO_LARGE * 0 + (rest - high - product - n * RIGHT[3]);
  const z = high * high;
  const z2 = z * z;
  const half = -0.5 * high;
  const base = half * high + 1;
  const s = high + (high * z * sixTerms(SINE, z, z2) + low * base);
  const c = base + (z2 * sixTerms(COSINE, z, z2) + (-high * low + (half * high + (1 - base))));
  const quarter = n & 3;
  const odd = (quarter & 1) === 1;
  beside = quarter === 1 || quarter === 2 ? -(odd ? s : c) : odd ? s : c;
  // The sine of -0 is 0.
  return (quarter >= 2 ? -(odd ? c : s) : odd ? c : s) + 0;
}

function cosine(x) {
  sine(x);
  return beside;
}

function sixTerms(c, z, z2) {
  return ((c[5] * z + c[4]) * z2 + (c[3] * z + c[2])) * z2 + (c[1] * z + c[0]);
}

// (atan(t) - t) / t^3 in powers of t^2.
const ARC = [
  -0.3333333333333307, 0.19999999999951756, -0.14285714282588602, 0.11111111007357623, -0.09090907008061716, 0.07692279891726214, -0.06666404444295934,
  0.05880529924658981, -0.05253527287082789, 0.047223501098321345, -0.04219248393782121, 0.036643265015795866, -0.029905926580170068,
  0.021987313385180722, -0.013902812077726439, 0.007198057104861487, -0.0028856993516507413, 0.0008315912991809981, -0.00015221789472131463,
  1.3230652873041794e-05,
];

function arcOf(z) {
  const z2 = z * z;
  const z4 = z2 * z2;
  const z8 = z4 * z4;
  const pair = (k) => ARC[k + 1] * z + ARC[k];
  const four = (k) => pair(k + 2) * z2 + pair(k);
  const last = (ARC[19] * z2 + pair(17)) * z4 + four(13);
  const first = four(5) * z4 + four(1);
  return ((last * z4 + four(9)) * z8 + first) * z + ARC[0];
}

const doubles = new Float64Array(1);
const words = new Uint32Array(doubles.buffer);
// Which of the two words has sign and exponent.
doubles[0] = 1;
const HIGH = words[1] === 0 ? 0 : 1;
const LEAST = 2 ** -1022;
// Of the right angle what its number has no digits for.
const RIGHT_LOW = 6.123233995736766e-17;

function isNegative(x) {
  doubles[0] = x;
  return words[HIGH] >>> 31 === 1;
}

// The first half of the digits: products of two such numbers are exact.
function halfOf(x) {
  doubles[0] = x;
  words[1 - HIGH] &= 0xf8000000;
  return doubles[0];
}

// One over the power of two in a positive number.
function inversePower(x) {
  doubles[0] = x;
  words[HIGH] = (2046 - Math.min((words[HIGH] >>> 20) & 0x7ff, 2045)) << 20;
  words[1 - HIGH] = 0;
  return doubles[0];
}

// The angle of the vector (x, y), from -pi to pi.
function angleOf(y, x) {
  const [width, height] = [Math.abs(x), Math.abs(y)];
  if (!(width >= 0 && height >= 0)) return NaN;
  const steep = height > width;
  const scale = inversePower(steep ? height : width);
  const long = Math.min((steep ? height : width) * scale, 1 / LEAST);
  const behind = isNegative(x);
  const size = Math.min((steep ? width : height) * scale, 1 / LEAST);
  const short = behind !== steep ? -size : size;
  // The quotient in two parts.
  const reciprocal = 1 / Math.max(long, LEAST);
  const rough = short * reciprocal;
  const [first, longFirst] = [halfOf(rough), halfOf(long)];
  const second = (short - first * longFirst - first * (long - longFirst)) * reciprocal;
  const ratio = first + second;
  const low = first - ratio + second;
  const count = steep ? 1 : behind ? 2 : 0;
  const base = count * (Math.PI / 2);
  const sum = base + ratio;
  const z = ratio * ratio;
  const rest = low * (z * -0.5 + 1) + (count * RIGHT_LOW + (base - sum + ratio));
  const angle = sum + (ratio * z * arcOf(z) + rest);
  return isNegative(y) ? -angle : angle;
}
