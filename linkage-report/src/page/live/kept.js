// A design that is kept beside the one that is changed: dotted in the drawing and in plots.

function keepButton() {
  const button = element("button", { type: "button", id: "keep", "aria-pressed": "false", title: "Keep this design, dotted, to compare others with it" }, "Keep");
  button.addEventListener("click", () => {
    if (kept.columns === null) keepDesign();
    else dropDesign();
    set(button, { "aria-pressed": String(kept.columns !== null) });
    makePanels();
    drawGhost(position.row);
  });
  return button;
}

function keepDesign() {
  const line = changesLine();
  kept.words = `Dotted: ${line === "" ? "as in the report" : line.replace(/^changed: /, "")}`;
  kept.columns = new Map(columns.map(({ key, values: numbers }) => [key, [...numbers]]));
  if (picture) ghost.places = placesNow();
}

function dropDesign() {
  Object.assign(kept, { words: "", columns: null });
  if (picture) ghost.places = ghost.ofReport;
}
