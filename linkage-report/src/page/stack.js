// Points that lie on each other: the nearest one is meant, and of several at one place the reader chooses.

// Pixels up to which a point is meant, as far as its target reaches, and up to which points lie on each other.
const MEANT = 15;
const STACKED = 6;

const stack = { list: null };

// Points that are shown around a place of the screen, the nearest first.
function pointsNear(place) {
  const shown = drawing.tops.filter((part) => part.node.style.display !== "none");
  const near = shown.map((part) => ({ ...part, away: distance(part.joint.places[0], place) }));
  return near.filter((part) => part.away <= MEANT).sort((a, b) => a.away - b.away);
}

// The nearest point and those on the same place.
function stackAt(place) {
  const near = pointsNear(place);
  return near.filter((part) => distance(part.joint.places[0], near[0].joint.places[0]) <= STACKED);
}

function choosePoint(place) {
  const points = stackAt(place);
  closeStack();
  if (points.length === 1) toggleTrace(points[0].index);
  if (points.length > 1) openStack(points, place);
}

function openStack(points, [x, y]) {
  const buttons = points.map(({ index }) => {
    const { name } = picture.points[index];
    const traced = traces.paths.has(index);
    const button = element("button", { type: "button", "data-choice": name, "aria-pressed": String(traced) }, name);
    button.addEventListener("click", () => {
      toggleTrace(index);
      closeStack();
    });
    return button;
  });
  stack.list = element("div", { id: "stack", role: "group", "aria-label": "Points at this place" }, ...buttons);
  byId("figure").append(stack.list);
  // Within the figure, beside the place.
  const { offsetWidth, offsetHeight } = stack.list;
  stack.list.style.left = `${Math.max(4, Math.min(x + 12, camera.width - offsetWidth - 4))}px`;
  stack.list.style.top = `${Math.max(4, Math.min(y + 12, camera.height - offsetHeight - 4))}px`;
  buttons[0].focus({ preventScroll: true });
}

function closeStack() {
  stack.list?.remove();
  stack.list = null;
}

// Names where the mouse is.
function pointOut(place) {
  const points = place === null ? [] : stackAt(place).map((part) => part.node);
  for (const { node } of drawing.tops) node.classList.toggle("pointed", points.includes(node));
}

function startStack() {
  document.addEventListener("pointerdown", (event) => {
    if (stack.list && !stack.list.contains(event.target)) closeStack();
  }, { capture: true, signal: life.signal });
  listen(document, "keydown", (event) => event.key === "Escape" && closeStack());
}
