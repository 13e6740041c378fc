// The course of a quantity over the range with the present dimensions: its limits, which are roots of its derivative, and the time ratio, as the
// report's figures have them.

// Ends of a cycle agree up to this part of the largest value.
const SAME = 1e-9;
// Bisections after which only roundoff is left.
const HALVES = 60;
// Rates below so many roundoffs of their median are rounding, as in Rust.
const ROUNDING = 32 * Number.EPSILON;

// Courses are made for each change when a figure asks for them; null where no table has the quantity and its derivative.
const coursesNow = new Map();

function courseNow(quantity) {
  if (!coursesNow.has(quantity)) coursesNow.set(quantity, courseOf(quantity));
  return coursesNow.get(quantity);
}

function courseOf(quantity) {
  const [value, rate] = [0, 1].map((order) => quantityNow(quantity, order));
  return value === null || rate === null ? null : courseThrough(value, rate);
}

// The course of a number and its derivative; null over a range without width.
function courseThrough(value, rate) {
  const [low, high] = [input.values[0], input.values.at(-1)];
  const width = high - low;
  if (!(width > 0)) return null;
  const isCycle = isCycleOf(width, rate.numbers);
  const cyclesTo = (u) => (isCycle ? Math.floor((u - low) / width) : 0);
  // Over a cycle a quantity may advance, as the angle of a crank does.
  const advance = isCycle ? advanceOf(value.numbers) : 0;
  const course = {
    low, high, width, isCycle, advance,
    hasGaps: value.numbers.includes(null),
    numbers: value.numbers,
    at: (u) => value.at(u - cyclesTo(u) * width) + cyclesTo(u) * advance,
    rate: (u) => rate.at(u - cyclesTo(u) * width),
  };
  course.limits = limitsOf(course, rate.numbers, noiseOf(value.numbers, rate.numbers, width));
  return course;
}

function largestAmong(numbers) {
  return numbers.reduce((most, x) => Math.max(most, Math.abs(x ?? 0)), 0);
}

function isCycleOf(width, rates) {
  const turns = width / (2 * Math.PI);
  const isWhole = input.unit === "rad" && Math.abs(turns - Math.round(turns)) < SAME;
  const [first, last] = [rates[0], rates.at(-1)];
  return isWhole && first !== null && last !== null && Math.abs(last - first) <= SAME * largestAmong(rates);
}

function advanceOf(numbers) {
  const advance = numbers.at(-1) - numbers[0];
  return Math.abs(advance) <= SAME * largestAmong(numbers) ? 0 : advance;
}

// Up to which size a rate is no different from zero. The median is its size, since some rows may be next to a dead point; rates that could not
// change the quantity over the whole range beyond its rounding are nothing else.
function noiseOf(numbers, rates, width) {
  if (largestAmong(rates) * width <= ROUNDING * largestAmong(numbers)) return Infinity;
  const sizes = Float64Array.from(rates.filter((rate) => rate !== null), Math.abs).sort();
  return ROUNDING * (sizes[sizes.length >> 1] ?? 0);
}

// Turning points of the quantity within the range: `sign` is 1 where it is highest.
function limitsOf(course, all, noise) {
  const limits = [];
  // The last row of a cycle is its first one.
  const rates = course.isCycle ? all.slice(0, -1) : all;
  const isZero = (rate) => Math.abs(rate) <= noise;
  let before = null;
  if (course.isCycle) {
    const row = rates.findLastIndex((rate) => rate === null || !isZero(rate));
    if (row >= 0 && rates[row] !== null) before = { u: input.values[row] - course.width, sign: Math.sign(rates[row]) };
  }
  rates.forEach((rate, row) => {
    if (rate === null) before = null;
    if (rate === null || isZero(rate)) return;
    const here = { u: input.values[row], sign: Math.sign(rate) };
    if (before !== null && before.sign !== here.sign) {
      const turns = lastWhere((u) => Math.sign(course.rate(u)) === before.sign, before.u, here.u);
      limits.push({ u: turns < course.low ? turns + course.width : turns, sign: before.sign });
    }
    before = here;
  });
  return limits;
}

// The border between a place where something holds and one where it does not.
function lastWhere(holds, from, to) {
  for (let k = 0; k < HALVES; k += 1) {
    const middle = from + (to - from) / 2;
    if (holds(middle)) from = middle;
    else to = middle;
  }
  return from;
}

// The shares of both strokes in the input of a cycle; null unless there is one highest and one
// lowest place, to which the quantity returns.
function timesOf(course) {
  const [highs, lows] = [1, -1].map((sign) => course.limits.filter((limit) => limit.sign === sign));
  if (!course.isCycle || course.advance !== 0 || course.hasGaps || highs.length !== 1 || lows.length !== 1) return null;
  const way = highs[0].u - lows[0].u;
  const rise = way > 0 ? way : way + course.width;
  return { rise, fall: course.width - rise };
}

function timeFigure(quantity, what) {
  const course = courseNow(quantity);
  if (course === null) return undefined;
  const times = timesOf(course);
  if (times === null) return null;
  const { rise, fall } = times;
  return { value: { "rises in": rise, "falls in": fall, "time ratio": Math.max(rise, fall) / Math.min(rise, fall) }[what] };
}
