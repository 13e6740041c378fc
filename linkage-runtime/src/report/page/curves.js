// What a panel shows: curves of one unit with their colours, bands and limits.

// As static plots have them.
const DASHES = [null, "7 4", "2 3", "9 3 2 3"];

// Tolerances are small beside motions: bands may be drawn wider than they are.
const WIDENINGS = [1, 10, 100, 1000, 10000];
const widening = { factor: 1 };

// Panels by unit in the order of the columns, or one for each column.
function chosenPanels(apart) {
  const panels = new Map();
  for (const column of columns.filter((column) => chosen.has(column.key))) {
    const unit = plotUnit(column.unit);
    const name = apart ? column.key : unit;
    if (!panels.has(name)) panels.set(name, { name, unit, curves: [] });
    const { curves } = panels.get(name);
    curves.push(curveOf(column));
  }
  return [...panels.values()];
}

function curveOf(column) {
  return {
    column,
    colour: `var(--curve-${column.colour})`,
    dash: DASHES[column.dash],
    ys: column.values.map((value) => plotValue(value, column.unit)),
  };
}

// Whether curves of one unit lie so far from each other that on one axis each would look like a straight line.
function areFarApart() {
  const height = (curves) => {
    const [low, high] = spread(curves, () => true);
    return Math.max(0, high - low);
  };
  return chosenPanels(false).some(({ curves }) => {
    const largest = Math.max(...curves.map((curve) => height([curve])));
    return curves.length > 1 && largest > 0 && height(curves) > 4 * largest;
  });
}

// Half the width of a band as it is drawn.
function halfWidth(band, row, unit) {
  const half = band.half[row];
  return half === null ? 0 : widening.factor * plotValue(half, unit);
}

// Beside positions that cannot be assembled, derivatives grow beyond all bounds: the axis ends where the rest of the
// curves does, and the panel says so. No other peak is ever cut.
const FAR_BEYOND = 3;

function setLimits(panel) {
  const seen = seenRows();
  const all = spread(panel.curves, seen);
  const beside = rowsBesideGaps();
  const rest = spread(panel.curves, (row) => seen(row) && !beside[row]);
  const cut = isMoreThanRoundoff(rest) && all[1] - all[0] > FAR_BEYOND * (rest[1] - rest[0]);
  panel.cut = cut ? all : null;
  panel.limits = zoom.y.get(panel.name) ?? withMargin(cut ? rest : all, extremes.shown ? ROOM : AIR);
}

// Rows so near to a gap that a dead point rules there.
function rowsBesideGaps() {
  const near = Math.max(2, Math.round(rowCount / 40));
  const beside = Array(rowCount).fill(false);
  for (const { from, to } of report.gaps ?? []) {
    beside.fill(true, Math.max(0, nearestRow(from) - near), nearestRow(to) + near + 1);
  }
  return beside;
}

function cutText({ cut, unit }) {
  const ends = cut.map((value) => digits(rounded(value, 6))).join(" to ");
  return `Beside the gaps the curves go on beyond the axis: ${ends}${unit ? " " + unit : ""}.`;
}

// Lowest and highest value with its band, over the rows that count.
function spread(curves, counts) {
  let low = Infinity;
  let high = -Infinity;
  for (const { column, ys } of curves) {
    ys.forEach((y, row) => {
      if (y === null || !counts(row)) return;
      const half = Math.max(0, ...column.bands.map((band) => halfWidth(band, row, column.unit)));
      low = Math.min(low, y - half);
      high = Math.max(high, y + half);
    });
  }
  return [low, high];
}

// Shares of an axis beyond what it shows: just air, and room for the labels of extremes.
const AIR = 0.04;
const ROOM = 0.15;

function withMargin([low, high], share = AIR) {
  if (!(high >= low)) return [0, 1];
  const margin = isMoreThanRoundoff([low, high]) ? share * (high - low) : 0.05 * largestOf([low, high]) || 1;
  return [low - margin, high + margin];
}

// Whether limits differ in earnest: a constant with roundoff, as on a straight guide, is a straight line and no noise.
function isMoreThanRoundoff([low, high]) {
  return high - low > 1e-12 * largestOf([low, high]);
}

function largestOf([low, high]) {
  return Math.max(Math.abs(low), Math.abs(high));
}

// `d` of the area between both sides of a band, a piece for every stretch without gap.
function bandOutline(curve, band, toScreen) {
  let d = "";
  let stretch = [];
  const close = () => {
    const side = (sign) => stretch.map((row) => toScreen(row, curve.ys[row] + sign * halfWidth(band, row, curve.column.unit)));
    if (stretch.length > 1) d += lineThrough([...side(1), ...side(-1).reverse()]) + "Z";
    stretch = [];
  };
  curve.ys.forEach((y, row) => {
    if (y === null || band.half[row] === null) close();
    else stretch.push(row);
  });
  close();
  return d;
}

// `d` of the curve; a single value between gaps is a dot.
function curveOutline({ ys }, toScreen) {
  const places = ys.map((y, row) => (y === null ? null : toScreen(row, y)));
  const lonely = places.filter((place, row) => place && !places[row - 1] && !places[row + 1]);
  return lineThrough(places) + lonely.map(([x, y]) => `M${pixel(x)} ${pixel(y)}h0.01`).join("");
}
