// The highest and the lowest place of each curve, with their values.

const extremes = { shown: true };

// A character of the labels, in pixels, rather too wide, and a line of them.
const LABEL = { letter: 6.4, line: 13 };

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

// Each curve has two marks, which are made when they are first shown.
function markExtremes(panel) {
  const shown = [];
  const labels = [];
  for (const curve of extremes.shown ? panel.curves : []) {
    curve.marks ??= [makeMark(curve, "lowest"), makeMark(curve, "highest")];
    extremeRows(curve, panel.scales.xs).forEach((row, which) => {
      const y = curve.ys[row];
      // Beyond the axis beside gaps, or outside of a rectangle.
      if (y < panel.scales.low || y > panel.scales.high) return;
      placeMark(curve.marks[which], panel, curve, row, which, labels);
      shown.push(curve.marks[which].node);
    });
  }
  hold(panel.extremes, shown);
}

function makeMark({ column, colour }, what) {
  const [title, circle, label] = [shape("title"), shape("circle", { r: 3, stroke: colour }), shape("text")];
  const node = shape("g", { "data-extreme": what, "data-of": column.key }, title, circle);
  return { node, title, circle, label, what };
}

function placeMark({ node, title, circle, label, what }, { scales, unit }, { column, ys }, row, which, labels) {
  const [x, y] = [scales.x(scales.xs[row]), scales.y(ys[row])];
  const value = digits(rounded(ys[row], 6));
  const at = inputShort(input.values[row]);
  const text = `${value} at ${at}`;
  set(node, { "data-row": row });
  write(title, `${what} ${column.name}: ${value}${unit ? " " + unit : ""} at ${input.name} = ${at}`);
  set(circle, { cx: pixel(x), cy: pixel(y) });
  const place = labelPlace(scales, [x, y], text.length * LABEL.letter, which, labels);
  if (place) write(set(label, { x: pixel(place[0]), y: pixel(place[1]) }), text);
  hold(node, place ? [title, circle, label] : [title, circle]);
}

// The place of a label inside of the frame and on no other one, above or below its point; null if
// there is none.
function labelPlace({ left, wide, tall }, [x, y], length, which, labels) {
  const from = Math.min(left + wide - length - 2, Math.max(left + 2, x - length / 2));
  const [above, below] = [y - 6, y + LABEL.line + 2];
  for (const foot of which === 0 ? [below, above] : [above, below]) {
    const box = [from, foot - LABEL.line + 2, from + length, foot + 2];
    const within = box[1] >= PANEL.top && box[3] <= PANEL.top + tall;
    const free = labels.every((other) => box[2] < other[0] || box[0] > other[2] || box[3] < other[1] || box[1] > other[3]);
    if (within && free) {
      labels.push(box);
      return [from, foot];
    }
  }
  return null;
}
