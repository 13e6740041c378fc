// Signs next to links and points, as drawings on paper have them: gears, arrows at driven links,
// joints in space.

// Radius of the arrow about a driven pivot; where on its circle it begins and ends, seen from the link; its pieces.
const DRIVE = { radius: 25, from: 0.35, to: 1.75, pieces: 12, push: 19, beside: 17 };
const HEAD = { length: 9, half: 3.6 };
// Half the length and half the height of bars; the radius of a ring.
const BARS = { sleeve: [11, 5], "long sleeve": [19, 5], line: [15, 0] };
const RING = 8.5;
// Distance from the contact of wheels to the middle of their ratio, which is in the larger one or
// outside of both, and half its width.
const RATIO = { aside: 32, half: 24 };

function signParts() {
  return [
    ...picture.gears.flatMap((gear) => [gearPart(gear), ratioPart(gear)].map((part) => ownedBy(part, ...gear.centres.map((centre) => ["points", centre])))),
    ...picture.drives.map((drive) => ownedBy(drivePart(drive), ownersOfDrive(drive))),
  ];
}

// Pitch circles, and the belt that joins wheels.
function gearPart({ centres, radii, ratio, belt }) {
  const wheels = radii.map(() => shape("circle", { class: "wheel" }));
  const line = shape("path", { class: "belt" });
  const words = `${belt ? "belt" : "gears"} 1 : ${short(ratio)}`;
  const node = shape("g", { class: "gear" }, shape("title", {}, words), ...wheels, line);
  return {
    node,
    behind: true,
    update(row) {
      const places = centres.map((centre) => pointAt(centre, row));
      if (places.includes(null)) return null;
      const [a, b] = places.map(project);
      const sizes = radii.map((radius) => radius * cameraScale());
      wheels.forEach((wheel, i) => set(wheel, { cx: pixel([a, b][i][0]), cy: pixel([a, b][i][1]), r: pixel(sizes[i]) }));
      set(line, { d: belt ? beltOutline(a, b, sizes) : null });
      // Names are legible on wheels.
      this.covers = [];
      return meanNearness([a, b]);
    },
  };
}

// The turns of the second wheel for one turn of the first.
function ratioPart({ centres, radii, ratio, belt }) {
  const node = shape("text", { class: "ratio", "text-anchor": "middle" }, `1 : ${short(ratio)}`);
  return {
    node,
    update(row) {
      const places = centres.map((centre) => pointAt(centre, row));
      if (places.includes(null)) return null;
      const [a, b] = places.map(project);
      const apart = distance(a, b) || 1;
      const [first, second] = radii.map((radius) => radius * cameraScale());
      const larger = second > first ? 1 : -1;
      // Between the wheels of a belt there is room. The ratio is outside if one wheel is within the other.
      const between = first + 0.5 * (apart - first - second);
      const touching = ratio < 0 ? first + RATIO.aside * larger : -larger * (first + RATIO.aside);
      const at = belt ? between : touching;
      const [x, y] = [0, 1].map((i) => a[i] + (at * (b[i] - a[i])) / apart);
      set(node, { x: pixel(x), y: pixel(y + 4) });
      this.covers = [taken([[x - RATIO.half, y], [x + RATIO.half, y]], 8)];
      return 0;
    },
  };
}

// Both outer tangents.
function beltOutline(a, b, [first, second]) {
  const apart = distance(a, b) || 1;
  const way = [0, 1].map((i) => (b[i] - a[i]) / apart);
  const lean = (first - second) / apart;
  const across = Math.sqrt(Math.max(0, 1 - lean * lean));
  const touch = (at, radius, side) => [
    at[0] + radius * (lean * way[0] + side * across * way[1]),
    at[1] + radius * (lean * way[1] - side * across * way[0]),
  ];
  return [1, -1].map((side) => lineThrough([touch(a, first, side), touch(b, second, side)])).join("");
}

// An arrow the way it goes when the input grows.
function drivePart({ turn, slide }) {
  const line = shape("path", { class: "line" });
  const head = shape("path", { class: "head" });
  const node = shape("g", { class: "drive" }, shape("title", {}, `moved by ${input.name}`), line, head);
  return {
    node,
    drive: true,
    update(row) {
      const places = turn ? driveArc(turn, row) : driveLine(picture.guides[slide], row);
      if (places === null) return null;
      const [from, to] = places.slice(-2);
      const length = distance(from, to) || 1;
      const [u, v] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
      const corner = (side) => [to[0] - HEAD.length * u - side * HEAD.half * v, to[1] - HEAD.length * v + side * HEAD.half * u];
      set(line, { d: lineThrough(places) });
      set(head, { d: `${lineThrough([to, corner(1), corner(-1)])}Z` });
      this.covers = places.slice(1).map((place, i) => taken([places[i], place], HEAD.half));
      return 0;
    },
  };
}

