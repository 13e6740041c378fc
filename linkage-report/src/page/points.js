// Points of the drawing: to look at, to name, to trace.

const RADII = { ground: JOINT, joint: JOINT, tip: 3.5, loose: 5, dot: 2.6 };

function pointPart(point, index) {
  const radius = point.kind === "joint" && onlySlides(index) ? RADII.dot : RADII[point.kind];
  const mark = shape("circle", { class: "mark", r: radius });
  const signs = jointSigns(index);
  // Larger than the visible mark: fingers are wide.
  const target = shape("circle", { class: "target", r: 15 });
  const name = nameParts(point);
  const node = shape("g", {
    class: `point ${point.kind}${radius === RADII.dot ? " dot" : ""}${isFilled(index) ? " filled" : ""}`,
    "data-point": point.name,
    tabindex: 0,
    role: "button",
    "aria-label": `Trace ${point.name}`,
    "aria-pressed": "false",
  });
  const ground = point.kind === "ground" ? groundSign() : null;
  if (ground) node.append(ground);
  node.append(...signs.map((sign) => sign.node), target, mark, name.leader, name.label);
  listenToPoint(node, index);
  node.classList.toggle("moving", isMoving(index));
  const part = { node, name, index, update: (row) => movePoint(part, { mark, target, ground, signs, radius }, row) };
  return part;
}

function movePoint(part, { mark, target, ground, signs, radius }, row) {
  const { node, index } = part;
  const place = pointAt(index, row);
  // The place in the mechanism's unit and with all digits; the visible one is rounded to pixels.
  ["x", "y", "z"].forEach((name, i) => set(node, { ["data-" + name]: place === null ? null : place[i] ?? null }));
  if (place === null) return null;
  const [cx, cy, nearness] = project(place);
  for (const circle of [mark, target]) set(circle, { cx: pixel(cx), cy: pixel(cy) });
  // With half of its stroke.
  part.joint = taken([[cx, cy]], radius + 1);
  part.covers = [part.joint, ...signs.flatMap((sign) => sign.update([cx, cy], row))];
  if (ground) part.covers.push(taken(groundCorners([cx, cy]), 0));
  const turned = isStanding() && !isSpatial() ? ` rotate(${pixel(seenTurn(row))})` : "";
  if (ground) set(ground, { transform: `translate(${pixel(cx)} ${pixel(cy)})${turned}` });
  return nearness + 2e-3 * camera.box.radius;
}

function listenToPoint(node, index) {
  node.addEventListener("click", (event) => choosePoint(onDrawing(event)));
  node.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    toggleTrace(index);
  });
}
