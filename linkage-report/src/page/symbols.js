// Signs of drawings, in pixels: hatching, pivots, rails, blocks.

const JOINT = 5;
const BAR = 9;

// Short strokes below a line from one place to another, as ground has them.
function hatching(from, to, spacing = 6) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (!(length > 0)) return "";
  const [x, y] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const count = Math.max(1, Math.floor(length / spacing));
  let d = "";
  for (let n = 0; n <= count; n += 1) {
    const foot = [from[0] + (x * length * n) / count, from[1] + (y * length * n) / count];
    d += lineThrough([foot, [foot[0] - 5 * x - 6 * y, foot[1] - 5 * y + 6 * x]]);
  }
  return d;
}

// `d` of strokes that fill a rectangle. They belong to the whole plane, so that those of neighbours meet.
function hatchedArea(left, top, right, bottom, spacing = 9) {
  let d = "";
  for (let sum = Math.ceil((left + top) / spacing) * spacing; sum < right + bottom; sum += spacing) {
    const [from, to] = [Math.max(left, sum - bottom), Math.min(right, sum - top)];
    d += lineThrough([[from, sum - from], [to, sum - to]]);
  }
  return d;
}

// A triangle on hatched ground with its tip in the origin.
function groundSign() {
  const [wide, high] = [10, 15];
  return shape("g", { class: "ground" },
    shape("path", { class: "hatching", d: hatching([-wide - 3, high], [wide + 3, high], 5) }),
    shape("path", { class: "foot", d: `M0 0L${-wide} ${high}L${wide} ${high}Z` }),
    shape("path", { class: "base", d: `M${-wide - 4} ${high}L${wide + 4} ${high}` }));
}

// The corners of its area.
function groundCorners([x, y]) {
  return [[x - 19, y], [x + 19, y], [x + 19, y + 22], [x - 19, y + 22]];
}

// The corners of a rectangle around a place, its long side along a direction of the screen.
function block([x, y], [u, v], half = 13, thick = 8) {
  const length = Math.hypot(u, v);
  const [c, s] = length > 1e-6 ? [u / length, v / length] : [1, 0];
  // Seen from its end it is as wide as thick.
  const long = thick + (half - thick) * Math.min(1, length);
  const corner = (a, b) => [x + a * long * c - b * thick * s, y + a * long * s + b * thick * c];
  return [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
}

// The polygon around places of the screen, counter-clockwise (by Andrew's monotone chain).
function hull(places) {
  const sorted = [...places].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const turnsRight = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0;
  const chain = (sequence) => {
    const line = [];
    for (const place of sequence) {
      while (line.length > 1 && turnsRight(line.at(-2), line.at(-1), place)) line.pop();
      line.push(place);
    }
    return line.slice(0, -1);
  };
  const around = [...chain(sorted), ...chain(sorted.reverse())];
  return around.length > 1 ? around : places.slice(0, 1);
}
