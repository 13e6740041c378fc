// The drawing as a picture that moves by itself: values of its attributes at some positions, between which it moves straight.

// About so many positions for a cycle, as in drawings of a report.
const FILM_KEYS = 60;
const MOVING = ["d", "cx", "cy", "x", "y"];

// Rows from the first to the last where the mechanism is whole, and back where it is not a whole turn.
function filmRows() {
  const last = rowCount - 1;
  const step = Math.ceil(last / (input.periodic ? FILM_KEYS : FILM_KEYS / 2));
  const there = Array.from({ length: Math.ceil(last / step) }, (_, k) => k * step);
  return input.periodic ? [...there, 0] : [...there, last, ...[...there].reverse()];
}

function wholeRows(rows) {
  return rows.filter((row) => {
    placeAll(row);
    return byId("impossible").hidden;
  });
}

function filmPage() {
  const rows = wholeRows(filmRows());
  if (rows.length === 0) return drawingPage();
  placeAll(rows[0]);
  const pairs = [];
  const page = drawingPage(pairs);
  const courses = pairs.map(([node]) => ({ node, values: Object.fromEntries([...MOVING, "transform"].map((name) => [name, []])) }));
  for (const row of rows) {
    placeAll(row);
    for (const { node, values: all } of courses) for (const [name, list] of Object.entries(all)) list.push(node.getAttribute(name) ?? "");
  }
  placeAll(position.row);
  const seconds = player.period * (input.periodic ? 1 : 2);
  pairs.forEach(([, copy], k) => {
    const { transform, ...others } = courses[k].values;
    for (const [name, list] of Object.entries(others)) if (isMoved(list)) copy.append(animated("animate", name, list, seconds));
    if (isMoved(transform)) copy.append(...animatedTransform(transform, seconds));
  });
  return page;
}

function placeAll(row) {
  for (const place of drawing.placers) place(row);
}

function isMoved(list) {
  return list.some((value) => value !== list[0]);
}

// Outlines with other corners than before change at once.
function animated(kind, name, list, seconds, more = {}) {
  const forms = new Set(list.map((value) => value.replace(/-?[\d.]+/g, "0")));
  return shape(kind, { attributeName: name, values: list.join(";"), dur: `${rounded(seconds, 6)}s`, repeatCount: "indefinite", calcMode: forms.size > 1 ? "discrete" : null, ...more });
}

// A place, and a turn the short way.
function animatedTransform(list, seconds) {
  const numbers = list.map((text) => text.match(/-?[\d.]+/g).map(Number));
  const turns = numbers.map(([, , turn]) => turn ?? 0);
  for (let k = 1; k < turns.length; k += 1) turns[k] -= 360 * Math.round((turns[k] - turns[k - 1]) / 360);
  const places = numbers.map(([x, y]) => `${x} ${y}`);
  return [animated("animateTransform", "transform", places, seconds, { type: "translate" }),
    ...(isMoved(turns) ? [animated("animateTransform", "transform", turns.map((turn) => String(pixel(turn))), seconds, { type: "rotate", additive: "sum" })] : [])];
}
