// Dragging, wheel and pinching on the drawing, and its buttons. Who drags at a point moves the mechanism, elsewhere the view.

// Pixels after which a press is a drag and no click on a point.
const DRAG = 4;

const fingers = { places: new Map(), start: null, dragging: false };

function startGestures() {
  const view = byId("drawing");
  view.addEventListener("pointerdown", pressed);
  view.addEventListener("pointermove", dragged);
  for (const end of ["pointerup", "pointercancel"]) view.addEventListener(end, released);
  view.addEventListener("pointermove", (event) => event.pointerType === "mouse" && pointOut(event.buttons ? null : onDrawing(event)));
  view.addEventListener("pointerleave", () => pointOut(null));
  // A finger on a moving part does not scroll the page.
  view.addEventListener("touchmove", (event) => grip.places !== null && event.cancelable && event.preventDefault(), { passive: false });
  startStack();
  view.addEventListener("wheel", wheeled, { passive: false });
}

function onDrawing(event) {
  const { left, top } = byId("drawing").getBoundingClientRect();
  return [event.clientX - left, event.clientY - top];
}

function pressed(event) {
  if (event.button !== 0) return;
  fingers.places.set(event.pointerId, onDrawing(event));
  fingers.start = onDrawing(event);
  fingers.dragging = false;
  if (fingers.places.size === 1) takeHold(fingers.start);
  else letGo();
}

function dragged(event) {
  const before = fingers.places.get(event.pointerId);
  if (!before) return;
  const now = onDrawing(event);
  if (!fingers.dragging && distance(now, fingers.start) < DRAG) return;
  if (!fingers.dragging) event.currentTarget.setPointerCapture(event.pointerId);
  fingers.dragging = true;
  const other = [...fingers.places].find(([id]) => id !== event.pointerId);
  fingers.places.set(event.pointerId, now);
  const moved = [now[0] - before[0], now[1] - before[1]];
  if (other) pinch(before, now, other[1]);
  else if (grip.places !== null) pull(now);
  else if (isSpatial() && !event.shiftKey) turnBy(...moved);
  else panBy(...moved);
}

function pinch(before, now, other) {
  panBy((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
  zoomBy(distance(now, other) / Math.max(1, distance(before, other)), [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
}

function released(event) {
  fingers.places.delete(event.pointerId);
  letGo();
}

function wheeled(event) {
  event.preventDefault();
  zoomBy(Math.exp(-0.0015 * event.deltaY), onDrawing(event));
}

function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

function startViews() {
  byId("nearer").addEventListener("click", () => zoomBy(1.25));
  byId("farther").addEventListener("click", () => zoomBy(0.8));
  byId("fit").addEventListener("click", fitAll);
  const names = byId("names");
  names.addEventListener("click", () => {
    const shown = byId("figure").classList.toggle("named");
    names.setAttribute("aria-pressed", shown);
  });
  byId("hint").textContent = isSpatial()
    ? "Drag a joint to move the mechanism. Drag elsewhere to turn it, with shift to shift it; wheel or pinch for the size. Click a point to trace it."
    : "Drag a joint to move the mechanism, elsewhere to shift it; wheel or pinch for the size. Click a point to trace it.";
  for (const name of isSpatial() ? Object.keys(VIEWS) : []) {
    const button = element("button", { type: "button", "data-view": name, title: `View ${name}` }, name);
    button.addEventListener("click", () => {
      camera.turn = VIEWS[name];
      fitAll();
    });
    byId("views").append(button);
  }
}
