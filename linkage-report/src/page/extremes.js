// The highest and the lowest place of each curve, with their values.

const extremes = { shown: true };

// A character of the labels, in pixels, rather too wide, and a line of them; steps away from the point, how far away a label is put, and up to where it needs no line.
const LABEL = { letter: 6.4, line: 13, step: 6, farthest: 40, beside: 10 };

function extremesChoice() {
  const box = element("input", { id: "extremes", type: "checkbox", checked: extremes.shown });
  box.addEventListener("change", () => {
    extremes.shown = box.checked;
    makePanels();
  });
  return element("label", { class: "aside" }, box, " Extremes");
}

// Rows of the lowest and the highest value among the visible ones; none for a constant.
function extremeRows({ ys }, xs) {
  const seen = seenRows();
  const rows = [null, null];
  ys.forEach((y, row) => {
    if (y === null || xs[row] === null || !seen(row)) return;
    if (rows[0] === null || y < ys[rows[0]]) rows[0] = row;
    if (rows[1] === null || y > ys[rows[1]]) rows[1] = row;
  });
  return rows[0] !== null && isMoreThanRoundoff(rows.map((row) => ys[row])) ? rows : [];
}

// Each curve has two marks, which are made when they are first shown. `across` are the places of the rows.
function markExtremes(panel, across) {
  const { scales } = panel;
  const found = [];
  for (const curve of extremes.shown ? panel.curves : []) {
    curve.marks ??= [makeMark(curve, "lowest"), makeMark(curve, "highest")];
    extremeRows(curve, scales.xs).forEach((row, which) => {
      const y = curve.ys[row];
      // Beyond the axis beside gaps, or outside of a rectangle.
      if (y >= scales.low && y <= scales.high) found.push({ mark: curve.marks[which], curve, row, which, place: [across[row], scales.y(y)] });
    });
  }
  // No label hides a circle.
  const labels = found.map(({ place: [x, y] }) => [x - CIRCLE, y - CIRCLE, x + CIRCLE, y + CIRCLE]);
  const lines = found.length === 0 ? [] : [...panel.curves, ...(isAgainstInput() ? keptCurves(panel) : [])].map((curve) => heightsOf(curve, across, scales));
  // The outermost have the least room.
  const room = ({ which, place: [, y] }) => (which === 0 ? scales.tall - y : y);
  for (const own of [...found].sort((a, b) => room(a) - room(b))) placeMark(own, panel, labels, lines);
  hold(panel.extremes, found.map(({ mark }) => mark.node));
}

// Half of what a circle takes.
const CIRCLE = 3.5;

// The lowest and highest place that a curve has in each column of pixels, as pairs; NaN where there is none.
function heightsOf({ ys }, across, { left, wide, y }) {
  const size = Math.ceil(wide) + 1;
  const heights = new Float64Array(2 * size).fill(NaN);
  const meet = (column, height) => {
    if (!(column >= 0 && column < size)) return;
    if (!(heights[2 * column] <= height)) heights[2 * column] = height;
    if (!(heights[2 * column + 1] >= height)) heights[2 * column + 1] = height;
  };
  let before = null;
  ys.forEach((value, row) => {
    if (value === null || across[row] === null) {
      before = null;
      return;
    }
    const place = [across[row] - left, y(value)];
    const [from, to] = [before ?? place, place];
    before = place;
    // Of what is zoomed in to most is outside.
    if (Math.max(from[0], to[0]) < 0 || Math.min(from[0], to[0]) > size) return;
    // Every column between two rows, from both sides.
    const steps = Math.max(1, Math.ceil(Math.abs(to[0] - from[0])));
    for (let k = 0; k <= steps; k += 1) meet(Math.round(from[0] + ((to[0] - from[0]) * k) / steps), from[1] + ((to[1] - from[1]) * k) / steps);
  });
  return heights;
}

function makeMark({ column, colour }, what) {
  const [title, circle, label, leader] = [shape("title"), shape("circle", { r: 3, stroke: colour }), shape("text"), shape("path")];
  const node = shape("g", { "data-extreme": what, "data-of": column.key }, title, circle);
  return { node, title, circle, label, leader, what };
}

function placeMark({ mark: { node, title, circle, label, leader, what }, curve: { column, ys }, row, which, place: [x, y] }, { scales, unit }, labels, lines) {
  const value = digits(rounded(ys[row], 6));
  const at = inputShort(input.values[row]);
  const text = `${value} at ${at}`;
  set(node, { "data-row": row });
  write(title, `${what} ${column.name}: ${value}${unit ? " " + unit : ""} at ${input.name} = ${at}`);
  set(circle, { cx: pixel(x), cy: pixel(y) });
  const length = text.length * LABEL.letter;
  const place = labelPlace(scales, [x, y], length, which, labels, lines);
  if (!place) return hold(node, [title, circle]);
  write(set(label, { x: pixel(place[0]), y: pixel(place[1]) }), text);
  const line = leaderToLabel([x, y], place, length);
  if (line) set(leader, { d: lineThrough(line) });
  hold(node, line ? [title, leader, circle, label] : [title, circle, label]);
}

// A thin line to a label that is not beside its point; null for one that is.
function leaderToLabel([x, y], [left, foot], length) {
  const end = [Math.min(left + length, Math.max(left, x)), Math.min(foot, Math.max(foot - LABEL.line + 4, y))];
  return distance(end, [x, y]) > LABEL.beside ? [[x, y], end] : null;
}

// The place of a label within the frame, on no other one and on no curve, as near to its point as there is one; null if there is none.
function labelPlace({ left, wide, tall }, [x, y], length, which, labels, lines) {
  const [above, below] = [y - 6, y + LABEL.line + 2];
  const feet = which === 0 ? [below, above] : [above, below];
  for (let away = 0; away < LABEL.farthest; away += LABEL.step) {
    for (const foot of [feet[0] + (feet[0] > y ? away : -away), feet[1] + (feet[1] > y ? away : -away)]) {
      for (const start of [x - length / 2, x + CIRCLE + 2, x - length - CIRCLE - 2, x + LABEL.farthest, x - length - LABEL.farthest]) {
        const from = Math.min(left + wide - length - 2, Math.max(left + 2, start));
        const box = [from, foot - LABEL.line + 2, from + length, foot + 2];
        const within = box[1] >= PANEL.top && box[3] <= PANEL.top + tall;
        if (!within || labels.some((other) => boxesMeet(box, other)) || !lines.every((line) => isClear(box, line, left))) continue;
        labels.push(box);
        return [from, foot];
      }
    }
  }
  return null;
}

// Returns true if a curve does not come into a box.
function isClear([from, top, to, foot], heights, left) {
  const last = Math.min(heights.length / 2 - 1, Math.ceil(to - left));
  for (let column = Math.max(0, Math.floor(from - left)); column <= last; column += 1) {
    if (heights[2 * column] < foot && heights[2 * column + 1] > top) return false;
  }
  return true;
}
