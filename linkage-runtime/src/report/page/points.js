// Points of the drawing: to look at, to name, to trace.

const RADII = { ground: JOINT, joint: JOINT, tip: 3.5, loose: 5 };

function pointPart(point, index) {
  const mark = shape("circle", { class: "mark", r: RADII[point.kind] });
  // Larger than what is seen: fingers are wide.
  const target = shape("circle", { class: "target", r: 15 });
  const label = shape("text", { class: "name" }, point.name);
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
  node.append(target, mark, label);
  listenToPoint(node, index);
  return { node, update: (row) => movePoint(node, { mark, target, label, ground }, index, row) };
}

function movePoint(node, { mark, target, label, ground }, index, row) {
  const place = pointAt(index, row);
  // In the mechanism's unit and with all digits: what is seen is rounded to pixels.
  ["x", "y", "z"].forEach((name, i) => set(node, { ["data-" + name]: place === null ? null : place[i] ?? null }));
  if (place === null) return null;
  const [cx, cy, nearness] = project(place);
  for (const circle of [mark, target]) set(circle, { cx: pixel(cx), cy: pixel(cy) });
  const left = cx > camera.width - 60;
  set(label, { x: pixel(cx + (left ? -10 : 10)), y: pixel(cy - 9), "text-anchor": left ? "end" : "start" });
  if (ground) set(ground, { transform: `translate(${pixel(cx)} ${pixel(cy)})` });
  return nearness + 2e-3 * camera.box.radius;
}

function listenToPoint(node, index) {
  node.addEventListener("click", () => toggleTrace(index));
  node.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    toggleTrace(index);
  });
}
