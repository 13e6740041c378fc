// Axes of a panel: grid, numbers, frame and titles. While dimensions change, unchanged nodes are
// left alone.

function makeAxes(panel) {
  const [across, up, frame] = ["across", "up", "around"].map(() => shape("g"));
  panel.axes = { across, up, frame, scale: null };
  return shape("g", { class: "axes" }, across, up, frame);
}

function placeAxes(panel) {
  const { axes, scales } = panel;
  const scale = [scales.first, scales.last, scales.left, scales.wide].join();
  if (scale !== axes.scale) {
    axes.across.replaceChildren(...acrossTicks(scales));
    axes.frame.replaceChildren(...frameParts(panel));
    axes.up.replaceChildren();
    axes.scale = scale;
  }
  placeUpTicks(panel);
}

function acrossTicks({ first, last, wide, tall, x }) {
  const bottom = PANEL.top + tall;
  return ticks(first, last, wide / 56, abscissaUnit()).flatMap((tick) => {
    const place = pixel(x(tick));
    return [shape("path", { class: "grid", d: `M${place} ${PANEL.top}V${bottom}` }),
      shape("text", { x: place, y: bottom + 15, "text-anchor": "middle" }, digits(tick))];
  });
}

// Each has a line and a number behind it.
function placeUpTicks({ axes: { up }, scales, unit }) {
  const all = ticks(scales.low, scales.high, 5, unit);
  while (up.childNodes.length > 2 * all.length) up.lastChild.remove();
  while (up.childNodes.length < 2 * all.length) {
    up.append(shape("path"), shape("text", { x: scales.left - 7, "text-anchor": "end" }));
  }
  all.forEach((tick, k) => {
    const y = pixel(scales.y(tick));
    set(up.childNodes[2 * k], { class: tick === 0 ? "zero" : "grid", d: `M${scales.left} ${y}h${scales.wide}` });
    write(set(up.childNodes[2 * k + 1], { y: y + 4 }), digits(tick));
  });
}

function frameParts(panel) {
  const { left, wide, tall } = panel.scales;
  return [
    shape("rect", { class: "frame", x: left, y: PANEL.top, width: wide, height: tall }),
    shape("text", { class: "title", x: left + wide / 2, y: PANEL.height - 5, "text-anchor": "middle" }, abscissaTitle()),
    shape("text", { class: "title", transform: `translate(13 ${PANEL.top + tall / 2}) rotate(-90)`, "text-anchor": "middle" }, panelTitle(panel)),
  ];
}

function titled(name, unit) {
  return unit ? `${name} [${unit}]` : name;
}

// The name of a single curve; several have theirs in the legend.
function panelTitle({ curves, unit }) {
  const name = curves.length === 1 ? curves[0].column.name : "";
  return name ? titled(name, unit) : unit ? `[${unit}]` : "[1]";
}
