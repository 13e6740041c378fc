// Paths of points over the whole sweep.

// Rows of a stretch that names keep clear of: on the screen, paths are straight between them.
const STRETCH = 6;
const traces = { paths: new Map(), covers: new Map(), layer: null };

// That of the point's curves in plots.
function traceColour(index) {
  return `var(--curve-${picture.points[index].colour})`;
}

function toggleTrace(index) {
  const path = traces.paths.get(index);
  if (path) {
    path.remove();
    traces.paths.delete(index);
    traces.covers.delete(index);
  } else {
    traces.paths.set(index, addTrace(index));
  }
  forgetVectors();
  drawVectors(position.row);
  const node = drawing.points.get(index);
  node.setAttribute("aria-pressed", traces.paths.has(index));
  node.style.setProperty("--colour", traceColour(index));
}

function addTrace(index) {
  const path = shape("path", {
    class: "trace",
    "data-trace": picture.points[index].name,
    style: `--colour: ${traceColour(index)}`,
  });
  traces.layer.append(path);
  drawTrace(path, index);
  return path;
}

function drawTrace(path, index) {
  const places = isHidden(["points", index]) ? [] : pathOf(index);
  set(path, { d: lineThrough(places) });
  traces.covers.set(index, stretchesOf(places));
}

function stretchesOf(places) {
  const stretches = [];
  for (let row = 0; row < places.length; row += STRETCH) {
    const [from, to] = [places[row], places[Math.min(row + STRETCH, places.length - 1)]];
    if (from !== null && to !== null) stretches.push(taken([from, to], 1));
  }
  return stretches;
}

function drawTraces() {
  for (const [index, path] of traces.paths) drawTrace(path, index);
}
