// The cyclogram with the present dimensions. Where an organ's limits and the bounds of its bands are is looked for between rows with the programs: turns
// are roots of the derivative, bounds those of the quantity, both halved until only its rounding is left.

// A column is the source of an organ if it has the value of each of its events, up to this part of
// its stroke.
const SAME_VALUE = 1e-9;

// The report's cyclogram, and the possible quantities of each of its organs.
const organs = { declared: report.cyclogram, sources: [] };

live.starts.push(() => {
  organs.sources = cycle.organs.map((organ) => live.tables.flatMap(sourcesIn).filter((source) => hasEvents(source, organ)));
  onChange(remakeCyclogram);
});

// Columns with a derivative in their table, and the same turned round.
function sourcesIn(own) {
  if (own.why !== null) return [];
  const { columns: all } = own.table;
  return all.flatMap(({ name, meaning }, value) => {
    const rate = meaning === "rate" ? -1 : all.findIndex(isRateOf(1, name));
    return rate < 0 ? [] : [1, -1].map((sign) => ({ own, value, rate, sign }));
  });
}

function sourceNow({ own, sign }, index) {
  const { numbers, at } = numberNow(own, index);
  return sign > 0 ? { numbers, at } : { numbers: numbers.map((x) => (x === null ? null : -x)), at: (x) => -at(x) };
}

function hasEvents(source, { events, lowest, highest }) {
  const { at } = sourceNow(source, source.value);
  return events.every((event) => Math.abs(at(event.at) - event.value) <= SAME_VALUE * (highest - lowest));
}

function cyclogramNow() {
  const all = organs.declared.organs.map((organ, index) => organNow(organ, organs.sources[index]));
  const order = all.flatMap(({ events }, organ) => events.map(({ at }, event) => ({ organ, event, at }))).sort((a, b) => a.at - b.at);
  const width = organs.declared.to - organs.declared.from;
  const after = (k) => (k > 0 ? order[k].at - order[k - 1].at : order[0].at - order.at(-1).at + width);
  const follows = (k) => ({ organ: order.at(k - 1).organ, event: order.at(k - 1).event });
  return { ...organs.declared, organs: all, order: order.map((moment, k) => ({ ...moment, after: after(k), follows: follows(k) })), overlaps: overlapsNow(all) };
}

// The current organ; without events and with the reason in `why` where it has no cycle. One whose
// quantity is not known `stands` as in the report.
function organNow(organ, [source, ...others]) {
  if (source === undefined) return { ...organ, stands: "no table that is computed here has its quantity and the derivative of that" };
  const course = courseThrough(...[source.value, source.rate].map((index) => sourceNow(source, index)));
  const none = (why) => ({ ...organ, intervals: [], events: [], why });
  if (course !== null && course.hasGaps) return none("it cannot be assembled over the whole cycle");
  const { from, to } = organs.declared;
  const isWhole = course !== null && course.isCycle && Math.abs(course.width - (to - from)) <= SAME * course.width;
  if (!isWhole) return { ...organ, stands: "the positions of the report are not the cycle" };
  if (course.advance !== 0) return none("it does not repeat itself");
  if (course.limits.length === 0) return none("it stands still over the whole cycle");
  const heights = course.limits.map(({ u }) => course.at(u));
  const [lowest, highest] = [Math.min(...heights), Math.max(...heights)];
  const bounds = organ.bounds.map((band) => boundsOf(band, lowest, highest));
  const why = mistakeOfBands(bounds, organ.bands, lowest, highest);
  if (why !== null) return none(why);
  const now = { ...organ, lowest, highest, ...motionsOf(marksOf(course, heights, bounds.flat().filter(Number.isFinite)), bounds) };
  // Quantities that were the same by chance: nothing tells which one it is.
  return others.every((other) => hasEvents(other, now)) ? now : { ...organ, stands: "several quantities are the same in the report, and are no longer" };
}

// Beyond the limit that a band is measured from there is nothing.
function boundsOf([kind, ...widths], lowest, highest) {
  if (kind === "top") return [highest - widths[0], Infinity];
  return kind === "bottom" ? [-Infinity, lowest + widths[0]] : widths;
}

function mistakeOfBands(bounds, bands, lowest, highest) {
  const motion = `the motion is from ${digits(rounded(lowest, 6))} to ${digits(rounded(highest, 6))}`;
  for (const [k, [low, high]] of bounds.entries()) {
    if (low >= highest || high <= lowest) return `nothing reaches the band ${bands[k]}: ${motion}`;
    if (low <= lowest && high >= highest) return `the whole motion is in the band ${bands[k]}: ${motion}`;
    const other = bounds.slice(0, k).findIndex(([a, b]) => Math.min(high, b, highest) > Math.max(low, a, lowest));
    if (other >= 0) return `the bands ${bands[other]} and ${bands[k]} overlap: ${motion}`;
  }
  return null;
}

// The places where the quantity turns or passes a level, in order, from the first row over a whole
// cycle.
function marksOf(course, heights, levels) {
  const rows = course.numbers.slice(0, -1).map((value, row) => ({ u: input.values[row], value, turns: false }));
  const turns = course.limits.map(({ u }, k) => ({ u, value: heights[k], turns: true }));
  const stops = [...rows, ...turns].sort((a, b) => a.u - b.u);
  const marks = [];
  stops.forEach((stop, k) => {
    const next = stops[k + 1] ?? { ...stops[0], u: stops[0].u + course.width };
    if (stop.turns) marks.push(stop);
    const passed = levels.filter((level) => stop.value < level !== next.value < level).map((level) => {
      const u = lastWhere((x) => course.at(x) < level === stop.value < level, stop.u, next.u);
      return { u, value: course.at(u) };
    });
    marks.push(...passed.sort((a, b) => a.u - b.u));
  });
  return marks;
}

// Motions between marks, and the events where they change.
function motionsOf(marks, bounds) {
  const motion = ({ value: a }, { value: b }) => {
    const middle = a + (b - a) / 2;
    const band = bounds.findIndex(([low, high]) => middle >= low && middle <= high);
    return band >= 0 ? { motion: "dwell", band } : { motion: b > a ? "advance" : "return", band: null };
  };
  const done = marks.map((mark, k) => motion(mark, marks[(k + 1) % marks.length]));
  const changes = marks.flatMap(({ u, value }, k) => {
    const [before, now] = [done.at(k - 1), done[k]];
    return before.motion === now.motion && before.band === now.band ? [] : [{ at: withinCycle(u), value, before, now }];
  }).sort((a, b) => a.at - b.at);
  const width = organs.declared.to - organs.declared.from;
  return {
    events: changes.map(({ at, value, before, now }) => ({ at, value, ends: before.motion, begins: now.motion, sensitivity: null, shift: null })),
    intervals: changes.map(({ at, now }, k) => {
      const next = changes[k + 1] ?? { at: changes[0].at + width };
      return { ...now, from: at, to: changes[(k + 1) % changes.length].at, range: next.at - at };
    }),
  };
}

function remakeCyclogram() {
  report.cyclogram = isChanged() ? cyclogramNow() : organs.declared;
  cycle.organs = report.cyclogram.organs;
  const told = cycle.organs.map(({ name, why, stands }) => (why ? `${name}: ${why}.` : stands ? `${name} is as in the report: ${stands}.` : ""));
  byId("cyclogram").lastChild.textContent = told.filter((text) => text !== "").join(" ");
  drawCyclogram();
  remakeMoments();
}
