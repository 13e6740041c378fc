// Velocities, accelerations and forces at points as arrows, and the poles about which links turn, where the reader asks for them.

// The longest arrow beside the mechanism, the head of each in pixels, a letter of its name, and the distance of that.
const ARROW = { share: 0.35, head: 9, half: 3.6, letter: 6.6, apart: 9 };
// A pole farther away than so many sizes of the mechanism is at infinity, and one so near to a pivot is that.
const POLE = { far: 20, same: 1e-3, arm: 7 };

// Weights of five rows for the derivatives of the first and the second order at the first, second and third of them. The errors are of the fourth
// power of their distance, of the third for second derivatives that are not in the middle.
const DIFFERENCES = {
  1: [[-25 / 12, 4, -3, 4 / 3, -1 / 4], [-1 / 4, -5 / 6, 3 / 2, -1 / 2, 1 / 12], [1 / 12, -2 / 3, 0, 2 / 3, -1 / 12]],
  2: [[35 / 12, -26 / 3, 19 / 2, -14 / 3, 11 / 12], [11 / 12, -5 / 3, 1 / 2, 1 / 3, -1 / 12], [-1 / 12, 4 / 3, -5 / 2, 4 / 3, -1 / 12]],
};

// The longest arrow beside a singular position, compared with the middle one of all.
const MOST_OF_MIDDLE = 4;

const vectors = { shown: new Map(), nodes: new Map(), longest: new Map(), layer: null };

// A row beside another one; over the end of a whole turn it goes on.
function rowBeside(row, by) {
  const beside = row + by;
  if (beside >= 0 && beside < rowCount) return beside;
  return input.periodic ? (beside + rowCount - 1) % (rowCount - 1) : null;
}

// The derivative of a place with respect to the input, by rows on both sides if there are such; null if five of them are nowhere.
function placeRate(index, row, order) {
  const step = span() / (rowCount - 1);
  for (const before of [2, 1, 3, 0, 4]) {
    const rows = [0, 1, 2, 3, 4].map((k) => rowBeside(row, k - before));
    const places = rows.map((own) => (own === null ? null : pointAt(index, own)));
    if (places.includes(null)) continue;
    const weights = before > 2 ? DIFFERENCES[order][4 - before].toReversed().map((own) => (order === 1 ? -own : own)) : DIFFERENCES[order][before];
    return places[0].map((_, i) => weights.reduce((sum, weight, k) => sum + weight * places[k][i], 0) / step ** order);
  }
  return null;
}

// The points with arrows: those whose paths are shown, otherwise all that move.
function pointsWithArrows() {
  const traced = [...traces.paths.keys()];
  return traced.length > 0 ? traced : drawnPoints().filter((index) => drawing.points.get(index).classList.contains("moving"));
}

// The longest vector of an order over the range, so that arrows keep their scale; until places change.
function longestRate(order) {
  if (!vectors.longest.has(order)) {
    let longest = 0;
    for (const index of pointsWithArrows()) {
      eachRow((row) => {
        const rate = placeRate(index, row, order);
        if (rate !== null) longest = Math.max(longest, Math.hypot(...rate));
      });
    }
    vectors.longest.set(order, longest);
  }
  return vectors.longest.get(order);
}

function forgetVectors() {
  vectors.longest.clear();
}

function arrowOf(index, row, order) {
  const rate = placeRate(index, row, order);
  if (rate === null) return null;
  const [kind, unit] = [order === 1 ? "velocity" : "acceleration", `${picture.unit}/${input.unit || "1"}${order === 1 ? "" : "^2"}`];
  return arrowAt(index, row, { kind, name: picture.points[index].name, vector: rate, longest: longestRate(order), unit });
}

// An arrow at a point, whose length is a share of the longest one.
function arrowAt(index, row, { kind, name, vector, longest, unit }) {
  const place = pointAt(index, row);
  if (place === null || !(longest > 0) || isHidden(["points", index])) return null;
  const [from, to] = [place, along(place, vector, (ARROW.share * camera.box.radius) / Math.max(longest, Math.hypot(...vector)))].map((own) => project(own).slice(0, 2));
  const length = distance(from, to);
  const [u, v] = length > 0 ? [(to[0] - from[0]) / length, (to[1] - from[1]) / length] : [1, 0];
  const head = Math.min(ARROW.head, length);
  const half = (ARROW.half * head) / ARROW.head;
  const corner = (side) => [to[0] - head * u - side * half * v, to[1] - head * v + side * half * u];
  const { node, title, line, head: tip, text } = vectorNode(`${kind} ${name}`, () => {
    // Velocities and accelerations are at points, which have names.
    const parts = { title: shape("title"), line: shape("path", { class: "line" }), head: shape("path", { class: "head" }), text: kind === "force" ? shape("text", {}, name) : "" };
    return { ...parts, node: shape("g", { class: kind, "data-arrow": name }, parts.title, parts.line, parts.head, parts.text) };
  });
  write(title, `${kind} of ${name}: ${digits(rounded(Math.hypot(...vector), 4))} ${unit}`);
  set(line, { d: lineThrough([from, to]) });
  set(tip, { d: `${lineThrough([to, corner(1), corner(-1)])}Z` });
  if (text) placeArrowName(text, to, [u, v], length);
  return node;
}

