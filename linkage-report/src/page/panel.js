// One panel: axes with units, curves, bands, gaps, and the cursor at the mechanism's position.

const PANEL = { height: 210, top: 10, right: 14, bottom: 38, letter: 7.2 };

// All panels begin at the same place, so that one abscissa lies below the other.
const panelLeft = { width: 60 };

function measureLabels(panels) {
  const labels = panels.flatMap((panel) => panelTicks(panel).map((tick) => digits(tick).length));
  const width = 30 + PANEL.letter * Math.max(4, ...labels);
  // The place under the pointer stays there while the parts change.
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

// The nodes of a panel. `fillPanel` fills them with numbers.
function drawPanel(panel, width) {
  const view = shape("svg", {
    class: "plot", width, height: PANEL.height, viewBox: `0 0 ${width} ${PANEL.height}`, role: "img", tabindex: 0,
    "aria-label": `${panel.curves.map((curve) => curve.column.name).join(", ")} against ${(abscissa.column ?? input).name}`,
  });
  const clip = `frame-${plots.panels.indexOf(panel)}`;
  const clipped = (...parts) => shape("g", { "clip-path": `url(#${clip})` }, ...parts);
  panel.clip = shape("rect");
  panel.gaps = shape("g", { class: "gaps" });
  panel.extremes = shape("g", { class: "extremes" });
  panel.cursor = shape("g", { class: "cursor", "data-cursor": "position" });
  panel.pointer = shape("g", { class: "cursor pointer", "data-cursor": "pointer" });
  view.append(shape("clipPath", { id: clip }, panel.clip), clipped(panel.gaps), makeAxes(panel),
    clipped(bandAreas(panel), curveLines(panel)), panel.extremes, panel.pointer, panel.cursor);
  panel.view = view;
  fillPanel(panel, width);
  return view;
}

function fillPanel(panel, width) {
  const scales = panelScales(panel, width);
  panel.scales = scales;
  // The frame and half a stroke around it.
  set(panel.clip, { x: scales.left - 1, y: PANEL.top - 1, width: scales.wide + 2, height: scales.tall + 2 });
  shadeGaps(panel);
  placeAxes(panel);
  const places = scales.xs.map((x) => (x === null ? null : scales.x(x)));
  const across = places.map((x) => (x === null ? null : pixelText(x)));
  for (const curve of panel.curves) {
    set(curve.line, { d: curveOutline(curve, across, scales) });
    if (curve.kept !== null) set(curve.keptLine, { d: curveOutline(curve.kept, keptAcross(across, scales), scales) });
    for (const [band, area] of curve.areas) set(area, { d: bandOutline(curve, band, across, scales) });
  }
  markExtremes(panel, places);
}

// The places of the rows of the design that is kept, which has other values of a quantity.
function keptAcross(across, scales) {
  if (isAgainstInput()) return across;
  const { unit, key } = abscissa.column;
  return kept.columns.get(key).map((value) => (value === null ? null : pixelText(scales.x(plotValue(value, unit)))));
}

function shadeGaps({ gaps: group, scales }) {
  const gaps = isAgainstInput() ? report.gaps ?? [] : [];
  if (gaps.length === 0 && !group.hasChildNodes()) return;
  const parts = gaps.flatMap(({ from, to }) => {
    const ends = [from, to].map((value) => scales.x(inputPlace(value)));
    const [x, width] = [Math.min(...ends), Math.max(2, Math.abs(ends[1] - ends[0]))];
    return [
      shape("rect", { class: "gap", x: pixel(x), y: PANEL.top, width: pixel(width), height: scales.tall }),
      shape("path", { class: "hatch", d: hatchedArea(x, PANEL.top, x + width, PANEL.top + scales.tall) }),
    ];
  });
  group.replaceChildren(...parts);
}

function bandAreas(panel) {
  const group = shape("g", { class: "bands" });
  for (const curve of panel.curves) {
    // Beside a quantity that comes back, a band would lie on its own curve.
    const bands = isAgainstInput() ? curve.column.bands : [];
    curve.areas = new Map(bands.map((band) => {
      const kind = band.kind === "worst case" ? "worst" : "statistical";
      return [band, shape("path", { class: `band ${kind}`, fill: curve.colour })];
    }));
    group.append(...curve.areas.values());
  }
  return group;
}

function curveLines(panel) {
  for (const curve of panel.curves) {
    curve.line = shape("path", { class: "curve", "data-column": curve.column.key, stroke: curve.colour, "stroke-dasharray": curve.dash });
    curve.keptLine = shape("path", { class: "curve kept", "data-kept": curve.column.key, stroke: curve.colour, "stroke-dasharray": "1 4" });
  }
  const before = panel.curves.filter((curve) => curve.kept !== null).map(({ keptLine }) => keptLine);
  return shape("g", { class: "curves" }, ...before, ...panel.curves.map(({ line }) => line));
}

// A line at a row, with a dot on each curve.
function drawCursor(group, panel, row) {
  const { scales } = panel;
  const value = scales.xs[row];
  if (value === null || value < scales.first || value > scales.last) return group.replaceChildren();
  if (!group.hasChildNodes()) group.append(shape("path"));
  const x = pixel(scales.x(value));
  set(group.firstChild, { d: `M${x} ${PANEL.top}v${scales.tall}` });
  const seen = panel.curves.filter(({ ys }) => ys[row] !== null && ys[row] >= scales.low && ys[row] <= scales.high);
  while (group.childNodes.length > seen.length + 1) group.lastChild.remove();
  while (group.childNodes.length < seen.length + 1) group.append(shape("circle", { r: 3.5 }));
  seen.forEach(({ ys, colour }, k) => set(group.childNodes[k + 1], { cx: x, cy: pixel(scales.y(ys[row])), fill: colour }));
}
