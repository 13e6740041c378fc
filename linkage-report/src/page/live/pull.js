// Pivots and lengths of bars, pulled in the drawing: which dimension they are is asked of the programs.

// Dimensions are changed by this part of the largest one to see their effect; a point that moves as
// far counts as the dimension itself within the second.
const TRIAL = 1e-6;
const LIKE = 1e-4;

const pulling = { change: null, pointer: null };

function startPulling() {
  if (!picture) return;
  const view = byId("drawing");
  // Before whatever else a press means.
  view.addEventListener("pointerdown", pullPressed, { capture: true });
  view.addEventListener("pointermove", pullMoved, { capture: true });
  for (const end of ["pointerup", "pointercancel"]) view.addEventListener(end, pullEnded, { capture: true });
}

// The places of all points of the picture at a row with other dimensions; null where the mechanism cannot be assembled.
function placesWith(dimensions, row) {
  const { table, first } = report.live.picture;
  const own = live.tables[table];
  if (own.why !== null) return null;
  try {
    const assemblies = assembledWith(dimensions, live.assemblies);
    const out = new Float64Array(own.fn.columns.length);
    engine.evaluate(assemblies[own.number], own.fn, argumentsAt(own.names)(row), out);
    const size = picture.dimension;
    return picture.points.map((_, k) => [...out.subarray(first + k * size, first + (k + 1) * size)]);
  } catch (thrown) {
    if (thrown instanceof engine.AssemblyError) return null;
    throw thrown;
  }
}

// For each length: how all points move with it, over its change.
function motions(row) {
  const here = placesWith(live.dimensions, row);
  if (here === null) return [];
  const step = TRIAL * largestDimension(picture.unit);
  const lengths = report.dimensions.filter(({ unit }) => unit === picture.unit);
  const all = lengths.map(({ name }) => {
    const there = placesWith(new Map([...live.dimensions, [name, live.dimensions.get(name) + step]]), row);
    return there && { name, places: there.map((place, k) => minus(place, here[k]).map((x) => x / step)), here };
  });
  return all.filter((own) => own !== null);
}

// The dimensions that pulling at a pivot changes: those that move it along one axis each, in the
// sense of their growth.
function pivotChange(index, row) {
  const found = [];
  for (const { name, places } of motions(row)) {
    const axis = places[index].findIndex((x) => Math.abs(Math.abs(x) - 1) < LIKE);
    const others = places[index].filter((x, k) => k !== axis && Math.abs(x) > LIKE);
    if (axis < 0 || others.length > 0 || found.some((own) => own.axis === axis)) continue;
    found.push({ name, axis, sign: Math.sign(places[index][axis]), from: live.dimensions.get(name) });
  }
  if (found.length === 0) return null;
  return (moved) => new Map(found.map(({ name, axis, sign, from }) => [name, from + sign * moved[axis]]));
}

// The dimension that pulling at a bar changes: the one that is its length.
function lengthChange(link, row) {
  const [a, b] = link.points;
  const growth = ({ places, here }) => {
    const along = minus(here[b], here[a]);
    const length = Math.hypot(...along);
    return dot(minus(places[b], places[a]), along) / length;
  };
  const own = motions(row).filter((motion) => Math.abs(growth(motion)) > LIKE);
  if (own.length !== 1 || Math.abs(growth(own[0]) - 1) > LIKE) return null;
  const [{ name, here }] = own;
  const from = live.dimensions.get(name);
  const along = minus(here[b], here[a]);
  const length = Math.hypot(...along);
  // Outwards from the middle of the bar on both sides.
  return (moved, pressed) => {
    const middle = here[a].map((x, k) => (x + here[b][k]) / 2);
    const side = dot(minus(pressed, middle), along) < 0 ? -1 : 1;
    return new Map([[name, from + (side * dot(moved, along)) / length]]);
  };
}

function pullPressed(event) {
  if (event.button !== 0 || isStanding()) return;
  const row = position.row;
  const pivot = event.target.closest(".point.ground");
  const bar = event.target.closest(".link.bar");
  let make = null;
  if (pivot !== null) make = pivotChange(picture.points.findIndex(({ name }) => name === pivot.dataset.point), row);
  else if (bar !== null) make = lengthChange(picture.links.find(({ name }) => name === bar.dataset.link), row);
  if (make === null) return;
  setPlaying(false);
  pulling.change = make;
  pulling.pressed = placeUnder(onDrawing(event));
  pulling.start = onDrawing(event);
  pulling.pointer = event.pointerId;
  pulling.moved = false;
}

function pullMoved(event) {
  if (pulling.change === null || event.pointerId !== pulling.pointer) return;
  if (!pulling.moved && distance(onDrawing(event), pulling.start) < DRAG) return;
  if (!pulling.moved) byId("drawing").setPointerCapture(event.pointerId);
  pulling.moved = true;
  event.stopPropagation();
  const { change: make, pressed } = pulling;
  const now = placeUnder(onDrawing(event));
  const step = event.shiftKey ? null : stepOfPixel(1 / cameraScale());
  whenDrawn(() => {
    const pulled = [...make(minus(now, pressed), pressed)].map(([name, value]) => [name, toStep(value, step)]);
    tell(change(new Map(pulled), stopAtStep(pulled.map(([name]) => name), step)));
  });
}

function pullEnded(event) {
  if (pulling.change === null || event.pointerId !== pulling.pointer) return;
  pulling.change = null;
  if (!pulling.moved) return;
  drawNow();
  keepStep();
}
