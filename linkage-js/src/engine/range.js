// The check of the declared range of an assembly, with the criteria of the compiler.

const DEAD = CORE.DEAD;
const END = CORE.END;
const AT_RANGE_END = CORE.AT_END;
const SLACK_ROUNDING = CORE.ROUNDING;
const SAMPLES_OF_A_TURN = CORE.SAMPLES;
const MISSES = 180;
const GOLDEN = 0.618033988749895;

// The findings of an assembly: a kind, the group, where it begins and ends, by how much the group misses closing at worst. `unchecked`
// says why nothing is checked.
function rangeOf(own) {
  const { unit } = own;
  const declared = unit.inputs.flatMap(({ range }, k) => (range === null ? [] : [k]));
  const prepared = unit.groups.some(({ slack }) => slack === "prepared");
  if (declared.length > 1) return { input: null, range: null, findings: [], unchecked: "several inputs have a range" };
  const free = declared.length === 0 && unit.inputs.length === 1 && unit.inputs[0].angle && !prepared;
  if (unit.groups.length > 0 && declared.length === 0 && !free) {
    return { input: null, range: null, findings: [], unchecked: "no input has a range" };
  }
  if (unit.groups.length === 0) return { input: null, range: null, findings: [], unchecked: null };
  const input = free ? 0 : declared[0];
  const { name, reference, range, angle } = unit.inputs[input];
  const [low, high] = range ?? [reference - Math.PI, reference + Math.PI];
  const search = { own, input, low, high, reference, angle, x: Float64Array.from(unit.reference), scales: unit.groups.map(() => 1) };
  const places = samplesOf(search);
  measure(search, places);
  const found = unit.groups.flatMap((_, group) => stretchesOf(search, group, places).map((own) => findingOf(search, group, own)));
  const kept = free ? found.filter(({ kind, from }) => kind === "change point" && from !== high) : found;
  return { input: name, range: [low, high], findings: kept.sort((a, b) => a.from - b.from), unchecked: null };
}

// Positions of samples: the reference is one of them.
function samplesOf({ low, high, reference, angle }) {
  const count = angle ? Math.min(Math.max(SAMPLES_OF_A_TURN * (high - low) / TURN, CORE.LEAST_SAMPLES), CORE.MOST_SAMPLES) : SAMPLES_OF_A_TURN;
  const part = (from, to) => {
    const steps = to > from ? Math.max(Math.floor(Math.floor(count) * ((to - from) / (high - low))), 1) : 0;
    return Array.from({ length: steps }, (_, k) => from + (to - from) * (k / steps));
  };
  return [...part(low, reference), ...part(reference, high), high];
}

function isInside({ low, high }, x) {
  return Math.min(x - low, high - x) > END * (high - low);
}

function computedAt({ own, input, x }, at) {
  x[input] = at;
  const out = new Float64Array(own.unit.groups.length);
  own.unit.slacks(own, x, own.statesAt(x), out);
  return out;
}

// The slacks of all groups. That of a group without a closed form is 1, NaN where nothing is prepared of it.
function slacksAt(search, at) {
  const { own, low, high, scales } = search;
  let all = computedAt(search, at);
  if (all.some(Number.isNaN) && !isInside(search, at)) {
    // An arc function may reach the end of its range at that of the input's, apart from rounding.
    const step = END * (high - low);
    all = computedAt(search, Math.min(Math.max(at, low + step), high - step));
  }
  return own.unit.groups.map(({ slack }, k) => (slack === "prepared" ? 1 + 0 * all[k] : all[k] / scales[k]));
}

// What slacks are compared with: of some groups their largest value, with the sign that it has at the reference where there is one assembly.
function measure(search, places) {
  const { groups } = search.own.unit;
  const all = places.map((at) => slacksAt(search, at));
  const here = slacksAt(search, search.reference);
  search.scales = groups.map(({ slack }, k) => {
    if (slack === "number" || slack === "prepared") return 1;
    const largest = all.reduce((most, slacks) => (Math.abs(slacks[k]) > most ? Math.abs(slacks[k]) : most), 0);
    const scale = largest > 0 ? largest : 1;
    return slack === "signed" && here[k] < 0 ? -scale : scale;
  });
}

// How far a group is from its dead point; null where a group before it does not close.
function levelOf(search, group, at) {
  const slacks = slacksAt(search, at);
  if (!slacks.slice(0, group).every((slack) => slack >= -SLACK_ROUNDING)) return null;
  return slacks[group] - (isInside(search, at) ? DEAD : 0);
}

const isWorking = (level) => level !== null && level >= -SLACK_ROUNDING;
const isFailing = (level) => level !== null && !(level >= -SLACK_ROUNDING);