// A name beyond the tip of its arrow, within the drawing; none at an arrow without a length.
function placeArrowName(text, [x, y], [u, v], length) {
  const half = (ARROW.letter * text.textContent.length) / 2;
  const within = (at, least, most) => Math.min(most - least, Math.max(least, at));
  const place = [within(x + u * (half + ARROW.apart), half, camera.width), within(y + v * ARROW.apart + 4, 14, camera.height)];
  set(text, { x: pixel(place[0]), y: pixel(place[1]) });
  text.style.display = length > ARROW.head ? "" : "none";
}

// The columns of a force, a vector of one of the tables.
function columnsOfForce(quantity) {
  const axes = ["x", "y", "z"].slice(0, picture.dimension).map((axis) => `${quantity}.${axis}`);
  const first = columns.find((column) => column.name === axes[0] && column.meaning !== "true");
  return axes.map((axis) => columns.find((column) => column.name === axis && column.table === first.table && column.meaning !== "true"));
}

function forceAt(parts, row) {
  const force = parts.map((column) => column.values[row]);
  return force.includes(null) ? null : force;
}

// All forces have one scale. Near a singular position they are so large that no other one would be seen: these are drawn too short.
function longestForce() {
  if (!vectors.longest.has("force")) {
    const sizes = [];
    for (const { quantity } of picture.forces) {
      const parts = columnsOfForce(quantity);
      eachRow((row) => sizes.push(Math.hypot(...(forceAt(parts, row) ?? [0]))));
    }
    sizes.sort((a, b) => a - b);
    const [middle, largest] = [sizes[Math.floor(sizes.length / 2)], sizes.at(-1)];
    vectors.longest.set("force", singularWords() !== null && middle > 0 ? Math.min(largest, MOST_OF_MIDDLE * middle) : largest);
  }
  return vectors.longest.get("force");
}

function forceArrow({ point, quantity }, row) {
  const parts = columnsOfForce(quantity);
  const force = forceAt(parts, row);
  if (force === null) return null;
  return arrowAt(point, row, { kind: "force", name: quantity, vector: seenDirection(force, row), longest: longestForce(), unit: parts[0].unit });
}

// Nodes stay, as those of the mechanism do.
function vectorNode(key, make) {
  if (!vectors.nodes.has(key)) vectors.nodes.set(key, make());
  return vectors.nodes.get(key);
}

// The point of a plane link that is at rest; null if the link does not turn, or about a pivot that is drawn anyway.
function poleOf({ points: [a, ...others] }, row) {
  const [from, speed] = [pointAt(a, row), placeRate(a, row, 1)];
  if (from === null || speed === null) return null;
  for (const b of others) {
    const [to, other] = [pointAt(b, row), placeRate(b, row, 1)];
    if (to === null || other === null) continue;
    const [step, change] = [minus(to, from), minus(other, speed)];
    const omega = (step[0] * change[1] - step[1] * change[0]) / dot(step, step);
    const pole = [from[0] - speed[1] / omega, from[1] + speed[0] / omega];
    const away = (place) => Math.hypot(...minus(place, pole));
    if (!(away(camera.box.middle) < POLE.far * camera.box.radius)) return null;
    const isPivot = drawnPoints().some((index) => picture.points[index].kind === "ground" && pointAt(index, row) !== null && away(pointAt(index, row)) < POLE.same * camera.box.radius);
    return isPivot ? null : pole;
  }
  return null;
}

function poleMark(link, index, row) {
  if (isHidden(["links", index])) return null;
  const pole = poleOf(link, row);
  if (pole === null) return null;
  const [x, y] = project(pole).map(pixel);
  const { arm } = POLE;
  const { node, cross, text } = vectorNode(`pole ${link.name}`, () => {
    const parts = { cross: shape("path"), text: shape("text", {}, link.name) };
    const title = shape("title", {}, `pole of link ${link.name}: it turns about this point`);
    return { ...parts, node: shape("g", { class: "pole", "data-pole": link.name }, title, parts.cross, parts.text) };
  });
  set(node, { "data-x": pole[0], "data-y": pole[1] });
  set(cross, { d: `M${x - arm} ${y}L${x + arm} ${y}M${x} ${y - arm}L${x} ${y + arm}` });
  set(text, { x: x + arm, y: y - arm });
  return node;
}

const VECTOR_KINDS = {
  velocity: { text: "v", title: "Velocities of traced points", make: (row) => pointsWithArrows().map((index) => arrowOf(index, row, 1)) },
  acceleration: { text: "a", title: "Accelerations of traced points", make: (row) => pointsWithArrows().map((index) => arrowOf(index, row, 2)) },
  force: { text: "F", title: "Reactions in joints", make: (row) => picture.forces.map((force) => forceArrow(force, row)) },
  poles: { text: "Poles", title: "Instant centres of links", make: (row) => picture.links.map((link, index) => poleMark(link, index, row)) },
};

function startVectors() {
  vectors.layer = drawing.layers.vectors;
  for (const [kind, { text, title }] of Object.entries(VECTOR_KINDS)) {
    // Differences need even steps of the input.
    const isDifference = kind !== "force";
    if (isDifference ? rowCount < 5 || report.thinned || (kind === "poles" && isSpatial()) : !picture.forces) continue;
    const button = element("button", { type: "button", "data-vectors": kind, "aria-pressed": "false", title }, text);
    button.addEventListener("click", () => {
      if (!vectors.shown.delete(kind)) vectors.shown.set(kind, VECTOR_KINDS[kind].make);
      button.setAttribute("aria-pressed", vectors.shown.has(kind));
      drawVectors(position.row);
    });
    byId("views").append(button);
  }
}

function drawVectors(row) {
  hold(vectors.layer, [...vectors.shown.values()].flatMap((make) => make(row)).filter((node) => node !== null));
}
