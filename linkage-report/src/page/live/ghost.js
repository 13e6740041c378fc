// The mechanism of the report, or the one that is kept, behind one with other dimensions.

const ghost = { layer: null, places: [], ofReport: [] };

function placesNow() {
  return picture.points.map((point) => ({ at: point.at.map((numbers) => [...numbers]) }));
}

function startGhost() {
  if (!picture) return;
  ghost.places = ghost.ofReport = placesNow();
  ghost.layer = shape("g", { class: "ghost", "aria-hidden": "true" });
  byId("drawing").prepend(ghost.layer);
  drawing.placers.push(drawGhost);
  onMove(drawGhost);
  camera.listeners.push(() => drawGhost(position.row));
}

function drawGhost(row) {
  // It has not the link that somebody stands on.
  if ((!isChanged() && kept.columns === null) || isStanding()) {
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
