// Everything begins here.

// The number of gaps that are listed; plots show all of them.
const GAPS_TOLD = 4;

// Remarks about the values: gaps, change points where the mechanism may go on in another assembly,
// singular positions, or the end of a motion.
function sayGaps() {
  const told = [gapWords(report.gaps ?? []), report.changePoints ?? null, driven === null ? singularWords() : endOfMotion()].filter((words) => words !== null);
  byId("gaps").hidden = told.length === 0;
  byId("gaps").textContent = told.join(" ");
}

function gapWords(gaps) {
  if (gaps.length === 0) return null;
  const ranges = gaps.slice(0, GAPS_TOLD)
    .map(({ from, to }) => (from === to ? inputShort(from) : `${inputShort(from)} to ${inputShort(to)}`));
  if (gaps.length > GAPS_TOLD) ranges.push(`and ${gaps.length - GAPS_TOLD} more`);
  const reason = report.reason ?? "the mechanism cannot be assembled there, or stands at a dead point";
  return `Some values do not exist at ${input.name} = ${ranges.join(", ")}: ${reason}. Plots have gaps, tables say none.`;
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
  startStage();
  startCopying();
  if (report.live) startLive();
  if (driven !== null) nameStarts();
  if (before !== null) resume();
  announcePosition();
  document.body.dataset.ready = "true";
  // A reader who wants less motion starts it.
  const moves = before?.playing ?? !matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (picture && rowCount > 1 && moves) setPlaying(true);
}

start();
