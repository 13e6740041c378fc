// The drawing for programs that construct: DXF of release 12, true to size, as the report writes it.

// Shares of the diagonal of the box about all places: radius of joints, half the length of axes, height of letters. The half sides of a slider and
// half the width of a curved slot in radii of joints.
const DXF = { joint: 0.006, axis: 0.1, letter: 0.014, block: [4, 2.2], gap: 1.4 };
const DXF_LAYERS = { links: 7, joints: 1, paths: 5, guides: 8, gears: 3, axes: 4, names: 7 };
// Colours of parts, as many as DXF has strong ones, and the step from one to the next.
const DXF_HUES = { count: 24, next: 7 };

// All digits, and no exponent.
function dxfNumber(value) {
  const [, sign, before, after = "", power] = /^(-?)(\d+)\.?(\d*)(?:e([-+]\d+))?$/.exec(String(value));
  const text = String(value);
  if (power === undefined) return text.includes(".") ? text : `${Object.is(value, -0) ? "-0" : text}.0`;
  const all = before + after;
  const point = before.length + Number(power);
  return point <= 0 ? `${sign}0.${"0".repeat(-point)}${all}` : `${sign}${all.padEnd(point, "0")}.0`;
}

function dxfNow() {
  const row = position.row;
  const space = (place) => [place[0], place[1], place[2] ?? 0];
  const at = (index) => (placeOf(picture.points[index], row) === null ? null : space(placeOf(picture.points[index], row)));
  const way = (index) => placeOf(picture.directions[index], row);
  const [low, high] = dxfBounds(row).map(space);
  const size = Math.hypot(...minus(high, low)) || 1;
  const radius = size * DXF.joint;
  let text = "";
  const put = (code, value) => (text += `${String(code).padStart(3)}\r\n${value}\r\n`);
  const number = (code, value) => put(code, dxfNumber(value));
  const coordinates = (which, place) => [10, 20, 30].forEach((axis, k) => number(axis + which, place[k]));
  const entity = (kind, layer) => { put(0, kind); put(8, layer); };
  const line = (layer, a, b) => { entity("LINE", layer); coordinates(0, a); coordinates(1, b); };
  const circle = (layer, centre, size_) => { entity("CIRCLE", layer); coordinates(0, centre); number(40, size_); };
  const arc = (layer, centre, size_, ends) => {
    entity("ARC", layer);
    coordinates(0, centre);
    number(40, size_);
    ends.forEach((angle, k) => number(50 + k, dxfDegrees(angle)));
  };
  const words = (place, height, own) => { entity("TEXT", "names"); coordinates(0, place); number(40, height); put(1, dxfWords(own)); };
  const polyline = (layer, closed, spatial, places) => {
    entity("POLYLINE", layer);
    put(66, 1);
    coordinates(0, [0, 0, 0]);
    put(70, closed + 8 * spatial);
    for (const place of places) { entity("VERTEX", layer); coordinates(0, place); put(70, 32 * spatial); }
    entity("SEQEND", layer);
  };
  const layerOf = (layer, kind, index) => {
    const owners = partsWith(kind, index);
    return owners.length === 1 ? `part_${machine.parts[owners[0]].name}` : layer;
  };

  const note = saved.note();
  if (note) put(999, dxfWords(note));
  dxfHead({ put, number, coordinates }, [low, high], radius);
  picture.links.forEach((link, index) => {
    const layer = layerOf("links", "links", index);
    const { points, arcs } = outlineOf(link, index);
    const slots = arcs.map((guide) => arcInReport(guide, row));
    const places = points.map(at);
    if (places.includes(null) || slots.includes(null)) return;
    places.push(...slots.flatMap(arcLine).map(space));
    if (places.length === 2) line(layer, ...places);
    else if (isSpatial()) places.forEach((a, k) => places.slice(k + 1).forEach((b) => line(layer, a, b)));
    else polyline(layer, 1, 0, hull(places).map(space));
  });
  picture.guides.forEach((guide, index) => {
    const layer = layerOf("guides", "guides", index);
    const [origin, direction, slider] = [at(guide.origin), way(guide.direction), at(guide.slider)];
    if (origin === null || slider === null) return;
    if (guide.shape === "cylinder") return line(layer, origin, slider);
    if (direction === null) return;
    if (guide.shape === "arc") return arcOutline(arcInReport(guide, row), DXF.gap * radius, { circle: circle.bind(null, layer), arc: arc.bind(null, layer) });
    line(layer, ...reachInReport(guide).map((distance) => along(origin, space(direction), distance)));
    if (isSpatial()) return;
    const [half, tall] = DXF.block.map((times) => times * radius);
    const [c, s] = direction;
    polyline(layer, 1, 0, [[half, tall], [-half, tall], [-half, -tall], [half, -tall]].map(([a, b]) => [slider[0] + a * c - b * s, slider[1] + a * s + b * c, 0]));
  });
  for (const { centres, radii } of isSpatial() ? [] : picture.gears) centres.forEach((centre, k) => at(centre) && circle("gears", at(centre), radii[k]));
  for (const axis of picture.axes ?? []) {
    const [point, direction] = [at(axis.point), way(axis.direction)];
    if (point !== null && direction !== null) line("axes", ...[-1, 1].map((end) => along(point, direction, end * size * DXF.axis)));
  }
  for (const index of traces.paths.keys()) {
    const pieces = [[]];
    eachRow((own) => {
      const place = placeOf(picture.points[index], own);
      if (place === null) pieces.push([]);
      else pieces.at(-1).push(space(place));
    });
    for (const piece of pieces.filter(({ length }) => length > 1)) polyline("paths", 0, Number(isSpatial()), piece);
  }
  for (const index of drawnPoints()) {
    const place = at(index);
    if (place === null) continue;
    const { name, kind } = picture.points[index];
    const layer = layerOf("joints", "points", index);
    entity("POINT", layer);
    coordinates(0, place);
    if (!isSpatial() && (kind === "ground" || kind === "joint")) circle(layer, place, radius);
    words([place[0] + 1.5 * radius, place[1] + 1.5 * radius, place[2]], size * DXF.letter, name);
  }
  const foot = (k) => [low[0], low[1] - k * size * DXF.letter, low[2]];
  words(foot(4), size * DXF.letter, `${input.name} = ${inputShort(input.values[row])}, lengths in ${picture.unit}`);
  if (note) words(foot(6), size * DXF.letter, note);
  put(0, "ENDSEC");
  put(0, "EOF");
  return text;
}

