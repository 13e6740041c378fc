// Everything that shows numbers, after they have changed.

function showChange() {
  document.body.classList.toggle("changed", isChanged());
  sayGaps();
  if (picture) remakeDrawing();
  redrawPanels();
  remakeAccuracy();
  remakeSummary();
  announcePosition();
}

// Guides are as long as their sliders go.
function remakeDrawing() {
  reaches.clear();
  drawTraces();
}

function remakeAccuracy() {
  const sheet = byId("accuracy");
  if (sheet === null) return;
  const open = new Set([...sheet.querySelectorAll("details[open] > summary")].map((own) => own.textContent));
  const tables = accuracyTables();
  for (const own of tables) if (own.matches("details") && open.has(own.firstChild.textContent)) own.open = true;
  sheet.replaceChildren(sheet.firstChild, ...tables);
}
