// A point is drawn along its path: the mechanism goes to the row at which the point is nearest to the pointer.

const GRIP = {
  // Beside the size of the mechanism, a path that is shorter is that of a point that stands still.
  still: 2e-3,
  // Share of the rows, on each side of the present one, among which the nearest is looked for first, and farther while they come nearer.
  window: 1 / 16,
  // Pixels by which another branch must be nearer.
  leap: 24,
  // Pixels that are no difference: of rows so near to each other the one nearest to the present is taken.
  alike: 0.5,
};

const grip = { places: null, offset: null };

function pathOf(index) {
  const places = [];
  eachRow((row) => {
    const place = pointAt(index, row);
    places.push(place === null ? null : project(place));
  });
  return places;
}

// Returns true for a point that moves.
function isMoving(index) {
  const known = [];
  eachRow((row) => {
    const place = pointAt(index, row);
    if (place !== null) known.push(place);
  });
  const reach = (i) => known.reduce((most, place) => Math.max(most, place[i]), -Infinity) - known.reduce((least, place) => Math.min(least, place[i]), Infinity);
  return Math.max(...picture.points[index].at.map((_, i) => reach(i))) > GRIP.still * camera.box.radius;
}

// Takes the nearest moving point, or none.
function takeHold(place) {
  const near = pointsNear(place);
  const held = near.find((part) => part.away - near[0].away <= STACKED && isMoving(part.index));
  letGo();
  if (!held) return;
  grip.places = pathOf(held.index);
  // The point keeps its distance from the pointer.
  grip.offset = [0, 1].map((i) => held.joint.places[0][i] - place[i]);
}

function letGo() {
  grip.places = null;
}

function pull([x, y]) {
  setPlaying(false);
  moveTo(rowNearest([x + grip.offset[0], y + grip.offset[1]]));
}

// Rows between two, the short way where the last one is the first again.
function rowsApart(a, b) {
  const apart = Math.abs(a - b);
  return input.periodic ? Math.min(apart, rowCount - 1 - apart) : apart;
}

function rowNearest(place) {
  const away = grip.places.map((at) => (at === null ? Infinity : distance(at, place)));
  const least = (rows) => rows.reduce((best, row) => Math.min(best, away[row]), Infinity);
  const all = away.map((_, row) => row);
  const near = rowsOfBranch(all, least);
  const rows = least(near) <= least(all) + GRIP.leap ? near : all;
  const limit = least(rows) + GRIP.alike;
  const alike = rows.filter((row) => away[row] <= limit);
  return alike.reduce((best, row) => (rowsApart(row, position.row) < rowsApart(best, position.row) ? row : best), alike[0] ?? position.row);
}

// Rows around the present one, up to where the path does not come nearer any more.
function rowsOfBranch(all, least) {
  let reach = Math.max(2, GRIP.window * rowCount);
  let rows = [];
  let before = Infinity;
  while (rows.length < all.length) {
    rows = all.filter((row) => rowsApart(row, position.row) <= reach);
    if (!(least(rows) < before)) break;
    before = least(rows);
    reach *= 1.5;
  }
  return rows;
}
