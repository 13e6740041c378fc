// Points of the drawing: to look at, to name, to trace.

const RADII = { ground: JOINT, joint: JOINT, tip: 3.5, loose: 5 };

function pointPart(point, index) {
  const mark = shape("circle", { class: "mark", r: RADII[point.kind] });
  // Larger than what is seen: fingers are wide.
  const target = shape("circle", { class: "target", r: 15 });
  const name = nameParts(point);
  const node = shape("g", {
    class: `point ${point.kind}`,
    "data-point": point.name,
    tabindex: 0,
    role: "button",
    "aria-label": `Trace ${point.name}`,
    "aria-pressed": "false",
  });
  const ground = point.kind === "ground" ? groundSign() : null;
  if (ground) node.append(ground);
  node.append(target, mark, name.leader, name.label);
  listenToPoint(node, index);
  node.classList.toggle("moving", isMoving(index));
  const part = { node, name, index, update: (row) => movePoint(part, { mark, target, ground }, row) };
  return part;
}

function movePoint(part, { mark, target, ground }, row) {
  const { node, index } = part;
  const place = pointAt(index, row);
  // In the mechanism's unit and with all digits: what is seen is rounded to pixels.
  ["x", "y", "z"].forEach((name, i) => set(node, { ["data-" + name]: place === null ? null : place[i] ?? null }));
  if (place === null) return null;
  const [cx, cy, nearness] = project(place);
  for (const circle of [mark, target]) set(circle, { cx: pixel(cx), cy: pixel(cy) });
  // With half of its stroke.
  part.joint = taken([[cx, cy]], RADII[picture.points[index].kind] + 1);
  part.covers = ground ? [part.joint, taken(groundCorners([cx, cy]), 0)] : [part.joint];
  if (ground) set(ground, { transform: `translate(${pixel(cx)} ${pixel(cy)})` });
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
