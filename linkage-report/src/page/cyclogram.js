// The cyclogram: motions of all organs over the angle of the shaft, with a line at the current
// position.

const CYCLE = { row: 42, stroke: 26, top: 10, bottom: 36, right: 16, letter: 7, angle: 40 };

const cycle = { organs: report.cyclogram?.organs ?? [], view: null, shaft: null, scale: null, pressed: false };

// An angle of the shaft within the cycle.
function withinCycle(angle) {
  const { from, to } = report.cyclogram;
  const turns = Math.floor((angle - from) / (to - from));
  return angle >= from && angle <= to ? angle : angle - turns * (to - from);
}

function cycleScale(width) {
  const { from, to } = report.cyclogram;
  const longest = Math.max(...cycle.organs.map(({ name }) => name.length));
  const left = Math.min(0.34 * width, Math.max(40, 12 + CYCLE.letter * longest));
  const wide = Math.max(40, width - left - CYCLE.right);
  return { left, wide, x: (angle) => left + (wide * (angle - from)) / (to - from), angle: (x) => from + ((x - left) / wide) * (to - from) };
}

function drawCyclogram() {
  const width = byId("cyclogram").clientWidth;
  if (!(width > 0)) return;
  const bottom = CYCLE.top + CYCLE.row * cycle.organs.length;
  cycle.scale = { ...cycleScale(width), bottom };
  set(cycle.view, { width, height: bottom + CYCLE.bottom, viewBox: `0 0 ${width} ${bottom + CYCLE.bottom}` });
  cycle.shaft = shape("g", { class: "shaft" }, shape("path", { class: "line" }), shape("path", { class: "head" }));
  cycle.view.replaceChildren(cycleAxis(), ...cycle.organs.map(organRow), cycle.shaft);
  fadeOrgans();
  moveShaft(position.row);
}

function cycleAxis() {
  const { left, wide, x, bottom } = cycle.scale;
  const { from, to } = report.cyclogram;
  const marks = ticks(toDegrees(from), toDegrees(to), wide / 56, "deg").flatMap((tick) => {
    const place = pixel(x(fromPlot(tick, "rad")));
    return [shape("path", { class: "grid", d: `M${place} ${CYCLE.top - 4}V${bottom + 4}` }),
      shape("text", { x: place, y: bottom + 16, "text-anchor": "middle" }, digits(tick))];
  });
  const title = shape("text", { class: "title", x: left + wide / 2, y: bottom + 32, "text-anchor": "middle" }, titled(input.name, "deg"));
  return shape("g", { class: "axes" }, ...marks, title);
}

function organRow(organ, index) {
  const top = CYCLE.top + CYCLE.row * index;
  const { left, x } = cycle.scale;
  const height = (value) => top + (CYCLE.stroke * (organ.highest - value)) / (organ.highest - organ.lowest);
  const pieces = organ.intervals.flatMap((interval, k) => {
    const ends = [k, (k + 1) % organ.events.length].map((event) => height(organ.events[event].value));
    return piecesOf(interval, ends).flatMap(([span, levels]) => organPiece(interval.motion, span.map(x), levels, top));
  });
  const name = shape("text", { class: "name", x: left - 8, y: top + CYCLE.stroke / 2 + 4, "text-anchor": "end" }, organ.name);
  return shape("g", { class: "organ", "data-organ": organ.name, style: `--colour: ${linkColour(organ.colour)}` }, name, ...pieces, ...organAngles(organ, top));
}

// An interval as it is drawn, angles with levels: in two pieces if it goes across the seam.
function piecesOf({ from, range }, [a, b]) {
  const { from: low, to: high } = report.cyclogram;
  if (from + range <= high) return [[[from, from + range], [a, b]]];
  const seam = a + ((b - a) * (high - from)) / range;
  return [[[from, high], [a, seam]], [[low, from + range - (high - low)], [seam, b]]];
}

function organPiece(motion, [left, right], levels, top) {
  const dwell = motion === "dwell";
  const line = shape("path", { class: dwell ? "line dwells" : "line", d: lineThrough([[left, levels[0]], [right, levels[1]]]) });
  if (!dwell) return [line];
  return [shape("rect", { class: "dwell", x: pixel(left), y: top, width: pixel(right - left), height: CYCLE.stroke }), line];
}

// Those that have room; all stand in the table.
function organAngles(organ, top) {
  let free = -Infinity;
  return organ.events.flatMap(({ at }) => {
    const place = cycle.scale.x(at);
    const mark = shape("path", { class: "event", d: `M${pixel(place)} ${top}v${CYCLE.stroke + 3}` });
    if (place - free < CYCLE.angle) return [mark];
    free = place;
    return [mark, shape("text", { class: "angle", x: pixel(place), y: top + CYCLE.stroke + 13, "text-anchor": "middle" }, toDegrees(at).toFixed(1))];
  });
}

function moveShaft(row) {
  if (cycle.scale === null) return;
  const x = pixel(cycle.scale.x(withinCycle(input.values[row])));
  set(cycle.shaft.firstChild, { d: `M${x} ${CYCLE.top - 4}V${cycle.scale.bottom}` });
  set(cycle.shaft.lastChild, { d: `M${x} ${CYCLE.top - 3}l-5 -7h10z` });
  set(cycle.shaft, { "data-angle": withinCycle(input.values[row]) });
}

// The row whose angle of the shaft is nearest to the pointer.
function goToShaft(event) {
  setPlaying(false);
  const { from, to } = report.cyclogram;
  const angle = Math.min(to, Math.max(from, cycle.scale.angle(event.clientX - cycle.view.getBoundingClientRect().left)));
  const away = (row) => Math.abs(withinCycle(input.values[row]) - angle);
  let best = 0;
  for (let row = 1; row < rowCount; row += 1) if (away(row) < away(best)) best = row;
  moveTo(best);
}

// Organs of parts that are hidden.
function fadeOrgans() {
  const isOff = ({ name }) => machine.parts.some((part, index) => part.name === name.split(".")[0] && machine.hidden.has(index));
  cycle.organs.forEach((organ, index) => cycle.view?.querySelectorAll(".organ")[index]?.classList.toggle("off", isOff(organ)));
}

function startCyclogram() {
  if (cycle.organs.length === 0) return;
  const names = cycle.organs.map(({ name }) => name).join(", ");
  cycle.view = shape("svg", { role: "img", "aria-label": `Cyclogram of ${names} over ${input.name}; the table has its angles` });
  cycle.view.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    cycle.pressed = true;
    cycle.view.setPointerCapture(event.pointerId);
    goToShaft(event);
  });
  cycle.view.addEventListener("pointermove", (event) => cycle.pressed && goToShaft(event));
  for (const end of ["pointerup", "pointercancel"]) cycle.view.addEventListener(end, () => { cycle.pressed = false; });
  byId("cyclogram").hidden = false;
  byId("stage").classList.add("cyclic");
  byId("cyclogram").prepend(cycle.view);
  observeSize(byId("cyclogram"), drawCyclogram);
  drawCyclogram();
  onMove(moveShaft);
}

function cyclogramPage() {
  const { backgroundColor } = getComputedStyle(document.body);
  const [width, height] = ["width", "height"].map((side) => Number(cycle.view.getAttribute(side)));
  return picturePage(width, height, backgroundColor, standing(cycle.view));
}
