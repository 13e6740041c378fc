// Wishes against each other: each design a point, those that no other beats joined by a line.

const SIDE = 280;

function frontPlot(first, second) {
  const [x, y] = [first, second].map(({ figure, most }) => {
    const { name, unit, values } = data.figures[figure];
    return { name, unit, most, values: values.map((value) => plotValue(value, unit)) };
  });
  const heading = element("h3", {}, wish(y, plotUnit(y.unit)));
  const svg = shape("svg", { role: "group", height: SIDE });
  const box = element("div", { class: "plot" }, heading, svg);
  const best = data.front.best;
  const draw = () => {
    const width = Math.max(260, box.clientWidth);
    set(svg, { viewBox: `0 0 ${width} ${SIDE}`, "aria-label": `${y.name} against ${x.name}` });
    const [xUnit, yUnit] = [x, y].map(({ unit }) => plotUnit(unit));
    const drawing = axes(width, SIDE, [wish(x, xUnit), xUnit, ends(x.values)], [yUnit, ends(y.values)]);
    const whole = [...data.designs.keys()].filter((index) => x.values[index] !== null && y.values[index] !== null);
    const at = (index) => [drawing.toX(x.values[index]), drawing.toY(y.values[index])];
    // The best of three wishes are a surface, and no line.
    const along = whole.filter((index) => best[index]).sort((a, b) => x.values[a] - x.values[b]);
    const way = data.front.aims.length === 2 ? [shape("path", { class: "best", d: lineThrough(along.map(at)) })] : [];
    const points = whole.map((index) => point(index, at(index), `${x.name} ${short(x.values[index])} ${xUnit}, ${y.name} ${short(y.values[index])} ${yUnit}`, width));
    svg.replaceChildren(...drawing.parts, ...way, ...points);
  };
  return { box, draw };
}

function wish({ name, most }, unit) {
  return `${labelled(name, unit)}: the ${most ? "more" : "less"} the better`;
}

// Full if it is shown, with its name; the best are larger.
function point(index, [cx, cy], values, width) {
  const { name } = data.designs[index];
  const isShown = state.shown.has(index);
  const isBest = data.front.best[index];
  const circle = shape("circle", { cx: pixel(cx), cy: pixel(cy), r: isBest ? 6 : 4, stroke: hue(index), fill: isShown ? hue(index) : "var(--paper)" });
  // Larger than it looks: for fingers.
  const reach = shape("circle", { class: "reach", cx: pixel(cx), cy: pixel(cy), r: 13 });
  const isLeft = cx > width / 2;
  const label = isShown ? [shape("text", { x: pixel(cx + (isLeft ? -10 : 10)), y: pixel(cy - 8), "text-anchor": isLeft ? "end" : "start" }, name)] : [];
  const title = shape("title", {}, `${name}: ${values}${isBest ? "; no other is better in all" : ""}`);
  const group = shape("g", { class: "design", "data-design": index, tabindex: "0", role: "button", "aria-pressed": String(isShown), "aria-label": `${name}: ${values}` }, title, circle, ...label, reach);
  const press = () => {
    toggle(index);
    // Points are made anew; who uses keys goes on from the same one.
    document.querySelector(`#fronts .design[data-design="${index}"]`)?.focus({ preventScroll: true });
  };
  group.addEventListener("click", press);
  group.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    press();
  });
  return group;
}

function startFront() {
  if (data.front === null) return;
  const { aims, best } = data.front;
  byId("front").hidden = false;
  const count = best.filter(Boolean).length;
  write(byId("front-hint"), `${count} of ${best.length} designs are best: no other is as good in all wishes and better in one. A click on a point shows or hides its design.`);
  const pairs = aims.length === 2 ? [[0, 1]] : [[0, 1], [0, 2], [1, 2]];
  const plots = pairs.map(([a, b]) => frontPlot(aims[a], aims[b]));
  byId("fronts").replaceChildren(...plots.map((own) => own.box));
  const all = () => {
    for (const own of plots) own.draw();
  };
  let before = "";
  watchers.push(() => {
    const now = shown().join();
    if (now !== before) all();
    before = now;
  });
  addEventListener("resize", all);
}
