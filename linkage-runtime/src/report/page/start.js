// Everything begins here.

function sayGaps() {
  const gaps = report.gaps ?? [];
  if (gaps.length === 0) return;
  const ranges = gaps.map(({ from, to }) => (from === to ? inputShort(from) : `${inputShort(from)} to ${inputShort(to)}`));
  byId("gaps").hidden = false;
  byId("gaps").textContent =
    `Some values do not exist at ${input.name} = ${ranges.join(", ")}: the mechanism cannot be assembled there, or stands at a dead point. Plots have gaps, tables say none.`;
}

function start() {
  document.title = report.title;
  byId("title").textContent = report.title;
  byId("about").textContent = report.about ?? "";
  sayGaps();
  startTheme();
  startPlayer();
  startDrawing();
  startPlots();
  startTables();
  startKeys();
  announcePosition();
  document.body.dataset.ready = "true";
  // Who wants less motion starts it.
  if (picture && rowCount > 1 && !matchMedia("(prefers-reduced-motion: reduce)").matches) setPlaying(true);
}

start();