// Where it stops working between a place that works and one that does not.
function edgeBetween(level, works, broken) {
  for (let k = 0; k < 64; k += 1) {
    const middle = 0.5 * (works + broken);
    const own = level(middle);
    if (own !== null && own > 0) works = middle;
    else broken = middle;
  }
  return broken;
}

// The lowest place between two, by golden sections; one without a number is the lowest of all.
function lowestBetween(depth, low, high) {
  const point = (x) => ({ x, y: depth(x) });
  const lower = (a, b) => (Number.isNaN(a.y) || a.y <= b.y ? a : b);
  let left = point(high - GOLDEN * (high - low));
  let right = point(low + GOLDEN * (high - low));
  let best = lower(left, right);
  for (let k = 0; k < 70 && left.x < right.x && !Number.isNaN(best.y); k += 1) {
    if (left.y <= right.y) {
      high = right.x;
      right = left;
      left = point(high - GOLDEN * (high - low));
      best = lower(best, left);
    } else {
      low = left.x;
      left = right;
      right = point(low + GOLDEN * (high - low));
      best = lower(best, right);
    }
  }
  return best.x;
}

// Stretches that do not work: between samples, and at dips that no sample shows.
function stretchesOf(search, group, places) {
  const level = (at) => levelOf(search, group, at);
  const samples = places.map((at) => ({ at, level: level(at) }));
  const more = samples.flatMap((_, k) => between(samples, k, level));
  const all = [...samples, ...more].sort((a, b) => a.at - b.at);
  const found = [];
  let open = null;
  let before = null;
  for (const sample of all) {
    if (isFailing(sample.level)) {
      if (open === null) {
        const works = before !== null && isWorking(before.level);
        open = { from: works ? edgeBetween(level, before.at, sample.at) : sample.at, to: sample.at, works, finite: true };
      }
      open.to = sample.at;
      open.finite &&= !Number.isNaN(sample.level);
    } else if (open !== null) {
      const works = isWorking(sample.level);
      found.push({ ...open, to: works ? edgeBetween(level, sample.at, open.to) : open.to, works: open.works && works });
      open = null;
    }
    before = sample;
  }
  if (open !== null) found.push({ ...open, works: false });
  return found;
}

// The bottom of a dip or the top of a hill beside a sample, if it is of the other kind.
function between(samples, k, level) {
  const own = [samples[Math.max(k - 1, 0)], samples[k], samples[Math.min(k + 1, samples.length - 1)]];
  const fails = isFailing(own[1].level);
  const alike = own.every((sample) => (fails ? isFailing(sample.level) : isWorking(sample.level)));
  const sign = fails ? -1 : 1;
  const [fall, rise] = [own[0], own[2]].map((sample) => sign * (sample.level - own[1].level));
  if (!(alike && fall >= 0 && rise >= 0 && fall + rise > 0)) return [];
  const depth = (at) => {
    const here = level(at);
    return here === null || (fails && Number.isNaN(here)) ? Infinity : sign * here;
  };
  const at = lowestBetween(depth, own[0].at, own[2].at);
  const bottom = { at, level: level(at) };
  return (fails ? isWorking(bottom.level) : isFailing(bottom.level)) ? [bottom] : [];
}

// What a stretch is.
function findingOf(search, group, { from, to, works, finite }) {
  const { low, high } = search;
  const snapped = (x) => [low, high].find((end) => Math.abs(x - end) < AT_RANGE_END * (high - low)) ?? x;
  const slack = (at) => slacksAt(search, at)[group];
  const width = to - from;
  const lowest = lowestBetween(slack, Math.max(from - width, low), Math.min(to + width, high));
  // A slack that is negative by no more than rounding touches zero.
  const miss = Math.abs(slack(lowest)) < DEAD ? 0 : largestMiss(search, group, from, to);
  const single = search.own.unit.groups[group].slack === "signed";
  const open = works ? "gap" : "dead point";
  const closed = single ? "dead point" : "change point";
  const kind = !finite ? "undefined" : miss > 0 ? open : closed;
  const ends = [from, to];
  if (kind === "change point") ends.fill(lowest);
  else if (finite && !(miss > 0)) ends[1] = from;
  return { kind, group, from: snapped(ends[0]), to: snapped(ends[1]), miss };
}

// By how much a group misses closing at worst in a stretch.
function largestMiss({ own, input, x }, group, from, to) {
  const missAt = (at) => {
    x[input] = at;
    const miss = gapsAt(own, x)[group];
    return miss > 0 ? miss : 0;
  };
  const step = (to - from) / MISSES;
  const all = Array.from({ length: MISSES + 1 }, (_, k) => missAt(from + step * k));
  const most = Math.max(...all);
  if (!(most > 0)) return 0;
  const at = from + step * all.indexOf(most);
  return Math.max(most, missAt(lowestBetween((x) => -missAt(x), Math.max(at - step, from), Math.min(at + step, to))));
}
