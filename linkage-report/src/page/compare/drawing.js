// Drawing over drawing, to one scale.

const MARGIN = 0.06;
// Joints are this part of the drawing.
const JOINT = 0.007;

function extentOfAll() {
  const [[left, right], [low, high]] = data.extent;
  const size = Math.max(right - left, high - low) || 1;
  return { left, right, low, high, size };
}

// On the screen, down is where numbers grow.
function place(point, row) {
  const at = (all) => (Array.isArray(all) ? all[row] : all);
  const [x, y] = [at(point.x), at(point.y)];
  return x === null || y === null ? null : [x, -y];
}

function wayThrough(places, digits) {
  let d = "";
  let pen = "M";
  for (const at of places) {
    if (at !== null) d += `${pen}${at.map((x) => rounded(x, digits)).join(" ")}`;
    pen = at === null ? "M" : "L";
  }
  return d;
}

// The parts of a design that stay, and those that move with the position.
function drawn(index) {
  const { picture } = data.designs[index];
  const { size } = extentOfAll();
  const rows = data.input.values.map((_, row) => row);
  const still = picture.rails.map((rail) => shape("path", { class: "rail", d: wayThrough(rail.map(([x, y]) => [x, -y]), 6) }));
  const traces = picture.traces.map((point) => {
    const d = wayThrough(rows.map((row) => place(picture.points[point], row)), 6);
    return shape("path", { class: "trace", d, ...line(index) });
  });
  const links = picture.links.map(() => shape("path", { class: "link", fill: hue(index), ...line(index) }));
  const joints = picture.points.map((point) => shape("circle", { class: point.ground ? "joint ground" : "joint", r: size * JOINT, stroke: hue(index) }));
  const move = () => {
    const at = picture.points.map((point) => place(point, state.row));
    for (const [k, points] of picture.links.entries()) {
      const whole = points.every((point) => at[point] !== null);
      const close = points.length > 2 ? "Z" : "";
      set(links[k], { d: whole ? wayThrough(points.map((point) => at[point]), 7) + close : null });
    }
    for (const [k, joint] of joints.entries()) {
      set(joint, { visibility: at[k] === null ? "hidden" : null, cx: at[k]?.[0] ?? null, cy: at[k]?.[1] ?? null });
    }
  };
  const title = shape("title", {}, data.designs[index].name);
  return { group: shape("g", { "data-design": index }, title, ...still, ...traces, ...links, ...joints), move };
}

function startDrawing() {
  const drawable = data.designs.map((design) => design.picture !== null);
  if (!drawable.some(Boolean)) return;
  const { left, right, low, high, size } = extentOfAll();
  const edge = MARGIN * size;
  const box = [left - edge, -high - edge, right - left + 2 * edge, high - low + 3 * edge];
  const svg = set(byId("drawing"), { viewBox: box.map((x) => rounded(x, 6)).join(" ") });
  byId("figure").hidden = false;
  const length = roundBelow(size / 4);
  const [x, y] = [left, -low + 1.4 * edge];
  const bar = shape("path", { class: "bar", d: `M${x} ${y - edge / 6}v${edge / 3}m0 ${-edge / 6}h${length}m0 ${-edge / 6}v${edge / 3}` });
  const words = shape("text", { x: x + length + edge / 3, y: y + size * 0.008, "font-size": size * 0.025 }, `${length} ${data.unit}`);
  const all = data.designs.map((_, index) => (drawable[index] ? drawn(index) : null));
  watchers.push(() => {
    const parts = shown().flatMap((index) => all[index] ?? []);
    hold(svg, [...parts.map((part) => part.group), bar, words]);
    for (const part of parts) part.move();
  });
}
