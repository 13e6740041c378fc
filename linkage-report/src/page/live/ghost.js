// The mechanism of the report behind one with other dimensions.

const ghost = { layer: null, places: [] };

function startGhost() {
  if (!picture) return;
  ghost.places = picture.points.map((point) => ({ at: point.at.map((numbers) => [...numbers]) }));
  ghost.layer = shape("g", { class: "ghost", "aria-hidden": "true" });
  byId("drawing").prepend(ghost.layer);
  onMove(drawGhost);
  camera.listeners.push(() => drawGhost(position.row));
}

function drawGhost(row) {
  // It has not the link that somebody stands on.
  if (!isChanged() || isStanding()) {
    ghost.layer.replaceChildren();
    return;
  }
  const lines = picture.links.map(({ points }) => {
    const places = points.map((point) => placeOf(ghost.places[point], row));
    if (places.includes(null)) return "";
    const seen = places.map(project);
    return points.length > 2 ? lineThrough(hull(seen)) + "Z" : lineThrough(seen);
  });
  ghost.layer.replaceChildren(shape("path", { d: lines.join("") }));
}
