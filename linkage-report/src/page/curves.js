// Contents of a panel: curves of one unit with their colours, bands and limits.

// The same colours and dashes as in static plots.
const DASHES = [null, "7 4", "2 3", "9 3 2 3"];

// Tolerances are small beside motions: bands may be drawn wider than they are.
const WIDENINGS = [1, 10, 100, 1000, 10000];
const widening = { factor: 1 };

// Numbers of a design to compare with, by the keys of columns, and what it is; null without one.
const kept = { columns: null, words: "" };

// Panels by unit in the order of the columns, or one for each column.
function chosenPanels(apart) {
  const panels = new Map();
  for (const own of columns.filter((column) => chosen.has(column.key) && !isOfHiddenPart(column))) {
    const column = timedColumn(own);
    const unit = plotUnit(column.unit);
    const name = apart ? column.key : unit;
    if (!panels.has(name)) panels.set(name, { name, unit, curves: [] });
    const { curves } = panels.get(name);
    curves.push({ ...curveOf(column), kept: kept.columns === null ? null : keptCurve(own) });
  }
  return [...panels.values()];
}

function curveOf(column) {
  return {
    column,
    colour: `var(--curve-${column.colour})`,
    dash: DASHES[column.dash],
    ys: plotted(column),
  };
}

// The same column of the design that is kept.
function keptCurve(column) {
  const before = timedColumn({ ...column, values: kept.columns.get(column.key) });
  return { column: { ...before, bands: [] }, ys: plotted(before) };
}

function plotted({ values: numbers, unit }) {
  return numbers.map((value) => plotValue(value, unit));
}

// Returns true if curves of one unit are so far from each other that on one axis each would look
// like a straight line.
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
  const all = spread([...panel.curves, ...keptCurves(panel)], seen);
  const beside = rowsBesideGaps();
  const rest = beside === null ? all : spread(panel.curves, (row) => seen(row) && !beside[row]);
  const cut = isMoreThanRoundoff(rest) && all[1] - all[0] > FAR_BEYOND * (rest[1] - rest[0]);
  panel.cut = cut ? all : null;
  panel.limits = zoom.y.get(panel.name) ?? withMargin(cut ? rest : all, extremes.shown ? ROOM : AIR);
}

function keptCurves({ curves }) {
  return curves.flatMap((curve) => (curve.kept === null ? [] : [curve.kept]));
}

// Rows so near to a gap that a dead point rules there; null without gaps.
function rowsBesideGaps() {
  if ((report.gaps ?? []).length === 0) return null;
  const near = Math.max(2, Math.round(rowCount / 40));
  const beside = Array(rowCount).fill(false);
  for (const { from, to } of report.gaps) {
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
      let half = 0;
      for (const band of column.bands) half = Math.max(half, halfWidth(band, row, column.unit));
      low = Math.min(low, y - half);
      high = Math.max(high, y + half);
    });
  }
  return [low, high];
}

// Shares of an axis beyond its limits: air, and room for the labels of extremes.
const AIR = 0.04;
const ROOM = 0.15;

function withMargin([low, high], share = AIR) {
  if (!(high >= low)) return [0, 1];
  const margin = isMoreThanRoundoff([low, high]) ? share * (high - low) : 0.05 * largestOf([low, high]) || 1;
  return [low - margin, high + margin];
}

// Returns true if limits differ by more than roundoff: a constant with roundoff, as on a straight
// guide, is a straight line and no noise.
function isMoreThanRoundoff([low, high]) {
  return high - low > 1e-12 * largestOf([low, high]);
}

function largestOf([low, high]) {
  return Math.max(Math.abs(low), Math.abs(high));
}

// `d` of the area between both sides of a band, a piece for every stretch without gap. `across` are the places of the rows, as words.
function bandOutline({ ys, column }, band, across, scales) {
  let d = "";
  let [forth, back] = ["", ""];
  let rows = 0;
  const close = () => {
    if (rows > 1) d += `M${forth.slice(1)}${back}Z`;
    [forth, back, rows] = ["", "", 0];
  };
  ys.forEach((y, row) => {
    if (y === null || band.half[row] === null || across[row] === null) return close();
    const half = halfWidth(band, row, column.unit);
    forth += `L${across[row]} ${pixelText(scales.y(y + half))}`;
    back = `L${across[row]} ${pixelText(scales.y(y - half))}${back}`;
    rows += 1;
  });
  close();
  return d;
}

// `d` of the curve; a single value between gaps is a dot.
function curveOutline({ ys }, across, scales) {
  const isThere = (row) => ys[row] !== null && ys[row] !== undefined && across[row] !== null;
  let d = "";
  let pen = "M";
  ys.forEach((y, row) => {
    if (y === null || across[row] === null) {
      pen = "M";
      return;
    }
    d += pen + across[row] + " " + pixelText(scales.y(y));
    if (pen === "M" && !isThere(row + 1)) d += "h0.01";
    pen = "L";
  });
  return d;
}
