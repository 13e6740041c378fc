// Places of the mechanism's points and directions, row by row, as the report has them or as they are seen from a link.

const picture = report.picture;

// Components at one row, or null if one of them is missing there.
function placeOf(item, row) {
  const place = item.at.map((component) => component[row]);
  return place.includes(null) ? null : place;
}

function pointAt(index, row) {
  const place = placeOf(picture.points[index], row);
  return place === null ? null : seenPlace(place, row);
}

function directionAt(index, row) {
  const direction = placeOf(picture.directions[index], row);
  return direction === null ? null : seenDirection(direction, row);
}

// Points that only say where a guide is are no part of the mechanism.
function isDrawn(point) {
  return point.kind !== "construction";
}

// Their indices.
function drawnPoints() {
  return picture.points.flatMap((point, index) => (isDrawn(point) ? [index] : []));
}

function along(place, direction, length) {
  return place.map((component, i) => component + length * direction[i]);
}

function dot(a, b) {
  return a.reduce((sum, component, i) => sum + component * b[i], 0);
}

function minus(a, b) {
  return a.map((component, i) => component - b[i]);
}

function eachRow(visit) {
  for (let row = 0; row < rowCount; row += 1) visit(row);
}

// The ranges of sliders along their guides: lowest and highest distance from the origin, angles of
// an arc, until places change.
const reaches = new Map();

function reachOf(guide) {
  if (!reaches.has(guide)) reaches.set(guide, reachNow(guide));
  return reaches.get(guide);
}

function reachNow(guide) {
  if (guide.shape === "arc") return swingOf(input.values.map((_, row) => arcAngle(guidePlaces(guide, row))));
  let low = Infinity;
  let high = -Infinity;
  eachRow((row) => {
    const [origin, direction, slider] = guidePlaces(guide, row);
    if (slider === null || origin === null || direction === null) return;
    const distance = dot(minus(slider, origin), direction);
    low = Math.min(low, distance);
    high = Math.max(high, distance);
  });
  return [low, high];
}

function guidePlaces(guide, row) {
  return [pointAt(guide.origin, row), directionAt(guide.direction, row), pointAt(guide.slider, row)];
}

// The box around all places of the drawing, as its middle and half its sides, and the largest
// distance of points from the middle.
function extent() {
  const low = Array(picture.dimension).fill(Infinity);
  const high = Array(picture.dimension).fill(-Infinity);
  for (const point of drawnPoints()) {
    eachRow((row) => {
      const place = pointAt(point, row);
      if (place === null) return;
      place.forEach((component, i) => {
        low[i] = Math.min(low[i], component);
        high[i] = Math.max(high[i], component);
      });
    });
  }
  for (const { centres, radii } of picture.gears) {
    centres.forEach((centre, wheel) => eachRow((row) => {
      const place = pointAt(centre, row);
      if (place === null) return;
      place.forEach((component, i) => {
        low[i] = Math.min(low[i], component - radii[wheel]);
        high[i] = Math.max(high[i], component + radii[wheel]);
      });
    }));
  }
  guidesAround(low, high);
  const known = low.every(Number.isFinite);
  const middle = low.map((component, i) => (known ? (component + high[i]) / 2 : 0));
  const half = low.map((component, i) => (known ? (high[i] - component) / 2 : 1));
  return { middle, half, radius: reachFrom(middle) || 1 };
}

// Plates with curved slots are larger than their points. Guides of a frame that moves sweep more than their sliders.
function guidesAround(low, high) {
  for (const guide of picture.guides.filter(({ on, shape }) => shape === "arc" || (isStanding() && on === "frame"))) {
    eachRow((row) => {
      for (const place of guideLine(guide, row)) {
        place.forEach((component, i) => {
          low[i] = Math.min(low[i], component);
          high[i] = Math.max(high[i], component);
        });
      }
    });
  }
}

// Places along a guide: both ends, or all of an arc. None where the mechanism is not whole.
function guideLine(guide, row) {
  if (guide.shape === "arc") {
    const arc = arcNow(guide, row);
    return arc === null ? [] : arcLine(arc);
  }
  const [origin, direction] = guidePlaces(guide, row);
  if (origin === null || direction === null) return [];
  return reachOf(guide).map((distance) => along(origin, direction, distance));
}

function reachFrom(middle) {
  let reach = 0;
  for (const point of drawnPoints()) {
    eachRow((row) => {
      const place = pointAt(point, row);
      if (place !== null) reach = Math.max(reach, Math.hypot(...minus(place, middle)));
    });
  }
  return reach;
}
