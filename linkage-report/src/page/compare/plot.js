// Curves over curves.

const HEIGHT = 190;
const ROOM = { left: 58, right: 12, top: 6, bottom: 34 };
// Margins as a part of the height or width, so that points at the edge are seen whole.
const AIR = 0.05;

function ends(values) {
  const finite = values.filter((value) => value !== null);
  if (finite.length === 0) return [0, 1];
  const [low, high] = [Math.min(...finite), Math.max(...finite)];
  const air = high > low ? AIR * (high - low) : Math.abs(high) * AIR || 1;
  return [low - air, high + air];
}

// Axes for two quantities in a box of this width, each with its title, unit and ends: screen places
// of numbers, and the fixed nodes.
function axes(width, height, [xTitle, xUnit, xs], [yUnit, ys]) {
  const [w, h] = [Math.max(1, width - ROOM.left - ROOM.right), height - ROOM.top - ROOM.bottom];
  const toX = (x) => ROOM.left + (w * (x - xs[0])) / (xs[1] - xs[0]);
  const toY = (y) => ROOM.top + (h * (ys[1] - y)) / (ys[1] - ys[0]);
  const parts = [];
  for (const x of ticks(xs[0], xs[1], Math.max(2, w / 80), xUnit)) {
    parts.push(shape("path", { class: "grid", d: `M${pixel(toX(x))} ${ROOM.top}v${h}` }));
    parts.push(shape("text", { x: pixel(toX(x)), y: ROOM.top + h + 14, "text-anchor": "middle" }, short(x)));
  }
  for (const y of ticks(ys[0], ys[1], Math.max(2, h / 32), yUnit)) {
    parts.push(shape("path", { class: "grid", d: `M${ROOM.left} ${pixel(toY(y))}h${w}` }));
    parts.push(shape("text", { x: ROOM.left - 6, y: pixel(toY(y)) + 4, "text-anchor": "end" }, short(y)));
  }
  parts.push(shape("rect", { class: "frame", x: ROOM.left, y: ROOM.top, width: w, height: h }));
  parts.push(shape("text", { x: ROOM.left + w, y: height - 4, "text-anchor": "end" }, xTitle));
  return { toX, toY, parts, fromX: (px) => xs[0] + ((px - ROOM.left) * (xs[1] - xs[0])) / w, w, h };
}

function labelled(name, unit) {
  return unit ? `${name} [${unit}]` : name;
}

function nearestRow(input) {
  const values = data.input.values;
  let best = 0;
  for (const [row, value] of values.entries()) {
    if (Math.abs(value - input) < Math.abs(values[best] - input)) best = row;
  }
  return best;
}

function panel(number) {
  const curve = data.curves[number];
  const unit = plotUnit(curve.unit);
  const inputs = data.input.values.map((value) => plotValue(value, data.input.unit));
  const values = data.designs.map((design) => design.curves[number].map((value) => plotValue(value, curve.unit)));
  const inputUnit = plotUnit(data.input.unit);
  const heading = element("h3", {}, labelled(curve.name, unit));
  const svg = shape("svg", { role: "img", height: HEIGHT });
  const box = element("div", { class: "plot", "data-curve": curve.name }, heading, svg);
  const cursor = shape("path", { class: "cursor" });
  let drawing = null;
  const pick = (event) => {
    const left = svg.getBoundingClientRect().left;
    stand(nearestRow(fromPlot(drawing.fromX(event.clientX - left), data.input.unit)));
  };
  svg.addEventListener("pointerdown", pick);
  svg.addEventListener("pointermove", (event) => {
    if (event.buttons & 1) pick(event);
  });
  const draw = () => {
    const width = Math.max(240, box.clientWidth);
    set(svg, { viewBox: `0 0 ${width} ${HEIGHT}`, "aria-label": `${curve.name} of all designs that are shown` });
    const range = ends(shown().flatMap((index) => values[index]));
    drawing = axes(width, HEIGHT, [labelled(data.input.name, inputUnit), inputUnit, [inputs[0], inputs.at(-1)]], [unit, range]);
    const curves = shown().map((index) => {
      const at = values[index].map((value, row) => (value === null ? null : [drawing.toX(inputs[row]), drawing.toY(value)]));
      return shape("path", { class: "curve", "data-design": index, d: lineThrough(at), ...line(index) }, shape("title", {}, data.designs[index].name));
    });
    svg.replaceChildren(...drawing.parts, ...curves, cursor);
  };
  const move = () => set(cursor, { d: `M${pixel(drawing.toX(inputs[state.row]))} ${ROOM.top}v${drawing.h}` });
  return { box, draw, move };
}

function startPlots() {
  const panels = data.curves.map((_, number) => panel(number));
  byId("plots").hidden = panels.length === 0;
  byId("panels").replaceChildren(...panels.map((own) => own.box));
  let before = "";
  const all = () => {
    for (const own of panels) own.draw();
  };
  watchers.push(() => {
    const now = shown().join();
    if (now !== before) all();
    before = now;
    for (const own of panels) own.move();
  });
  addEventListener("resize", () => {
    all();
    for (const own of panels) own.move();
  });
}
