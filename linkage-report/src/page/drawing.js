// The drawing of the mechanism: its layers, and the nodes that change with position and view.

const drawing = {
  // Parts that are drawn the farthest first, and points, which are always on top.
  bodies: [],
  tops: [],
  // Gears and arrows.
  signs: [],
  // Nodes by the points' indices.
  points: new Map(),
  layers: {},
  // Functions that draw it at a row.
  placers: [],
  // Nodes over the drawing: buttons, and the scale with the directions of the axes.
  tools: [],
  marks: [],
};

function startDrawing() {
  if (!picture) return;
  byId("figure").hidden = false;
  // While a joint is dragged, the picture does not change its size.
  camera.box = before?.box ?? extent();
  makeLayers();
  makeParts();
  startGestures();
  startViews();
  startVectors();
  startMachine();
  startPhoto();
  camera.listeners.push(redraw);
  observeSize(byId("figure"), measureDrawing);
  if (before === null) measureDrawing();
  else layDrawing(before.camera);
  for (const index of picture.traces) toggleTrace(index);
  drawing.placers.push(placeParts);
  onMove(placeParts);
}

function makeLayers() {
  // Paths are above the links, which may cover all of a short one.
  for (const name of ["photo", "wheels", "bodies", "traces", "points", "signs", "vectors", "marks"]) {
    drawing.layers[name] = shape("g", { class: name });
    byId("drawing").append(drawing.layers[name]);
  }
  traces.layer = drawing.layers.traces;
}

function makeParts() {
  const guides = picture.guides.flatMap((guide, index) => guideParts(guide, index).map((part) => ownedBy(part, ["guides", index])));
  // In the plane nothing is nearer: guides, plates, their curved slots, bars, cylinders, blocks lie on each other in this order.
  const links = picture.links.map((link, index) => ownedBy(linkPart(link, index), ["links", index]));
  const ranks = [".axis", ".guide", ".slot:not(.cylinder)", ".plate", ".arc", ".bar", ".cylinder", "[data-slider]"];
  const rank = (part) => ranks.findIndex((selector) => part.node.matches(selector));
  const axes = (picture.axes ?? []).map((axis) => ownedBy(axisPart(axis), ["points", axis.point]));
  drawing.bodies = [...axes, ...guides, ...links].sort((a, b) => rank(a) - rank(b));
  picture.points.forEach((point, index) => {
    if (!isDrawn(point)) return;
    const part = ownedBy(pointPart(point, index), ["points", index]);
    drawing.tops.push(part);
    drawing.points.set(index, part.node);
  });
  drawing.layers.bodies.append(...drawing.bodies.map((part) => part.node));
  drawing.signs = signParts();
  for (const sign of drawing.signs) drawing.layers[sign.behind ? "wheels" : "signs"].append(sign.node);
  drawing.layers.points.append(...drawing.points.values());
}

function measureDrawing() {
  const { width, height } = byId("figure").getBoundingClientRect();
  if (width > 0 && height > 0) layDrawing({ width, height });
}

function layDrawing({ width, height }) {
  camera.width = width;
  camera.height = height;
  drawing.tools = [...byId("figure").querySelectorAll(".tools:not(:empty)")].map(({ offsetLeft: x, offsetTop: y, offsetWidth: w, offsetHeight: h }) =>
    taken([[x, y], [x + w, y], [x + w, y + h], [x, y + h]], 0));
  set(byId("drawing"), { viewBox: `0 0 ${width} ${height}`, width, height });
  announceCamera();
}

function redraw() {
  drawTraces();
  // Names keep clear of all the rest.
  showScale();
  placeParts(position.row);
  // When all is in sight, a finger on the drawing scrolls the page.
  byId("drawing").style.touchAction = isSpatial() || camera.zoom !== 1 ? "none" : "pan-y";
}

// The marks of the scale, and the scale in the data of the drawing.
function showScale() {
  drawMarks();
  const origin = project(Array(picture.dimension).fill(0));
  Object.assign(byId("drawing").dataset, { scale: cameraScale(), originX: origin[0], originY: origin[1] });
}

function placeParts(row) {
  const seen = drawing.bodies.filter((part) => placePart(part, row));
  const tops = drawing.tops.filter((part) => placePart(part, row));
  const signs = drawing.signs.filter((part) => placePart(part, row));
  if (isSpatial()) {
    seen.sort((a, b) => a.nearness - b.nearness);
    drawing.layers.bodies.append(...seen.map((part) => part.node));
  }
  placeNames(tops, [...[...seen, ...tops, ...signs].flatMap((part) => part.covers), ...[...traces.covers.values()].flat(), ...drawing.tools, ...drawing.marks]);
  const isThere = (part) => !part.away;
  const whole = seen.length === drawing.bodies.filter(isThere).length && tops.length === drawing.tops.filter(isThere).length;
  drawVectors(row);
  byId("impossible").hidden = whole;
  byId("impossible").textContent = whole ? "" : `Cannot be assembled at ${inputShort(input.values[row])}`;
}

function placePart(part, row) {
  part.nearness = part.away ? null : part.update(row);
  const there = part.nearness !== null;
  part.node.style.display = there ? "" : "none";
  if (there && isSpatial()) part.node.style.setProperty("--far", `${Math.round(60 * farness(part.nearness))}%`);
  return there;
}

// The scale, and in space the directions of the axes.
function drawMarks() {
  const length = roundBelow(130 / cameraScale());
  const pixels = length * cameraScale();
  const [x, y] = [16, camera.height - 14];
  const text = `${short(length)} ${picture.unit}`;
  drawing.layers.marks.replaceChildren(
    shape("path", { class: "scale", d: `M${x} ${y - 5}V${y}H${pixel(x + pixels)}V${y - 5}` }),
    shape("text", { x: pixel(x + pixels / 2), y: y - 5, "text-anchor": "middle" }, text),
  );
  drawing.marks = [taken([[x, y - 10], [x + pixels, y - 10]], 10)];
  if (isSpatial()) drawTriad([camera.width - 50, camera.height - 46]);
}

function drawTriad([x, y]) {
  drawing.marks.push(taken([[x, y]], 44));
  ["x", "y", "z"].forEach((name, i) => {
    const direction = [0, 0, 0];
    direction[i] = 1;
    const [u, v] = projectDirection(direction);
    drawing.layers.marks.append(
      shape("path", { class: "scale", d: `M${x} ${y}l${pixel(26 * u)} ${pixel(26 * v)}` }),
      shape("text", { x: pixel(x + 36 * u), y: pixel(y + 36 * v + 4), "text-anchor": "middle" }, name),
    );
  });
}
