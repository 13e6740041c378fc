// Free room on the screen: boxes of words against convex shapes with a width.

// A shape through places, with half the width of its stroke: one place is a circle, two are a bar, more a polygon.
function taken(places, half) {
  const [xs, ys] = [places.map((place) => place[0]), places.map((place) => place[1])];
  return {
    places, half,
    box: [Math.min(...xs) - half, Math.min(...ys) - half, Math.max(...xs) + half, Math.max(...ys) + half],
  };
}

function boxesMeet(a, b) {
  return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}

// Returns true if a box, as left, top, right, bottom, is nearer to a shape than `clear`.
function isCovered(box, shape, clear) {
  const wide = [box[0] - clear, box[1] - clear, box[2] + clear, box[3] + clear];
  return boxesMeet(wide, shape.box) && distanceToBox(shape.places, box) < shape.half + clear;
}

// The distance of a convex polygon, a stretch or a place from a box; 0 where they meet.
function distanceToBox(places, box) {
  if (places.length > 2 && isWithin([(box[0] + box[2]) / 2, (box[1] + box[3]) / 2], places)) return 0;
  let least = Infinity;
  places.forEach((place, i) => {
    least = Math.min(least, stretchToBox(place, places[(i + 1) % places.length], box));
  });
  return least;
}

function stretchToBox(a, b, box) {
  if (passesThrough(a, b, box)) return 0;
  const [left, top, right, bottom] = box;
  const corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
  return Math.min(placeToBox(a, box), placeToBox(b, box), ...corners.map((corner) => placeToStretch(corner, a, b)));
}

// Clips the stretch to the box, after Liang and Barsky.
function passesThrough(a, b, [left, top, right, bottom]) {
  let [from, to] = [0, 1];
  for (const [step, low, high] of [[b[0] - a[0], left - a[0], right - a[0]], [b[1] - a[1], top - a[1], bottom - a[1]]]) {
    if (step === 0) {
      if (low > 0 || high < 0) return false;
    } else {
      const ends = [low / step, high / step];
      from = Math.max(from, Math.min(...ends));
      to = Math.min(to, Math.max(...ends));
    }
  }
  return from <= to;
}

function placeToBox([x, y], [left, top, right, bottom]) {
  return Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));
}

function placeToStretch([x, y], a, b) {
  const [u, v] = [b[0] - a[0], b[1] - a[1]];
  const square = u * u + v * v;
  const part = square > 0 ? Math.min(1, Math.max(0, ((x - a[0]) * u + (y - a[1]) * v) / square)) : 0;
  return Math.hypot(x - a[0] - part * u, y - a[1] - part * v);
}

function isWithin(place, polygon) {
  const sides = polygon.map((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    return (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]);
  });
  return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}
