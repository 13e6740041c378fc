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
  stand.frames = [];
  forgetVectors();
  drawTraces();
}

function remakeAccuracy() {
  const sheet = byId("accuracy");
  if (sheet === null) return;
  sheet.querySelector(".scroll").replaceWith(accuracyGrid());
  for (const own of contributions.folds) {
    own.old = true;
    if (own.box.open) own.refresh();
  }
}
