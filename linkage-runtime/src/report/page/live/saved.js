// What a page saves whose mechanism was changed: its own data, in files that say so.

function startSaving() {
  saved.json = () => (isChanged() ? JSON.stringify(dataNow()) : source);
  saved.name = (name) => (isChanged() ? name.replace(/(\.[^.]+)$/, "_changed$1") : name);
}

// As `data.json`, without references between columns; `changed` has what is not as in the report.
function dataNow() {
  const modes = areOtherModes() ? { modes: live.modes } : {};
  const states = live.choice === 0 ? {} : { states: statesNow() };
  return {
    ...report,
    changed: { ...Object.fromEntries(changedOnes()), ...modes, ...states },
    dimensions: report.dimensions.map((own) => ({ ...own, value: live.dimensions.get(own.name) })),
    summary: live.summary.map(figureNow),
    live: { ...report.live, given: Object.fromEntries(live.given), modes: live.modes },
  };
}
