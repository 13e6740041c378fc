// Plots of a motion with abscissas of their own: phase portraits and energies. The position is a mark in them, and a press or drag goes to it.

const CHART = { height: 250, top: 10, right: 14, bottom: 38 };

// Angles on abscissas are shown within one turn if `folds`.
const charts = { all: [], width: 0, folds: false };

// A curve over two columns of the report.
function chartCurve(name, x, y) {
  return { name, x, y, colour: `var(--curve-${y.colour})`, dash: DASHES[y.dash] };
}

function makeChart(id, title, names, curves) {
  const [{ x, y }] = curves;
  const units = { x: plotUnit(x.unit), y: plotUnit(y.unit) };
  const view = shape("svg", { class: "plot", role: "img", tabindex: 0, "aria-label": title });
  const chart = { id, curves, units, names, view, axes: shape("g", { class: "axes" }), lines: [], marks: [], values: [] };
  const body = element("tbody");
  for (const curve of curves) {
    chart.lines.push(shape("path", { class: "curve", stroke: curve.colour, "stroke-dasharray": curve.dash }));
    chart.marks.push(shape("circle", { r: 4, fill: curve.colour }));
    const value = element("td", { class: "value" });
    chart.values.push(value);
    const line = shape("path", { d: "M1 6H25", stroke: curve.colour, "stroke-dasharray": curve.dash });
    body.append(element("tr", {}, element("td", {}, shape("svg", { class: "swatch", width: 26, height: 12, "aria-hidden": "true" }, line)), element("th", { scope: "row" }, curve.name), value));
  }
  view.append(chart.axes, shape("g", { class: "curves" }, ...chart.lines), shape("g", { class: "cursor" }, ...chart.marks));
  listenToChart(chart);
  chart.figure = element("figure", { class: "panel", "data-chart": id }, element("figcaption", {}, title), view, element("table", { class: "legend" }, body));
  charts.all.push(chart);
  return chart.figure;
}

function chartNumbers(column) {
  return column.values.map((value) => plotValue(value, column.unit));
}

// The ends of an axis: all numbers, with some air.
function limitsOfLists(lists) {
  const known = lists.flat().filter((value) => value !== null);
  return withMargin(known.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]));
}

// The numbers of an abscissa, an angle within one turn.
function acrossNumbers(column) {
  const numbers = chartNumbers(column);
  return isFolded(column) ? numbers.map((value) => value - TURN_DEGREES * Math.floor(value / TURN_DEGREES)) : numbers;
}

function isFolded({ unit }) {
  return charts.folds && unit === "rad";
}

const TURN_DEGREES = 360;

// Where an angle within one turn begins again, its line does, too.
function withBreaks(places, column) {
  if (!isFolded(column)) return places;
  const turns = chartNumbers(column).map((value) => Math.floor(value / TURN_DEGREES));
  return places.flatMap((place, row) => (row > 0 && turns[row] !== turns[row - 1] ? [null, place] : [place]));
}

// The time has no air, as in the plots above, nor has a turn.
function limitsAcross(chart, lists) {
  if (isFolded(chart.curves[0].x)) return [0, TURN_DEGREES];
  const [first, last] = [input.values[0], input.values.at(-1)];
  return chart.names.x === input.name && last > first ? [first, last] : limitsOfLists(lists);
}

// Curves and axes for the numbers as they are.
function drawChart(chart, width) {
  const numbers = chart.curves.map(({ x, y }) => ({ xs: acrossNumbers(x), ys: chartNumbers(y) }));
  const [first, last] = limitsAcross(chart, numbers.map(({ xs }) => xs));
  const [low, high] = limitsOfLists(numbers.map(({ ys }) => ys));
  const upTicks = ticks(low, high, 5, chart.units.y);
  const left = 30 + PANEL.letter * Math.max(4, ...upTicks.map((tick) => digits(tick).length));
  const [wide, tall] = [Math.max(20, width - left - CHART.right), CHART.height - CHART.top - CHART.bottom];
  const x = (value) => left + (wide * (value - first)) / (last - first);
  const y = (value) => CHART.top + tall * (1 - (value - low) / (high - low));
  chart.places = numbers.map(({ xs, ys }) => xs.map((value, row) => (value === null || ys[row] === null ? null : [x(value), y(ys[row])])));
  set(chart.view, { width, height: CHART.height, viewBox: `0 0 ${width} ${CHART.height}` });
  const bottom = CHART.top + tall;
  const across = ticks(first, last, wide / 56, chart.units.x).flatMap((tick) => {
    const place = pixel(x(tick));
    return [shape("path", { class: tick === 0 ? "zero" : "grid", d: `M${place} ${CHART.top}V${bottom}` }), shape("text", { x: place, y: bottom + 15, "text-anchor": "middle" }, digits(tick))];
  });
  const up = upTicks.flatMap((tick) => {
    const place = pixel(y(tick));
    return [shape("path", { class: tick === 0 ? "zero" : "grid", d: `M${left} ${place}h${wide}` }), shape("text", { x: left - 7, y: place + 4, "text-anchor": "end" }, digits(tick))];
  });
  chart.axes.replaceChildren(...across, ...up,
    shape("rect", { class: "frame", x: left, y: CHART.top, width: wide, height: tall }),
    shape("text", { class: "title", x: left + wide / 2, y: CHART.height - 5, "text-anchor": "middle" }, titled(chart.names.x, chart.units.x)),
    shape("text", { class: "title", transform: `translate(13 ${CHART.top + tall / 2}) rotate(-90)`, "text-anchor": "middle" }, titled(chart.names.y, chart.units.y)));
  chart.lines.forEach((line, k) => set(line, { d: lineThrough(withBreaks(chart.places[k], chart.curves[k].x)) }));
}

function drawCharts() {
  if (!(charts.width > 0)) return;
  for (const chart of charts.all) drawChart(chart, charts.width);
  markCharts(position.row);
}

function markCharts(row) {
  for (const { places, marks, values: cells, curves } of charts.all) {
    if (places === undefined) continue;
    marks.forEach((mark, k) => {
      const place = places[k][row];
      set(mark, place === null ? { display: "none" } : { display: null, cx: pixel(place[0]), cy: pixel(place[1]) });
      write(cells[k], withUnit(curves[k].y.values[row], curves[k].y.unit));
    });
  }
}

// The row whose place on a curve is nearest.
function rowOnChart({ places }, place) {
  let nearest = { row: position.row, apart: Infinity };
  for (const list of places) {
    list.forEach((own, row) => {
      const apart = own === null ? Infinity : distance(own, place);
      if (apart < nearest.apart) nearest = { row, apart };
    });
  }
  return nearest.row;
}

function listenToChart(chart) {
  const go = (event) => {
    setPlaying(false);
    moveTo(rowOnChart(chart, placeIn(chart.view, event)));
  };
  chart.view.addEventListener("pointerdown", (event) => event.button === 0 && event.pointerType === "mouse" && go(event));
  chart.view.addEventListener("pointermove", (event) => event.pointerType === "mouse" && event.buttons & 1 && go(event));
  chart.view.addEventListener("click", go);
}
