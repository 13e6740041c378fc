// Dwells with the present dimensions: the longest interval of the input in which a quantity stays within the band of the report's dwell.

// The longest dwell of the report's mechanism is told apart from another one by this part of the range.
const SAME_DWELL = 1e-6;
// Roundoffs by which a row beside a limit may seem to lie beyond it.
const SLACK = 16 * Number.EPSILON;

// Quantities whose dwell in the report is not the longest one, or is one of several: they keep their values.
const otherDwells = new Set();

function startDwells() {
  otherDwells.clear();
  for (const { quantity, value } of live.summary.filter(({ what }) => what === "dwell, from")) {
    const same = live.summary.filter((row) => row.quantity === quantity && row.what === "dwell, from");
    const found = dwellNow(quantity);
    const near = found && Math.abs(found.from - value) <= SAME_DWELL * (input.values.at(-1) - input.values[0]);
    if (same.length > 1 || !near) otherDwells.add(quantity);
  }
  coursesNow.clear();
}

function dwellNow(quantity) {
  const course = courseNow(quantity);
  // Rows may be a user's own: nothing is known of a dwell without its band.
  const band = live.summary.find((row) => row.quantity === quantity && row.what === "dwell, band")?.value;
  return course === null || band === undefined ? undefined : longestDwell(course, band);
}

function dwellFigure(quantity, what) {
  if (otherDwells.has(quantity)) return undefined;
  const dwell = dwellNow(quantity);
  if (!dwell) return dwell;
  const value = dwell[what.slice("dwell, ".length)];
  if (value === undefined) return undefined;
  return what === "dwell, from" || what === "dwell, to" ? { value, at: value } : { value };
}

function longestDwell(course, band) {
  const stops = stopsOf(course);
  if (course.isCycle && !course.hasGaps && spanOf(course.numbers) <= band) return dwellOf(course, stops, [course.low, course.high]);
  const turns = stops.filter((stop) => stop.sign !== 0 && stop.u >= course.low && stop.u <= course.high);
  const around = turns.map((stop) => aroundLimit(course, stops, stop, band));
  const [best] = around.sort((a, b) => b[1] - b[0] - (a[1] - a[0]));
  const rough = longestOfStops(stops, band);
  const isShorter = best === undefined || (rough !== null && rough.length > best[1] - best[0]);
  const ends = isShorter ? rough && throughBand(course, stops, rough, band) : best;
  return ends && dwellOf(course, stops, ends);
}

function spanOf(numbers) {
  const known = numbers.filter((x) => x !== null);
  return Math.max(...known) - Math.min(...known);
}

// Rows and limits in order, those of a cycle thrice; the ends of a course and of its parts are limits, too.
function stopsOf(course) {
  const rows = course.numbers.map((value, row) => ({ u: input.values[row], value: value ?? NaN, sign: 0, turns: false }));
  if (course.isCycle) rows.pop();
  const turns = course.limits.map(({ u, sign }) => ({ u, value: course.at(u), sign, turns: true }));
  const once = [...rows, ...turns].sort((a, b) => a.u - b.u);
  const later = (cycle) => once.map((stop) => ({ ...stop, u: stop.u + cycle * course.width, value: stop.value + cycle * course.advance }));
  const all = course.isCycle ? [-1, 0, 1].flatMap(later) : once;
  return all.map((stop, k) => ({ ...stop, sign: stop.sign || endSign(all, k) }));
}

// 1 where a part of the course begins or ends with its highest value, -1 with its lowest.
function endSign(stops, k) {
  const isThere = (n) => stops[n] !== undefined && !Number.isNaN(stops[n].value);
  if (!isThere(k) || isThere(k - 1) === isThere(k + 1)) return 0;
  const beside = stops[isThere(k - 1) ? k - 1 : k + 1];
  return Math.sign(stops[k].value - beside.value);
}

// The interval in which the quantity stays in the band that the limit closes.
function aroundLimit(course, stops, { u, value, sign }, band) {
  const bounds = sign > 0 ? [value - band, value] : [value, value + band];
  return [-1, 1].map((way) => leaves(course, stops, u, way, bounds));
}

// The place where the quantity leaves the bounds in one direction from `u`.
function leaves(course, stops, u, way, [low, high]) {
  const slack = SLACK * Math.max(Math.abs(low), Math.abs(high));
  const isIn = (value) => value >= low - slack && value <= high + slack;
  let inside = u;
  for (let k = way > 0 ? 0 : stops.length - 1; k >= 0 && k < stops.length; k += way) {
    const stop = stops[k];
    if ((stop.u - u) * way <= 0) continue;
    if (!isIn(stop.value)) return lastWhere((x) => isIn(course.at(x)), inside, stop.u);
    inside = stop.u;
  }
  return inside;
}

// The longest row of stops within the band.
function longestOfStops(stops, band) {
  let best = null;
  let first = 0;
  let [highest, lowest] = [1, -1].map((sign) => mostOfWindow(stops, sign));
  for (let last = 0; last < stops.length; last += 1) {
    if (Number.isNaN(stops[last].value)) {
      first = last + 1;
      [highest, lowest] = [1, -1].map((sign) => mostOfWindow(stops, sign));
      continue;
    }
    for (const most of [highest, lowest]) most.add(last);
    while (first < last && highest.from(first) - lowest.from(first) > band) first += 1;
    const length = first < last ? stops[last].u - stops[first].u : 0;
    if (length > (best?.length ?? 0)) best = { first, last, length };
  }
  return best;
}

// The highest value of a window that only goes forward, or with sign -1 the lowest one: stops stand in a queue until a later one surpasses them,
// so that each is looked at twice at most, however long the window is.
function mostOfWindow(stops, sign) {
  const queue = [];
  let head = 0;
  return {
    add(index) {
      while (queue.length > head && sign * stops[queue.at(-1)].value <= sign * stops[index].value) queue.pop();
      queue.push(index);
    },
    from(first) {
      while (queue[head] < first) head += 1;
      return stops[queue[head]].value;
    },
  };
}

// An interval in which the quantity goes through the whole band: its beginning is moved until it is longest.
function throughBand(course, stops, { first, last }, band) {
  const rises = stops[last].value > stops[first].value;
  const endFrom = (start) => {
    const value = course.at(start);
    return leaves(course, stops, start, 1, rises ? [value, value + band] : [value - band, value]);
  };
  const length = (start) => endFrom(start) - start;
  const [low, high] = [stops[Math.max(0, first - 1)].u, stops[Math.min(stops.length - 1, first + 1)].u];
  const [start] = goldenSections(low, high, (a, b) => length(a) > length(b));
  return [start, endFrom(start)];
}

function dwellOf(course, stops, [from, to]) {
  const within = stops.filter(({ u }) => u >= from && u <= to);
  const turns = within.filter((stop) => stop.turns);
  const all = [course.at(from), course.at(to), ...within.map(({ value }) => value)];
  const range = to - from;
  const place = (u) => (course.isCycle ? u - Math.floor((u - course.low) / course.width) * course.width : u);
  const start = place(from);
  const end = range >= course.width ? course.high : place(to);
  return { from: start, to: end <= course.low && range > 0 ? course.high : end, range, band: spanOf(all), ripple: turns.length > 1 ? spanOf(turns.map(({ value }) => value)) : 0 };
}
