// The machine as somebody sees it who stands on a moving link: that stays where it was, and everything else, with all paths, moves about it.

// Points of a link that are nearer to each other, or to the line through two others, than this share of the mechanism say nothing of how it turns.
const TELLING = 1e-3;

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

// What can be stood on: links, and in the plane what slides on a guide of the frame.
function bodiesToStandOn() {
  const links = picture.links.map((link, index) => linkToStandOn(link, index));
  const blocks = picture.guides.filter(({ on }) => on === "frame" && !isSpatial()).map((guide) => ({
    name: `slider ${guide.name}`,
    own: ["guides", picture.guides.indexOf(guide)],
    node: `[data-slider="${CSS.escape(guide.name)}"]`,
    frame: (row) => {
      const [place, way] = [placeInReport(guide.slider, row), placeOf(picture.directions[guide.direction], row)];
      return place === null || way === null ? null : { origin: place, axes: axesAlong(way) };
    },
  }));
  return [...links, ...blocks].filter((body) => body !== null);
}

// Two of its points, in space three, as far apart as they are; null if they are in no row.
function linkToStandOn({ name, points }, index) {
  const rows = input.values.map((_, row) => row);
  const first = rows.find((row) => points.every((point) => placeInReport(point, row) !== null));
  if (first === undefined) return null;
  const [from, ...others] = points;
  const away = (point) => minus(placeInReport(point, first), placeInReport(from, first));
  const farthest = (size) => others.reduce((best, point) => (size(point) > size(best) ? point : best), others[0]);
  const end = farthest((point) => Math.hypot(...away(point)));
  const least = TELLING * camera.box.radius;
  if (Math.hypot(...away(end)) < least) return null;
  const beside = (point) => Math.hypot(...crossed(away(end), away(point))) / Math.hypot(...away(end));
  const side = isSpatial() ? farthest(beside) : end;
  if (isSpatial() && beside(side) < least) return null;
  return {
    name,
    own: ["links", index],
    node: `[data-link="${CSS.escape(name)}"]`,
    frame: (row) => {
      const [origin, along, aside] = [from, end, side].map((point) => placeInReport(point, row));
      if (origin === null || along === null || aside === null) return null;
      return { origin, axes: axesAlong(minus(along, origin), minus(aside, origin)) };
    },
  };
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

// By how many degrees of the screen the frame seems turned, in the plane.
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
