// Parts of the plots: wheel, drag, keys, buttons.

// Ends of the abscissa, which all panels share, and of the ordinates by the panels' names; all is seen without them.
const zoom = { x: null, y: new Map() };

// No part is smaller than this share of all: curves are lines from row to row.
const SMALLEST = 1e-3;
const STEP = 1.5;
// Pixels after which a drag is meant.
const DRAWN = 5;

function showAll() {
  zoom.x = null;
  zoom.y.clear();
  makePanels();
}

// Returns true for a row within the visible part of the abscissa.
function seenRows() {
  if (zoom.x === null) return () => true;
  const xs = abscissaValues();
  const [first, last] = zoom.x;
  return (row) => xs[row] !== null && xs[row] >= first && xs[row] <= last;
}

function showPart(first, last) {
  const [low, high] = wholeAbscissa();
  const wide = Math.min(high - low, Math.max(last - first, SMALLEST * (high - low)));
  const begin = Math.min(high - wide, Math.max(low, (first + last - wide) / 2));
  zoom.x = wide < high - low ? [begin, begin + wide] : null;
  makePanels();
}

// The place at `about` stays there.
function scalePart(factor, about) {
  const [first, last] = zoom.x ?? wholeAbscissa();
  if (factor < 1) zoom.y.clear();
  showPart(about + (first - about) / factor, about + (last - about) / factor);
}

// The place where keys and buttons zoom: the position if it is visible.
function zoomCentre() {
  const [first, last] = zoom.x ?? wholeAbscissa();
  const here = abscissaValues()[position.row];
  return here !== null && here >= first && here <= last ? here : (first + last) / 2;
}

function onPanelWheel(event, panel, view) {
  const { scales } = panel;
  if (event.ctrlKey || event.metaKey) {
    event.preventDefault();
    scalePart(Math.exp(-0.003 * event.deltaY), scales.value(placeIn(view, event)[0]));
  } else if (zoom.x !== null && Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
    event.preventDefault();
    const [first, last] = zoom.x;
    const by = (event.deltaX * (last - first)) / scales.wide;
    showPart(first + by, last + by);
  }
}

const ZOOM_KEYS = { "+": STEP, "=": STEP, "-": 1 / STEP };

function onPanelKey(event, panel) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const index = plots.panels.indexOf(panel);
  if (event.key in ZOOM_KEYS) scalePart(ZOOM_KEYS[event.key], zoomCentre());
  else if (event.key === "0" || event.key === "Escape") showAll();
  else return;
  event.preventDefault();
  // The panel has been made anew.
  plots.panels[index]?.view.focus();
}

function placeIn(view, event) {
  const { left, top } = view.getBoundingClientRect();
  return [event.clientX - left, event.clientY - top];
}

// Shift and drag: the rectangle fills the panel.
function startRectangle(event, panel, view) {
  const from = placeIn(view, event);
  const mark = shape("rect", { class: "part" });
  view.append(mark);
  view.setPointerCapture(event.pointerId);
  let to = from;
  const move = (moved) => {
    to = placeIn(view, moved);
    const [x, y] = [0, 1].map((i) => Math.min(from[i], to[i]));
    set(mark, { x, y, width: Math.abs(to[0] - from[0]), height: Math.abs(to[1] - from[1]) });
  };
  const end = (ended) => {
    view.removeEventListener("pointermove", move);
    mark.remove();
    const meant = [0, 1].every((i) => Math.abs(to[i] - from[i]) > DRAWN);
    if (ended.type === "pointerup" && meant) showRectangle(panel, from, to);
  };
  view.addEventListener("pointermove", move);
  for (const name of ["pointerup", "pointercancel"]) view.addEventListener(name, end, { once: true });
}

function showRectangle(panel, from, to) {
  const { scales } = panel;
  const ends = (values) => [Math.min(...values), Math.max(...values)];
  zoom.y.set(panel.name, ends([from[1], to[1]].map(scales.height)));
  showPart(...ends([from[0], to[0]].map(scales.value)));
}

function zoomButtons() {
  const button = (id, text, title, press) => {
    const node = element("button", { id, type: "button", title, "aria-label": title }, text);
    node.addEventListener("click", press);
    return node;
  };
  return element("span", { id: "part", class: "aside", role: "group", "aria-label": "Part of the plots" },
    button("part-less", "+", "Zoom in at the position", () => scalePart(STEP, zoomCentre())),
    button("part-more", "\u2212", "Zoom out", () => scalePart(1 / STEP, zoomCentre())),
    button("part-all", "All", "The whole range", showAll));
}

function zoomHint() {
  return element("p", { class: "aside hint" }, "Ctrl and wheel, shift and drag, or the keys + and \u2212 zoom in plots; a double click or 0 shows all.");
}
