// Figures of the cycle with other dimensions, as far as a table has their quantities: extremes between rows are looked for with the programs.

const ORDERS = { velocity: 1, acceleration: 2 };
// Steps of golden sections from two rows apart: the place is as good as roundoff lets a flat extreme be known.
const SECTIONS = 48;
const GOLDEN = (3 - Math.sqrt(5)) / 2;

// A number of a table as a function of the input; null if none computes it. Order 0 is the quantity, others are its derivatives.
function quantityNow(quantity, order) {
  const [point, component] = [quantity.slice(0, quantity.lastIndexOf(".")), quantity.slice(quantity.lastIndexOf("."))];
  const fits = order === 0
    ? ({ name, meaning }) => (name === quantity && meaning !== "rate") || (meaning === "picture" && name.endsWith(`[${point}]${component}`))
    : isRateOf(order, quantity);
  for (const own of live.tables.filter(({ why }) => why === null)) {
    const index = own.table.columns.findIndex(fits);
    if (index < 0) continue;
    return numberNow(own, index);
  }
  return null;
}

// A column of a table that is computed here, as its numbers at the rows and as a function of the input.
function numberNow({ table, number, fn, names }, index) {
  const out = new Float64Array(fn.columns.length);
  const at = argumentsOf(names);
  return { numbers: table.columns[index].values, at(x) { engine.evaluate(live.assemblies[number], fn, at(x), out); return out[index]; } };
}

// The place and value where `sign * fold(quantity)` is largest; null where there is no number.
function extremeOf(own, sign, fold) {
  const height = (value) => (value === null ? NaN : sign * fold(value));
  let [best, most] = [null, -Infinity];
  own.numbers.forEach((value, row) => {
    if (height(value) > most) [best, most] = [row, height(value)];
  });
  if (best === null) return null;
  let at = input.values[best];
  const [low, high] = [input.values[Math.max(0, best - 1)], input.values[Math.min(rowCount - 1, best + 1)]];
  goldenSections(low, high, (a, b) => {
    const [left, right] = [height(own.at(a)), height(own.at(b))];
    for (const [x, value] of [[a, left], [b, right]]) if (value > most) [at, most] = [x, value];
    return left > right || Number.isNaN(right);
  });
  return { at, value: sign * most };
}

// The interval that golden sections end at; `isLeft` decides which of two places is nearer to the extreme.
function goldenSections(low, high, isLeft) {
  for (let k = 0; k < SECTIONS; k += 1) {
    const [a, b] = [low + GOLDEN * (high - low), high - GOLDEN * (high - low)];
    if (isLeft(a, b)) high = b;
    else low = a;
  }
  return [low, high];
}

// Extremes with the present dimensions: strokes and true velocities need those that other rows have, too.
const extremesNow = new Map();

function extreme(quantity, order, sign, fold = same) {
  const key = [quantity, order, sign, fold.name].join("|");
  if (!extremesNow.has(key)) {
    const own = quantityNow(quantity, order);
    extremesNow.set(key, own === null ? undefined : extremeOf(own, sign, fold));
  }
  return extremesNow.get(key);
}

// The acute angle between two lines.
function acute(angle) {
  const turned = Math.abs(angle) % Math.PI;
  return Math.min(turned, Math.PI - turned);
}

const same = (value) => value;

// A row of the summary as it is now; one that nothing computes keeps its value, and says so.
function figureNow(row) {
  const found = figureOf(row);
  if (found === undefined) return { ...row, stands: true };
  return { ...row, ...(found ?? { value: null, at: null }) };
}

function figureOf({ quantity, what }) {
  if (what === "smallest transmission angle") return extreme(quantity, 0, -1, acute);
  if (what === "greatest transmission angle") return extreme(quantity, 0, 1, acute);
  if (what === "smallest" || what === "lowest") return extreme(quantity, 0, -1);
  if (what === "highest") return extreme(quantity, 0, 1);
  if (what === "stroke") return strokeOf(quantity);
  if (what === "rises in" || what === "falls in" || what === "time ratio") return timeFigure(quantity, what);
  if (what.startsWith("dwell, ")) return dwellFigure(quantity, what);
  const [, real, end, word] = /^(true )?(least|greatest) (velocity|acceleration)$/.exec(what) ?? [];
  if (word === undefined) return undefined;
  const order = ORDERS[word];
  const factor = real ? report.speed.omega ** order : 1;
  const found = extreme(quantity, order, (end === "greatest" ? 1 : -1) * Math.sign(factor));
  return found ? { ...found, value: factor * found.value } : found;
}

function strokeOf(quantity) {
  const [low, high] = [-1, 1].map((sign) => extreme(quantity, 0, sign));
  return low ? { value: high.value - low.value } : low;
}

function remakeSummary() {
  const sheet = byId("summary");
  if (sheet === null) return;
  extremesNow.clear();
  coursesNow.clear();
  const rows = isChanged() ? live.summary.map(figureNow) : live.summary;
  sheet.replaceChildren(sheet.firstChild, summaryTable(rows));
}
