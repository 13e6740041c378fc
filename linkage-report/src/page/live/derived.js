// Data derived from the tables: true velocities and accelerations, bands, the table of accuracy,
// gaps.

function columnOf(table, fits) {
  return report.tables.find((own) => own.function === table)?.columns.find(fits);
}

function isRateOf(order, of) {
  return (column) => column.meaning === "rate" && column.order === order && column.of === of;
}

// d/dt of a quantity that depends on an input with speed omega and acceleration epsilon: v omega, a omega^2 + v epsilon.
function fillRates() {
  for (const rate of report.true ?? []) {
    const { omega, epsilon } = report.speed;
    const column = columnOf(rate.table, ({ name, meaning, order }) => name === rate.name && meaning === "rate" && order === rate.order);
    const velocity = rate.order === 2 && epsilon !== 0 ? velocityOf(rate) : null;
    column.values.forEach((value, row) => {
      const first = velocity === null ? 0 : velocity.values[row];
      const there = value !== null && first !== null;
      rate.values[row] = !there ? null : rate.order === 1 ? value * omega : value * omega * omega + first * epsilon;
    });
  }
}

function velocityOf({ table, of }) {
  const tables = [table, ...report.tables.map((own) => own.function)];
  return tables.map((own) => columnOf(own, isRateOf(1, of))).find((column) => column !== undefined);
}

// Sensitivities of a quantity of a table, with the tolerances that they are multiplied with.
const effects = new Map();

function effectsOn(table, quantity) {
  const key = `${table}|${quantity}`;
  if (!effects.has(key)) {
    const { columns: all } = report.tables.find((own) => own.function === table);
    const own = all.filter((column) => column.meaning === "sensitivity" && quantityOf(column) === quantity);
    effects.set(key, own.map((column) => {
      const { tolerance } = report.dimensions.find(({ name }) => name === column.parameter);
      return { parameter: column.parameter, tolerance, numbers: column.values };
    }));
  }
  return effects.get(key);
}

// The quantity of a sensitivity, otherwise its own name without the dimension.
function quantityOf(column) {
  return column.of ?? column.name.replace(/\[[^\]]*\]([^[]*)$/, "$1");
}

// The sum of the effects of a row; NaN where one is missing.
const SUMS = {
  "worst case": (own, row) => own.reduce((sum, effect) => sum + Math.abs(effectAt(effect, row)), 0),
  statistical: (own, row) => Math.sqrt(own.reduce((sum, effect) => sum + effectAt(effect, row) ** 2, 0)),
};

function effectAt({ tolerance, numbers }, row) {
  return numbers[row] === null ? NaN : numbers[row] * tolerance;
}

function fillBands() {
  for (const band of report.bands ?? []) {
    const own = effectsOn(band.table, band.column);
    for (let row = 0; row < rowCount; row += 1) {
      const half = SUMS[band.kind](own, row);
      band.half[row] = Number.isFinite(half) ? half : null;
    }
  }
}

// The row with the largest error of a quantity.
function accuracyNow(before) {
  const has = ({ columns: all }) => all.some((column) => column.meaning === "sensitivity" && quantityOf(column) === before.quantity);
  const own = effectsOn(report.tables.find(has).function, before.quantity);
  let [best, worst] = [null, -Infinity];
  for (let row = 0; row < rowCount; row += 1) {
    const sum = SUMS["worst case"](own, row);
    if (sum > worst) [best, worst] = [row, sum];
  }
  if (best === null) return { ...before, at: null, worst: null, statistical: null, contributions: [] };
  const sizes = own.map((effect) => ({ parameter: effect.parameter, amount: Math.abs(effectAt(effect, best)) }));
  return {
    ...before,
    at: input.values[best],
    worst,
    statistical: SUMS.statistical(own, best),
    contributions: sizes.filter(({ amount }) => amount > 0).sort((a, b) => b.amount - a.amount),
  };
}

// Ranges of positions in which some number does not exist, both ends included.
function gapsNow() {
  const all = report.tables.flatMap(({ columns: own }) => own.map(({ values: numbers }) => numbers));
  const gaps = [];
  let open = false;
  for (let row = 0; row < rowCount; row += 1) {
    const missing = all.some((numbers) => numbers[row] === null);
    const at = input.values[row];
    if (missing && open) gaps.at(-1).to = at;
    else if (missing) gaps.push({ from: at, to: at });
    open = missing;
  }
  return gaps;
}
