// The state of the page, for a host that shows another report of the same mechanism in its place.

// Asked for, the browser would arrange the page for it.
const scrolled = { by: before?.scrolled ?? 0 };

listen(window, "scroll", () => (scrolled.by = scrollY));

function pageState() {
  const { width, height, zoom, pan, turn } = camera;
  return {
    title: report.title,
    at: input.values[position.row],
    playing: player.playing,
    backward: player.backward,
    period: player.period,
    camera: { width, height, zoom, pan, turn },
    box: camera.box,
    chosen: [...chosen],
    folds: [...document.querySelectorAll("main details")].map((fold) => [foldName(fold), fold.open]),
    plotWidth: plots.width,
    scrolled: scrolled.by,
  };
}

function foldName(fold) {
  return fold.id || fold.firstChild.textContent;
}

// The position and what was open, as far as they are on this page, too.
function resume() {
  const open = new Map(before.folds);
  for (const fold of document.querySelectorAll("main details")) fold.open = open.get(foldName(fold)) ?? fold.open;
  position.row = nearestRow(before.at);
  if (before.scrolled > 0) scrollTo(0, before.scrolled);
}
