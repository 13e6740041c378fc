// Names of points: each where nothing is below it, beside its point if there is room, otherwise at the end of a thin line.

const NAMES = {
  // Pixels between a name and other shapes, and between a joint and its name.
  clear: 2,
  apart: 3,
  // A name that comes back to its point needs more room than one that stays there: it would jump to and fro.
  spare: 5,
  // Up to here a name seems to belong to its point without a line.
  beside: 8,
  // Distance from the edge of the drawing.
  edge: 4,
};
// Ways from the point in steps of 22.5 degrees, and how far away a name may be.
const WAYS = 16;
const RINGS = [0, 4, 8, 20, 33, 48, 66, 88, 114, 144, 180, 222, 270];
// To the upper right, unless something is there.
const FIRST_WAY = -Math.PI / 4;
// The price of a line to a name in pixels of its length if it crosses a joint or another line.
const CROSSING = 30;

const ways = Array.from({ length: WAYS }, (_, n) => {
  // To both sides in turn, so that earlier ones are nearer to the first.
  const angle = FIRST_WAY + (n % 2 === 0 ? -1 : 1) * Math.ceil(n / 2) * ((2 * Math.PI) / WAYS);
  return { direction: [Math.cos(angle), Math.sin(angle)], order: n };
});

// The words and the line to them, which belong to a point.
function nameParts(point) {
  const label = shape("text", { class: "name", "text-anchor": "middle" }, point.name);
  return { label, leader: shape("path", { class: "leader" }), choice: null, size: null };
}

// Words have a size as soon as they are part of the page.
function sizeOfName(name) {
  if (name.size === null || name.size.half[0] === 0) {
    set(name.label, { x: 0, y: 0 });
    const { x, y, width, height } = name.label.getBBox();
    name.size = { half: [width / 2, height / 2], shift: [-(x + width / 2), -(y + height / 2)] };
  }
  return name.size;
}

// The distance along a direction at which the middle of a box is this far from the start.
function awayFor(apart, [wide, high], direction) {
  const [c, s] = direction.map(Math.abs);
  // Beside, above or below, otherwise with a corner.
  if (s * (apart + wide) <= c * high) return (apart + wide) / c;
  if (c * (apart + high) <= s * wide) return (apart + high) / s;
  const middle = c * wide + s * high;
  return middle + Math.sqrt(middle * middle - wide * wide - high * high + apart * apart);
}

function candidate(at, radius, half, way, ring) {
  const [c, s] = way.direction;
  const away = awayFor(radius + NAMES.apart + RINGS[ring], half, way.direction);
  const middle = [at[0] + away * c, at[1] + away * s];
  return {
    way, ring, middle, offset: [away * c, away * s],
    box: [middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1]],
  };
}

// The line from the rim of the joint to the box.
function leaderOf(at, radius, { box, ring }) {
  if (RINGS[ring] <= NAMES.beside) return null;
  const end = [Math.min(box[2], Math.max(box[0], at[0])), Math.min(box[3], Math.max(box[1], at[1]))];
  const length = Math.hypot(end[0] - at[0], end[1] - at[1]) || 1;
  return [[0, 1].map((i) => at[i] + (radius * (end[i] - at[i])) / length), end];
}

// Returns true if nothing is below the words, and no line to them crosses other words.
function isFree(place, scene, clear) {
  const { box } = place;
  const [width, height] = [camera.width - NAMES.edge, camera.height - NAMES.edge];
  if (box[0] < NAMES.edge || box[1] < NAMES.edge || box[2] > width || box[3] > height) return false;
  if (scene.shapes.some((shape) => isCovered(box, shape, clear))) return false;
  if (scene.boxes.some((other) => isCovered(box, other, clear))) return false;
  if (scene.leaders.some((line) => isCovered(box, line, clear))) return false;
  return place.leader === null || !scene.boxes.some((other) => isCovered(other.box, taken(place.leader, 0), NAMES.clear));
}

// Distance from the point, then order of ways; beside a choice before, distance from that.
function priceOf(place, before, scene, at) {
  const moved = before === null ? 0 : distance(place.offset, before.offset);
  let price = RINGS[place.ring] + (before === null ? place.way.order : 0.5 * moved);
  if (place.leader !== null) {
    const line = taken(place.leader, 0);
    const joints = scene.joints.filter((joint) => distance(joint.places[0], at) > joint.half);
    if (joints.some((joint) => placeToStretch(joint.places[0], ...line.places) < joint.half)) price += CROSSING;
    if (scene.leaders.some((other) => stretchesCross(line.places, other.places))) price += CROSSING;
  }
  return price;
}

function stretchesCross([a, b], [c, d]) {
  const side = (p, q, r) => Math.sign((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Null where there is no room: words on words are none.
function chosenPlace(name, at, radius, scene) {
  const { half } = sizeOfName(name);
  const at0 = (way, ring) => {
    const place = candidate(at, radius, half, way, ring);
    place.leader = leaderOf(at, radius, place);
    return place;
  };
  const before = name.choice && at0(name.choice.way, name.choice.ring);
  const stays = before !== null && isFree(before, scene, NAMES.clear);
  if (stays && before.leader === null) return before;
  let best = stays ? before : null;
  let least = Infinity;
  for (let ring = 0; ring < RINGS.length && RINGS[ring] < least; ring += 1) {
    // A name as far away as this may as well stay.
    if (stays && ring >= before.ring) break;
    for (const way of ways) {
      const place = at0(way, ring);
      if (!isFree(place, scene, stays ? NAMES.spare : NAMES.clear)) continue;
      const price = priceOf(place, before, scene, at);
      if (price < least) [best, least] = [place, price];
    }
  }
  return best;
}

// Names of all points that are shown, after everything that they keep clear of has its place.
function placeNames(tops, shapes) {
  const scene = { shapes, boxes: [], leaders: [], joints: tops.map((part) => part.joint) };
  for (const { name, joint } of tops) {
    const place = chosenPlace(name, joint.places[0], joint.half, scene);
    name.choice = place;
    for (const node of [name.label, name.leader]) node.style.display = place === null ? "none" : "";
    if (place === null) continue;
    scene.boxes.push(taken([place.box.slice(0, 2), [place.box[2], place.box[1]], place.box.slice(2), [place.box[0], place.box[3]]], 0));
    if (place.leader !== null) scene.leaders.push(taken(place.leader, 0));
    set(name.label, { x: pixel(place.middle[0] + name.size.shift[0]), y: pixel(place.middle[1] + name.size.shift[1]) });
    set(name.leader, { d: place.leader === null ? null : lineThrough(place.leader) });
  }
}
