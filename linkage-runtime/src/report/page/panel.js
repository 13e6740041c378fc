// One panel: axes with units, curves, bands, gaps, and the cursor at the mechanism's position.

const PANEL = { height: 210, top: 10, right: 14, bottom: 38, letter: 7.2 };

// All panels begin at the same place, so that one abscissa lies below the other.
const panelLeft = { width: 60 };

function measureLabels(panels) {
  const labels = panels.flatMap((panel) => panelTicks(panel).map((tick) => digits(tick).length));
  const width = 30 + PANEL.letter * Math.max(4, ...labels);
  // What is under the pointer stays there while the parts change.
  panelLeft.width = zoom.x === null ? width : Math.max(width, panelLeft.width);
}

function panelTicks(panel) {
  setLimits(panel);
  return ticks(...panel.limits, 5, panel.unit);
}

// Functions between values and pixels.
function panelScales(panel, width) {
  const xs = abscissaValues();
  const [first, last] = zoom.x ?? wholeAbscissa();
  const [low, high] = panel.limits;
  const [left, wide] = [panelLeft.width, Math.max(20, width - panelLeft.width - PANEL.right)];
  const tall = PANEL.height - PANEL.top - PANEL.bottom;
  const x = (value) => left + (wide * (value - first)) / (last - first || 1);
  const y = (value) => PANEL.top + tall * (1 - (value - low) / (high - low));
  const value = (pixels) => first + ((pixels - left) / wide) * (last - first);
  const height = (pixels) => low + (1 - (pixels - PANEL.top) / tall) * (high - low);
  return { xs, first, last, low, high, left, wide, tall, x, y, value, height };
}

function drawPanel(panel, width) {
  const scales = panelScales(panel, width);
  panel.scales = scales;
  const toScreen = (row, y) => (scales.xs[row] === null ? null : [scales.x(scales.xs[row]), scales.y(y)]);
  const view = shape("svg", {
    class: "plot", width, height: PANEL.height, viewBox: `0 0 ${width} ${PANEL.height}`, role: "img", tabindex: 0,
    "aria-label": `${panel.curves.map((curve) => curve.column.name).join(", ")} against ${(abscissa.column ?? input).name}`,
  });
  const clip = `frame-${plots.panels.indexOf(panel)}`;
  const clipped = (...parts) => shape("g", { "clip-path": `url(#${clip})` }, ...parts);
  view.append(clipping(clip, scales), clipped(gapAreas(scales)), axes(panel, scales),
    clipped(bandAreas(panel, toScreen), curveLines(panel, toScreen)), extremeMarks(panel));
  panel.cursor = shape("g", { class: "cursor", "data-cursor": "position" });
  panel.pointer = shape("g", { class: "cursor pointer", "data-cursor": "pointer" });
  view.append(panel.pointer, panel.cursor);
  panel.view = view;
  return view;
}

// The frame and half a stroke around it.
function clipping(id, { left, wide, tall }) {
  return shape("clipPath", { id }, shape("rect", { x: left - 1, y: PANEL.top - 1, width: wide + 2, height: tall + 2 }));
}

function axes(panel, scales) {
  const group = shape("g", { class: "axes" });
  const bottom = PANEL.top + scales.tall;
  const unit = plotUnit((abscissa.column ?? input).unit);
  for (const tick of ticks(scales.first, scales.last, scales.wide / 56, unit)) {
    const x = pixel(scales.x(tick));
    group.append(shape("path", { class: "grid", d: `M${x} ${PANEL.top}V${bottom}` }),
      shape("text", { x, y: bottom + 15, "text-anchor": "middle" }, digits(tick)));
  }
  for (const tick of ticks(scales.low, scales.high, 5, panel.unit)) {
    const y = pixel(scales.y(tick));
    group.append(shape("path", { class: tick === 0 ? "zero" : "grid", d: `M${scales.left} ${y}h${scales.wide}` }),
      shape("text", { x: scales.left - 7, y: y + 4, "text-anchor": "end" }, digits(tick)));
  }
  group.append(
    shape("rect", { class: "frame", x: scales.left, y: PANEL.top, width: scales.wide, height: scales.tall }),
    shape("text", { class: "title", x: scales.left + scales.wide / 2, y: PANEL.height - 5, "text-anchor": "middle" }, abscissaTitle()),
    shape("text", { class: "title", transform: `translate(13 ${PANEL.top + scales.tall / 2}) rotate(-90)`, "text-anchor": "middle" }, panelTitle(panel)),
  );
  return group;
}

function titled(name, unit) {
  return unit ? `${name} [${unit}]` : name;
}

// The name of a single curve; several have theirs in the legend.
function panelTitle({ curves, unit }) {
  const name = curves.length === 1 ? curves[0].column.name : "";
  return name ? titled(name, unit) : unit ? `[${unit}]` : "[1]";
}

function gapAreas(scales) {
  const group = shape("g", { class: "gaps" });
  for (const { from, to } of isAgainstInput() ? report.gaps ?? [] : []) {
    const ends = [from, to].map((value) => scales.x(plotValue(value, input.unit)));
    const [x, width] = [Math.min(...ends), Math.max(2, Math.abs(ends[1] - ends[0]))];
    group.append(shape("rect", { class: "gap", x: pixel(x), y: PANEL.top, width: pixel(width), height: scales.tall }));
  }
  return group;
}

function bandAreas(panel, toScreen) {
  const group = shape("g", { class: "bands" });
  // Beside a quantity that comes back, a band would lie on its own curve.
  for (const curve of isAgainstInput() ? panel.curves : []) {
    for (const band of curve.column.bands) {
      const kind = band.kind === "worst case" ? "worst" : "statistical";
      group.append(shape("path", { class: `band ${kind}`, d: bandOutline(curve, band, toScreen), fill: curve.colour }));
    }
  }
  return group;
}

function curveLines(panel, toScreen) {
  const group = shape("g", { class: "curves" });
  for (const curve of panel.curves) {
    group.append(shape("path", {
      class: "curve", "data-column": curve.column.key, d: curveOutline(curve, toScreen),
      stroke: curve.colour, "stroke-dasharray": curve.dash,
    }));
  }
  return group;
}

// A line at a row, with a dot on each curve.
function drawCursor(group, panel, row) {
  const { scales } = panel;
  const value = scales.xs[row];
  if (value === null || value < scales.first || value > scales.last) return group.replaceChildren();
  const x = pixel(scales.x(value));
  group.replaceChildren(shape("path", { d: `M${x} ${PANEL.top}v${scales.tall}` }));
  for (const { ys, colour } of panel.curves) {
    const within = ys[row] !== null && ys[row] >= scales.low && ys[row] <= scales.high;
    if (within) group.append(shape("circle", { cx: x, cy: pixel(scales.y(ys[row])), r: 3.5, fill: colour }));
  }
}