function driveArc([centre, end], row) {
  const angle = (at) => {
    const [from, to] = [pointAt(centre, at), pointAt(end, at)];
    if (from === null || to === null) return null;
    const [a, b] = [project(from), project(to)];
    return Math.atan2(b[1] - a[1], b[0] - a[0]);
  };
  const start = angle(row);
  if (start === null) return null;
  const turned = growth(row, (at) => angle(at), (change) => change - 2 * Math.PI * Math.round(change / (2 * Math.PI)));
  // Downwards is positive on the screen, so to the left is negative; to the left it goes unless rows say something else.
  const sense = turned > 0 ? 1 : -1;
  const [x, y] = project(pointAt(centre, row));
  return Array.from({ length: DRIVE.pieces + 1 }, (_, n) => {
    const at = start + sense * (DRIVE.from + (n / DRIVE.pieces) * (DRIVE.to - DRIVE.from));
    return [x + DRIVE.radius * Math.cos(at), y + DRIVE.radius * Math.sin(at)];
  });
}

function driveLine(guide, row) {
  const [, direction, slider] = guidePlaces(guide, row);
  if (direction === null || slider === null) return null;
  const [u, v] = projectDirection(direction);
  const length = Math.hypot(u, v);
  // Seen from its end it goes nowhere.
  if (!(length > 1e-6)) return null;
  const [c, s] = [u / length, v / length];
  const [x, y] = project(slider);
  return [-1, 1].map((end) => [x + end * DRIVE.push * c + DRIVE.beside * s, y + end * DRIVE.push * s - DRIVE.beside * c]);
}

// The change of a value to the next row, or from the one before. Rows of a falling input have the
// other sign.
function growth(row, value, wrapped) {
  const [from, to] = row + 1 < rowCount ? [row, row + 1] : [Math.max(0, row - 1), row];
  const [before, after] = [value(from), value(to)];
  if (before === null || after === null) return 0;
  return wrapped(after - before) * (span() < 0 ? -1 : 1);
}

// The signs around the mark of a joint in space; none in the plane, where all joints are pins and
// blocks.
function jointSigns(index) {
  const joints = isSpatial() ? picture.joints.filter((joint) => joint.point === index) : [];
  return joints.filter((joint) => JOINT_SIGNS[joint.shape].drawn).map((joint) => jointSign(joint));
}

function jointSign(joint) {
  const { ring, directions, bar } = JOINT_SIGNS[joint.shape];
  const bars = shape("path", { class: bar === "line" ? "cross" : "sleeve" });
  const socket = shape("circle", { class: "socket", r: RING });
  const node = shape("g", { class: joint.shape, "data-joint": joint.shape }, ...(ring ? [socket] : []), ...(directions === "none" ? [] : [bars]));
  const update = (at, row) => {
    set(socket, { cx: pixel(at[0]), cy: pixel(at[1]) });
    const ways = waysOf(joint, row).map(projectDirection);
    const [half, thick] = BARS[bar];
    const shapes = ways.map((way) => block(at, way, half, thick));
    set(bars, { d: shapes.map((corners) => `${lineThrough(corners)}Z`).join("") });
    const around = ring ? [taken([at.slice(0, 2)], RING + 1)] : [];
    return [...around, ...shapes.map((corners) => taken(corners, 1))];
  };
  return { node, update };
}

// The directions of the bars of a sign.
function waysOf({ point, shape: kind }, row) {
  const { directions } = JOINT_SIGNS[kind];
  if (directions === "none") return [];
  const axes = picture.axes.filter((axis) => axis.point === point).map((axis) => directionAt(axis.direction, row));
  const lines = picture.guides.filter((guide) => guide.slider === point).map((guide) => directionAt(guide.direction, row));
  const found = (directions === "guide" ? [...lines, ...axes] : axes).filter((way) => way !== null);
  return directions === "first axis" || directions === "guide" ? found.slice(0, 1) : directions === "all axes" ? found : [];
}

// Returns true if all joints in a point slide and none turns.
function onlySlides(index) {
  const joints = picture.joints.filter((joint) => joint.point === index);
  return joints.length > 0 && joints.every((joint) => !JOINT_SIGNS[joint.shape].turns);
}

// Returns true for a filled mark of a point, as a ball in its socket.
function isFilled(index) {
  return isSpatial() && picture.joints.some((joint) => joint.point === index && JOINT_SIGNS[joint.shape].filled);
}
