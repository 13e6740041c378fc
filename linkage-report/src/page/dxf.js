// The drawing as DXF of release 12 at the current position, true to size, as `drawing.dxf` has it.

const DXF_LAYERS = [["links", 7], ["joints", 1], ["paths", 5], ["guides", 8], ["gears", 3], ["axes", 4], ["names", 7]];
// Shares of the diagonal of the box about all places: joints, half an axis, letters.
const DXF_SHARES = { joint: 0.006, axis: 0.1, letter: 0.014 };
// Half the length and the height of a slider, in radii of joints.
const DXF_BLOCK = [4, 2.2];
// The 24 strong colours of DXF are ten apart; parts next to each other differ much.
const DXF_HUES = { count: 24, next: 7 };

// All digits without an exponent, which some programs do not read.
function dxfNumber(value) {
  const text = String(value);
  const plain = text.includes("e") ? value.toFixed(20) : text;
  return plain.includes(".") ? plain : `${plain}.0`;
}

// Letters beyond ASCII by their numbers.
function dxfWords(words) {
  const number = (letter) => `\\U+${letter.charCodeAt(0).toString(16).toUpperCase().padStart(4, "0")}`;
  return words.replace(/[^ -~]/g, number);
}

function dxfText() {
  const { row } = position;
  const lines = [];
  const put = (code, value) => lines.push(String(code).padStart(3), value);
  const at = (place, which = 0) => [0, 1, 2].forEach((axis) => put(10 * (axis + 1) + which, dxfNumber(place[axis] ?? 0)));
  const entity = (kind, layer) => [put(0, kind), put(8, layer)];
  const line = (layer, from, to) => [entity("LINE", layer), at(from), at(to, 1)];
  const circle = (layer, centre, radius) => [entity("CIRCLE", layer), at(centre), put(40, dxfNumber(radius))];
  const text = (place, words) => [entity("TEXT", "names"), at(place), put(40, dxfNumber(size * DXF_SHARES.letter)), put(1, dxfWords(words))];
  const polyline = (layer, closed, spatial, places) => {
    entity("POLYLINE", layer);
    put(66, 1);
    at([0, 0, 0]);
    put(70, (closed ? 1 : 0) + (spatial ? 8 : 0));
    for (const place of places) [entity("VERTEX", layer), at(place), put(70, spatial ? 32 : 0)];
    entity("SEQEND", layer);
  };
  const place = (index, when = row) => placeOf(picture.points[index], when);
  const isKnown = (places) => !places.includes(null);
  const gears = picture.dimension === 2 ? picture.gears.flatMap(({ centres, radii }) => centres.map((centre, wheel) => [place(centre), radii[wheel]])) : [];
  const circles = gears.filter(([centre]) => centre !== null);
  const [low, high] = dxfBox(circles);
  const size = Math.hypot(...minus(high, low)) || 1;
  const joint = size * DXF_SHARES.joint;
  // The layer of an item that belongs to one part alone, or that of its kind.
  const parts = picture.parts ?? [];
  const layerOf = (kind, items, index) => {
    const owners = parts.filter((part) => part[items].includes(index));
    return owners.length === 1 ? `part_${owners[0].name}` : kind;
  };
  const section = (name) => [put(0, "SECTION"), put(2, name)];
  const layers = [...DXF_LAYERS, ...parts.map(({ name }, index) => [`part_${name}`, 10 * (((index * DXF_HUES.next) % DXF_HUES.count) + 1)])];

  section("HEADER");
  [put(9, "$ACADVER"), put(1, "AC1009"), put(9, "$EXTMIN"), at(low), put(9, "$EXTMAX"), at(high)];
  [put(9, "$PDMODE"), put(70, 32), put(9, "$PDSIZE"), put(40, dxfNumber(2 * joint)), put(0, "ENDSEC")];
  section("TABLES");
  [put(0, "TABLE"), put(2, "LTYPE"), put(70, 1), put(0, "LTYPE"), put(2, "CONTINUOUS"), put(70, 0), put(3, "Solid line"), put(72, 65), put(73, 0), put(40, "0.0"), put(0, "ENDTAB")];
  [put(0, "TABLE"), put(2, "LAYER"), put(70, layers.length)];
  for (const [name, colour] of layers) [put(0, "LAYER"), put(2, name), put(70, 0), put(62, colour), put(6, "CONTINUOUS")];
  [put(0, "ENDTAB"), put(0, "ENDSEC")];
  section("ENTITIES");
  picture.links.forEach(({ points }, index) => {
    const layer = layerOf("links", "links", index);
    const places = points.map((point) => place(point));
    if (!isKnown(places)) return;
    if (places.length > 2 && !isSpatial()) polyline(layer, true, false, hull(places));
    else places.forEach((from, k) => places.slice(k + 1).forEach((to) => line(layer, from, to)));
  });
  picture.guides.forEach((guide, index) => {
    const layer = layerOf("guides", "guides", index);
    const [origin, slider] = [place(guide.origin), place(guide.slider)];
    const direction = placeOf(picture.directions[guide.direction], row);
    if (!isKnown([origin, slider, direction])) return;
    if (guide.shape === "cylinder") return void line(layer, origin, slider);
    const [first, last] = reachOf(guide);
    const fromOrigin = guide.on === "itself" || (guide.on !== "frame" && picture.links[guide.on].points.includes(guide.origin));
    const ends = fromOrigin ? [Math.min(0, first), Math.max(0, last)] : [first, last];
    line(layer, ...ends.map((way) => along(origin, direction, way)));
    if (isSpatial()) return;
    const [half, tall] = DXF_BLOCK.map((times) => times * joint);
    const across = [-direction[1], direction[0]];
    const corners = [[half, tall], [-half, tall], [-half, -tall], [half, -tall]];
    polyline(layer, true, false, corners.map(([a, b]) => along(along(slider, direction, a), across, b)));
  });
  for (const [centre, radius] of circles) circle("gears", centre, radius);
  for (const axis of picture.axes) {
    const [point, direction] = [place(axis.point), placeOf(picture.directions[axis.direction], row)];
    if (isKnown([point, direction])) line("axes", along(point, direction, -size * DXF_SHARES.axis), along(point, direction, size * DXF_SHARES.axis));
  }
  for (const index of traces.paths.keys()) {
    let piece = [];
    for (let when = 0; when <= rowCount; when += 1) {
      const here = when < rowCount ? place(index, when) : null;
      if (here !== null) piece.push(here);
      else {
        if (piece.length > 1) polyline("paths", false, isSpatial(), piece);
        piece = [];
      }
    }
  }
  for (const index of drawnPoints()) {
    const [{ name, kind }, here] = [picture.points[index], place(index)];
    if (here === null) continue;
    const layer = layerOf("joints", "points", index);
    [entity("POINT", layer), at(here)];
    if (!isSpatial() && (kind === "ground" || kind === "joint")) circle(layer, here, joint);
    text(here.map((component, axis) => component + (axis < 2 ? 1.5 * joint : 0)), name);
  }
  const caption = [`${input.name} = ${inputShort(input.values[row])}, lengths in ${picture.unit}`, ...dxfChanges()];
  caption.forEach((words, k) => text([low[0], low[1] - (4 + 2 * k) * size * DXF_SHARES.letter, low[2] ?? 0], words));
  [put(0, "ENDSEC"), put(0, "EOF")];
  return lines.map((value) => `${value}\r\n`).join("");
}

// The box about all places of points, and the gears where they are.
function dxfBox(circles) {
  const [low, high] = [Array(picture.dimension).fill(Infinity), Array(picture.dimension).fill(-Infinity)];
  const take = (place, radius) => place.forEach((component, axis) => {
    low[axis] = Math.min(low[axis], component - radius);
    high[axis] = Math.max(high[axis], component + radius);
  });
  for (const index of drawnPoints()) eachRow((row) => take(placeOf(picture.points[index], row) ?? [], 0));
  for (const [centre, radius] of circles) take(centre, radius);
  return [low, high];
}

// A line for the dimensions that are not those of the report.
function dxfChanges() {
  if (!report.live || !isChanged()) return [];
  const changes = changedOnes().map(([name, value]) => `${name} = ${digits(value)} (${digits(valueInReport(name))})`);
  return [`changed: ${changes.join(", ") || "the assembly"}`];
}
