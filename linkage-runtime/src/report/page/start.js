// Everything begins here.

// So many gaps are told one by one; plots show all of them.
const GAPS_TOLD = 4;

function sayGaps() {
  const gaps = report.gaps ?? [];
  byId("gaps").hidden = gaps.length === 0;
  byId("gaps").textContent = "";
  if (gaps.length === 0) return;
  const ranges = gaps.slice(0, GAPS_TOLD)
    .map(({ from, to }) => (from === to ? inputShort(from) : `${inputShort(from)} to ${inputShort(to)}`));
  if (gaps.length > GAPS_TOLD) ranges.push(`and ${gaps.length - GAPS_TOLD} more`);
  const reason = report.reason ?? "the mechanism cannot be assembled there, or stands at a dead point";
  byId("gaps").textContent = `Some values do not exist at ${input.name} = ${ranges.join(", ")}: ${reason}. Plots have gaps, tables say none.`;
}

function start() {
  document.title = report.title;
  byId("title").textContent = report.title;
  byId("about").textContent = report.about ?? "";
  sayGaps();
  startTheme();
  startPlayer();
  startDrawing();
  startCyclogram();
  startPlots();
  startTables();
  startKeys();
  startPrint();
  startCopying();
  if (report.live) startLive();
  announcePosition();
  document.body.dataset.ready = "true";
  // Who wants less motion starts it.
  if (picture && rowCount > 1 && !matchMedia("(prefers-reduced-motion: reduce)").matches) setPlaying(true);
}

start();