// A curved slot as the frame sees it.
function arcInReport({ origin, direction, slider }, row) {
  const places = (own) => [picture.points[origin], picture.directions[direction], picture.points[slider]].map((item) => placeOf(item, own));
  return arcFrom(places(row), swingOf(input.values.map((_, own) => arcAngle(places(own)))));
}

// Two concentric arcs with round ends; two circles for a ring.
function arcOutline(slot, half, { circle, arc }) {
  const centre = [...slot.centre, 0];
  const sides = [slot.radius - half, slot.radius + half];
  if (slot.span >= 2 * Math.PI) return sides.forEach((radius) => circle(centre, radius));
  const ends = [slot.start, slot.start + slot.span];
  const angles = ends.map((angle) => (angle * 180) / Math.PI);
  for (const radius of sides) arc(centre, radius, angles);
  ends.forEach((end, k) => {
    const start = angles[k] + (k === 0 ? 180 : 0);
    arc([...arcAt(slot, slot.radius, end), 0], half, [start, start + 180]);
  });
}

// The same angle from 0 to 360 degrees, to a billionth: elementary functions differ in last digits.
function dxfDegrees(angle) {
  return Math.round((((angle % 360) + 360) % 360) * 1e9) / 1e9;
}

// Everything before the entities.
function dxfHead({ put, number, coordinates }, [low, high], radius) {
  const layers = [...Object.entries(DXF_LAYERS), ...machine.parts.map(({ name }, index) => [`part_${name}`, 10 * (((index * DXF_HUES.next) % DXF_HUES.count) + 1)])];
  const all = (...pairs) => pairs.forEach(([code, value]) => put(code, value));
  all([0, "SECTION"], [2, "HEADER"], [9, "$ACADVER"], [1, "AC1009"], [9, "$EXTMIN"]);
  coordinates(0, low);
  put(9, "$EXTMAX");
  coordinates(0, high);
  all([9, "$PDMODE"], [70, 32], [9, "$PDSIZE"]);
  number(40, 2 * radius);
  all([0, "ENDSEC"], [0, "SECTION"], [2, "TABLES"], [0, "TABLE"], [2, "LTYPE"], [70, 1], [0, "LTYPE"], [2, "CONTINUOUS"], [70, 0], [3, "Solid line"], [72, 65], [73, 0]);
  number(40, 0);
  all([0, "ENDTAB"], [0, "TABLE"], [2, "LAYER"], [70, layers.length]);
  for (const [name, colour] of layers) all([0, "LAYER"], [2, name], [70, 0], [62, colour], [6, "CONTINUOUS"]);
  all([0, "ENDTAB"], [0, "ENDSEC"], [0, "SECTION"], [2, "ENTITIES"]);
}

// The box about all places of points, and the gears as they are.
function dxfBounds(row) {
  const places = drawnPoints().flatMap((index) => input.values.map((_, own) => placeOf(picture.points[index], own)).filter((place) => place !== null));
  for (const { centres, radii } of isSpatial() ? [] : picture.gears) {
    centres.forEach((centre, k) => {
      const place = placeOf(picture.points[centre], row);
      if (place !== null) places.push(...[-1, 1].map((side) => place.map((x) => x + side * radii[k])));
    });
  }
  return [Math.min, Math.max].map((pick) => Array.from({ length: picture.dimension }, (_, i) => places.reduce((end, place) => pick(end, place[i]), places[0][i])));
}

// The range of the slider, up to the origin where the line belongs to a link that has it. It is what the frame sees, whoever stands on a link.
function reachInReport(guide) {
  const distances = input.values.flatMap((_, row) => {
    const [origin, direction, slider] = [picture.points[guide.origin], picture.directions[guide.direction], picture.points[guide.slider]].map((own) => placeOf(own, row));
    return origin === null || direction === null || slider === null ? [] : [dot(minus(slider, origin), direction)];
  });
  const hasOrigin = guide.on === "itself" || picture.links[guide.on]?.points.includes(guide.origin);
  const [first, ...others] = hasOrigin ? [0, ...distances] : distances;
  return [Math.min, Math.max].map((pick) => others.reduce((end, own) => pick(end, own), first));
}

// Letters beyond ASCII by their numbers.
function dxfWords(text) {
  return text.replace(/[^ -~]/g, (unit) => `\\U+${unit.charCodeAt(0).toString(16).toUpperCase().padStart(4, "0")}`);
}
