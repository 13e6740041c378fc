// The map from places of the mechanism to places on the screen: to scale, without perspective.

const VIEWS = {
  "3-D": [-0.9, 0.45],
  "x-y": [-Math.PI / 2, Math.PI / 2],
  "x-z": [-Math.PI / 2, 0],
  "y-z": [0, 0],
};

const camera = {
  width: 1,
  height: 1,
  box: null,
  // Pixels for a unit of length, over that of the whole mechanism.
  zoom: 1,
  // Pixels by which the picture is moved.
  pan: [0, 0],
  // Angles of the eye about z and above the x-y plane.
  turn: picture?.view ?? VIEWS["3-D"],
  listeners: [],
  ...before?.camera,
};

function isSpatial() {
  return picture.dimension === 3;
}

// Unit vectors to the right, upwards and towards the eye.
function cameraAxes() {
  if (!isSpatial()) return [[1, 0], [0, 1], [0, 0]];
  const [about, above] = camera.turn;
  const [s, c, t, d] = [Math.sin(about), Math.cos(about), Math.sin(above), Math.cos(above)];
  return [[-s, c, 0], [-t * c, -t * s, d], [d * c, d * s, t]];
}

// Room for joints, pivots and their hatching around the points.
const BORDER = 44;

function fitScale() {
  const { half, radius } = camera.box;
  const room = [Math.max(40, camera.width / 2 - BORDER), Math.max(40, camera.height / 2 - BORDER)];
  // In space the size must not change while it turns.
  if (isSpatial()) return Math.min(...room) / radius;
  // Dividing by zero is right: a mechanism without height is as large as its width allows.
  const scale = Math.min(room[0] / half[0], room[1] / half[1]);
  return Number.isFinite(scale) ? scale : 1;
}

function cameraScale() {
  return camera.zoom * fitScale();
}

// Screen coordinates to the right and downwards, and the nearness to the eye in the mechanism's unit.
function project(place) {
  const [right, up, eye] = cameraAxes();
  const from = minus(place, camera.box.middle);
  const scale = cameraScale();
  return [
    camera.width / 2 + camera.pan[0] + scale * dot(from, right),
    camera.height / 2 + camera.pan[1] - scale * dot(from, up),
    dot(from, eye),
  ];
}

// A place of the mechanism under a pointer, in the plane that the screen shows.
function placeUnder([x, y]) {
  const [right, up] = cameraAxes();
  const scale = cameraScale();
  const u = (x - camera.width / 2 - camera.pan[0]) / scale;
  const v = -(y - camera.height / 2 - camera.pan[1]) / scale;
  return camera.box.middle.map((middle, i) => middle + u * right[i] + v * up[i]);
}

// A direction on the screen; shorter than 1 if it points towards the eye.
function projectDirection(direction) {
  const [right, up] = cameraAxes();
  return [dot(direction, right), -dot(direction, up)];
}

// 0 for the nearest place that a point of the mechanism may have, 1 for the farthest.
function farness(nearness) {
  return Math.min(1, Math.max(0, 0.5 - nearness / (2 * camera.box.radius)));
}

function zoomBy(factor, [x, y] = [camera.width / 2, camera.height / 2]) {
  const zoom = Math.min(200, Math.max(0.2, camera.zoom * factor));
  const change = zoom / camera.zoom;
  const from = [x - camera.width / 2, y - camera.height / 2];
  // The place under the pointer stays there.
  camera.pan = camera.pan.map((pan, i) => from[i] - change * (from[i] - pan));
  camera.zoom = zoom;
  announceCamera();
}

function panBy(x, y) {
  camera.pan = [camera.pan[0] + x, camera.pan[1] + y];
  announceCamera();
}

function turnBy(x, y) {
  const above = camera.turn[1] + 0.01 * y;
  camera.turn = [camera.turn[0] - 0.01 * x, Math.min(Math.PI / 2, Math.max(-Math.PI / 2, above))];
  announceCamera();
}

function fitAll() {
  camera.zoom = 1;
  camera.pan = [0, 0];
  announceCamera();
}

function announceCamera() {
  for (const listener of camera.listeners) listener();
}
