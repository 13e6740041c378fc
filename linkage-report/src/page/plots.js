// The panels below each other, their legends with values, and the actions of pointers in them.

const plots = { panels: [], width: 0, apart: false };

function startPlots() {
  startChooser(makePanels);
  byId("chooser").append(apartChoice(), ...abscissaChoice(), extremesChoice(), zoomButtons());
  if (columns.some((column) => column.bands.length > 0)) byId("chooser").append(wideningChoice());
  byId("chooser").append(zoomHint());
  observeSize(byId("panels"), measurePanels);
  onMove(showCursors);
  if (report.thinned) byId("plots-title").after(element("p", { id: "thinned", class: "cut" }, thinnedText()));
  if (before === null) return measurePanels();
  plots.width = before.plotWidth;
  makePanels();
}

function thinnedText() {
  const { rows, of } = report.thinned;
  return `This page has ${rows} of ${of} positions, the extremes of all quantities and the edges of gaps among them; the CSV files and data.json beside it have all.`;
}

function apartChoice() {
  plots.apart = areFarApart();
  const box = element("input", { id: "apart", type: "checkbox", checked: plots.apart });
  box.addEventListener("change", () => {
    plots.apart = box.checked;
    makePanels();
  });
  return element("label", { class: "aside" }, box, " Each on its own axis");
}

function wideningChoice() {
  const select = element("select", { id: "widening" });
  for (const factor of WIDENINGS) {
    select.append(element("option", { value: factor }, factor === 1 ? "as they are" : `${factor} times as wide`));
  }
  select.addEventListener("change", () => {
    widening.factor = Number(select.value);
    makePanels();
  });
  return element("label", { class: "aside" }, "Tolerance bands ", select);
}

function measurePanels() {
  const width = Math.floor(byId("panels").clientWidth);
  if (width === plots.width || !(width > 0)) return;
  plots.width = width;
  makePanels();
}

function makePanels() {
  plots.panels = chosenPanels(plots.apart);
  measureLabels(plots.panels);
  byId("panels").replaceChildren(...plots.panels.map(makePanel));
  if (kept.words !== "") byId("panels").prepend(element("p", { id: "kept", class: "cut" }, kept.words));
  if (plots.panels.length === 0) byId("panels").append(element("p", { class: "empty" }, machine.hidden.size > 0 ? "Choose quantities above, or show their parts." : "Choose quantities above."));
  showCursors(position.row);
}

function makePanel(panel) {
  const view = drawPanel(panel, plots.width);
  listenToPanel(view, panel);
  return element("figure", { class: "panel", "data-unit": panel.unit }, view, legend(panel));
}

// The legend is the readout, too: it stays where it is, on phones as well.
function legend(panel) {
  const body = element("tbody");
  for (const curve of panel.curves) {
    const line = shape("path", { d: "M1 6H25", stroke: curve.colour, "stroke-dasharray": curve.dash });
    curve.value = element("span");
    curve.halves = curve.column.bands.map(() => element("small"));
    curve.before = element("small");
    curve.cell = element("td", { class: "value" }, curve.value);
    body.append(element("tr", { "data-column": curve.column.key },
      element("td", {}, shape("svg", { class: "swatch", width: 26, height: 12, "aria-hidden": "true" }, line)),
      element("th", { scope: "row", title: legendTitle(curve.column) }, curve.column.name),
      curve.cell));
  }
  panel.where = element("caption");
  panel.beyond = element("p", { class: "cut" });
  panel.legend = element("table", { class: "legend" }, panel.where, body);
  panel.below = element("div", { class: "scroll" }, panel.legend);
  sayCut(panel);
  return panel.below;
}

function sayCut(panel) {
  if (panel.cut) write(panel.beyond, cutText(panel));
  hold(panel.below, panel.cut ? [panel.legend, panel.beyond] : [panel.legend]);
}

// The same curves through other numbers: their nodes stay, which take longer to make than all the rest. Cursors go where the position is told.
function redrawPanels() {
  for (const { curves } of plots.panels) for (const curve of curves) curve.ys = plotted(curve.column);
  measureLabels(plots.panels);
  for (const panel of plots.panels) {
    fillPanel(panel, plots.width);
    sayCut(panel);
  }
}

function legendTitle(column) {
  const of = column.of ? ` of ${column.of}` : "";
  const by = column.parameter ? ` by ${column.parameter}` : "";
  return `${column.table}: ${MEANINGS[column.meaning] ?? column.meaning}${of}${by}`;
}

function listenToPanel(view, panel) {
  const rowAt = (event) => rowAtPlace(panel, placeIn(view, event));
  const go = (event) => {
    if (event.shiftKey) return;
    setPlaying(false);
    moveTo(rowAt(event));
  };
  view.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.pointerType !== "mouse") return;
    if (event.shiftKey) startRectangle(event, panel, view);
    else go(event);
  });
  view.addEventListener("wheel", (event) => onPanelWheel(event, panel, view), { passive: false });
  view.addEventListener("keydown", (event) => onPanelKey(event, panel));
  view.addEventListener("dblclick", showAll);
  view.addEventListener("click", go);
  view.addEventListener("pointermove", (event) => {
    if (event.pointerType !== "mouse") return;
    if (event.buttons & 1) go(event);
    showPointer(rowAt(event));
  });
  view.addEventListener("pointerleave", hidePointer);
}

function showPointer(row) {
  for (const panel of plots.panels) {
    drawCursor(panel.pointer, panel, row);
    showValues(panel, row, "Pointer");
  }
}

function hidePointer() {
  for (const panel of plots.panels) {
    panel.pointer.replaceChildren();
    showValues(panel, position.row, "Position");
  }
}

function showCursors(row) {
  for (const panel of plots.panels) {
    drawCursor(panel.cursor, panel, row);
    if (!panel.pointer.hasChildNodes()) showValues(panel, row, "Position");
  }
}

function showValues(panel, row, what) {
  write(panel.where, `${what}: ${inputText(input.values[row])}`);
  for (const { column, cell, value, halves, kept: other, before } of panel.curves) {
    write(value, withUnit(column.values[row], column.unit));
    const known = column.bands.map((band, k) => ({ band, node: halves[k] })).filter(({ band }) => band.half[row] !== null);
    for (const { band, node } of known) write(node, `${band.kind} \u00b1 ${withUnit(band.half[row], column.unit)}`);
    if (other !== null) write(before, `dotted ${withUnit(other.column.values[row], column.unit)}`);
    hold(cell, [value, ...(other === null ? [] : [before]), ...known.map(({ node }) => node)]);
  }
}
