// The machine as somebody sees it who stands on a moving link: that stays where it was, and everything else, with all paths, moves about it.

// Points of a link that are nearer to each other, or to the line through two others, than this share of the mechanism say nothing of how it turns.
const TELLING = 1e-3;
// A line is square to an axis but for rounding.
const SQUARE = 1e-9;

// `home` is the frame of the link that stands still, `frames` those of all rows that were asked for.
const stand = { body: null, home: null, frames: [] };

function isStanding() {
  return stand.home !== null;
}

function crossed(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

// Unit vectors, the first one along `along`; in space the second one is on the side of `aside`. Null if these do not tell.
function axesAlong(along, aside) {
  const unit = (v) => v.map((component) => component / Math.hypot(...v));
  const first = unit(along);
  if (!isSpatial()) return [first, [-first[1], first[0]]];
  const across = minus(aside, first.map((component) => component * dot(aside, first)));
  const second = unit(across);
  return [first, second, crossed(first, second)];
}

function placeInReport(index, row) {
  return placeOf(picture.points[index], row);
}

// Bodies to stand on: links, and sliders on straight guides of the frame.
function bodiesToStandOn() {
  const blocks = picture.guides.map((guide) => (guide.on === "frame" && guide.shape !== "arc" ? blockToStandOn(guide) : null));
  return [...picture.links.map(linkToStandOn), ...blocks].filter((body) => body !== null);
}

// It does not turn.
function blockToStandOn({ name, slider }) {
  const axes = Array.from({ length: picture.dimension }, (_, k) => Array.from({ length: picture.dimension }, (_, i) => (i === k ? 1 : 0)));
  const frame = (row) => {
    const origin = placeInReport(slider, row);
    return origin === null ? null : { origin, axes };
  };
  return { name: `slider ${name}`, node: `[data-slider="${CSS.escape(name)}"]`, frame };
}

// A link by two of its points, as far apart as they are; in space by a third one, or by the axis about which the line through two turns. Null if it is
// in no row, and if nothing tells how it turns about that line.
function linkToStandOn({ name, points: [from, ...others] }) {
  const body = (frame) => ({ name, node: `[data-link="${CSS.escape(name)}"]`, frame });
  const step = (point, row) => {
    const [start, place] = [from, point].map((own) => placeInReport(own, row));
    return start === null || place === null ? null : minus(place, start);
  };
  const first = input.values.findIndex((_, row) => others.every((point) => step(point, row) !== null));
  if (first < 0) return null;
  const farthest = (size) => others.reduce((best, point) => (size(point) > size(best) ? point : best));
  const end = farthest((point) => Math.hypot(...step(point, first)));
  const least = TELLING * camera.box.radius;
  if (Math.hypot(...step(end, first)) < least) return null;
  const framed = (aside) => body((row) => {
    const [along, side] = [step(end, row), aside(row)];
    return along === null || side === null ? null : { origin: placeInReport(from, row), axes: axesAlong(along, side) };
  });
  if (!isSpatial()) return framed((row) => step(end, row));
  const beside = (point) => Math.hypot(...crossed(step(end, first), step(point, first))) / Math.hypot(...step(end, first));
  const third = farthest(beside);
  if (beside(third) > least) return framed((row) => step(third, row));
  const axis = axisOfTurning((row) => step(end, row));
  return axis === null ? null : framed(() => axis);
}

// The direction that a line that moves stays square to, or null: that of a coupler between balls is none, and who stands on it might turn about it.
function axisOfTurning(along) {
  const known = input.values.flatMap((_, row) => (along(row) === null ? [] : [along(row).map((component) => component / Math.hypot(...along(row)))]));
  const ways = known.map((way) => crossed(known[0], way));
  const widest = ways.reduce((best, way) => (Math.hypot(...way) > Math.hypot(...best) ? way : best));
  const size = Math.hypot(...widest);
  if (size < TELLING) return null;
  const axis = widest.map((component) => component / size);
  return known.every((way) => Math.abs(dot(way, axis)) < SQUARE) ? axis : null;
}

function frameAt(row) {
  if (stand.frames[row] === undefined) stand.frames[row] = stand.body.frame(row);
  return stand.frames[row];
}

// A direction, or a step, as it is seen from the link.
function seenDirection(direction, row) {
  if (!isStanding()) return direction;
  const frame = frameAt(row);
  if (frame === null) return null;
  const parts = frame.axes.map((axis) => dot(direction, axis));
  return direction.map((_, i) => stand.home.axes.reduce((sum, axis, k) => sum + parts[k] * axis[i], 0));
}

function seenPlace(place, row) {
  if (!isStanding()) return place;
  const frame = frameAt(row);
  if (frame === null) return null;
  const step = seenDirection(minus(place, frame.origin), row);
  return step.map((component, i) => stand.home.origin[i] + component);
}

// The apparent turn of the frame in the plane, in degrees of the screen.
function seenTurn(row) {
  const seen = seenDirection([1, 0], row);
  return seen === null ? 0 : (-180 / Math.PI) * Math.atan2(seen[1], seen[0]);
}

// On a body, or on the frame again. It stands where it is now; where it is nowhere now, as in the first row in which it is.
function standOn(body) {
  const rows = [position.row, ...input.values.map((_, row) => row)];
  const row = body === null ? undefined : rows.find((own) => body.frame(own) !== null);
  for (const node of byId("drawing").querySelectorAll(".standing")) node.classList.remove("standing");
  Object.assign(stand, { body: row === undefined ? null : body, home: row === undefined ? null : body.frame(row), frames: [] });
  if (isStanding()) byId("drawing").querySelector(body.node).classList.add("standing");
  byId("back").hidden = !isStanding();
  byId("seen").value = isStanding() ? stand.bodies.indexOf(body) : "";
  for (const [index, node] of drawing.points) node.classList.toggle("moving", isMoving(index));
  camera.box = extent();
  forgetVectors();
  findAway();
  fitAll();
}

function standChoice() {
  stand.bodies = bodiesToStandOn();
  const select = element("select", { id: "seen", title: "On what you stand: it does not move, and paths are those that it sees" },
    element("option", { value: "" }, "the frame"),
    ...stand.bodies.map(({ name }, index) => element("option", { value: index }, name)));
  select.addEventListener("change", () => standOn(stand.bodies[select.value] ?? null));
  const back = element("button", { id: "back", type: "button", hidden: true, title: "Back to the frame", "aria-label": "Back to the frame" }, "Back");
  back.addEventListener("click", () => {
    standOn(null);
    select.focus();
  });
  byId("drawing").addEventListener("dblclick", (event) => {
    const node = event.target.closest("[data-link]");
    const body = stand.bodies.find((own) => node?.matches(own.node));
    if (body) standOn(body === stand.body ? null : body);
  });
  return element("div", { class: "seen" }, element("label", { for: "seen" }, "Seen from"), select, back);
}
