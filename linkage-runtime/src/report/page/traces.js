// Paths of points over the whole sweep.

const traces = { paths: new Map(), layer: null };

// That of the point's curves in plots.
function traceColour(index) {
  return `var(--curve-${picture.points[index].colour})`;
}

function toggleTrace(index) {
  const path = traces.paths.get(index);
  if (path) {
    path.remove();
    traces.paths.delete(index);
  } else {
    traces.paths.set(index, addTrace(index));
  }
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
  const places = [];
  eachRow((row) => {
    const place = pointAt(index, row);
    places.push(place === null ? null : project(place));
  });
  set(path, { d: lineThrough(places) });
}

function drawTraces() {
  for (const [index, path] of traces.paths) drawTrace(path, index);
}
