// The saved data of a changed mechanism, in files that name the changes.

function startSaving() {
  saved.json = () => (isChanged() ? JSON.stringify(dataNow()) : sourceInDecimals());
  saved.name = (name) => (isChanged() && !staysAsItWas(name) ? name.replace(/(\.[^.]+)$/, "_changed$1") : name);
}

// Tables that nothing computes here are saved with the report's numbers.
function staysAsItWas(file) {
  return live.tables.some(({ table, why }) => why !== null && file === `${table.function}.csv`);
}

// The same data as in `data.json`, without references between columns; `changed` has the
// differences from the report, `stands` is true where nothing computes.
function dataNow() {
  // These words are the page's own.
  const { reason, changePoints, ...data } = report;
  const modes = areOtherModes() ? { modes: live.modes } : {};
  const states = live.choice === 0 ? {} : { states: statesNow() };
  return {
    ...data,
    changed: { dimensions: changedAmong(live.dimensions), given: changedAmong(live.given), ...modes, ...states },
    dimensions: report.dimensions.map((own) => ({ ...own, value: live.dimensions.get(own.name) })),
    tables: live.tables.map(({ table, why }) => (why === null ? table : { ...table, stands: true })),
    summary: live.summary.map(figureNow),
    live: { ...report.live, given: Object.fromEntries(live.given), modes: live.modes },
  };
}

function changedAmong(all) {
  return Object.fromEntries([...all].filter(([name, value]) => value !== valueInReport(name)));
}
