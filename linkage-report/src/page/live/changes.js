// The changes as a line: below the title, on paper and in files.

// A dimension as it is now, and as it was in brackets.
function changeWords([name, value]) {
  const { unit } = report.dimensions.find((own) => own.name === name) ?? argumentOf(name);
  const [now, before] = [value, valueInReport(name)].map((own) => digits(rounded(plotValue(own, unit), 12)));
  return `${name} = ${now}${unit && " "}${plotUnit(unit)} (${before})`;
}

function changesLine() {
  if (!isChanged()) return "";
  const signs = areOtherModes() ? assemblyText(assemblyNow(), []) : "";
  const assembly = areOtherModes() || live.choice !== 0 ? [`other assembly ${signs}`.trim()] : [];
  return `changed: ${[...changedOnes().map(changeWords), ...assembly].join(", ")}`;
}

function startChanges() {
  byId("about").after(element("p", { id: "changes" }));
  saved.note = changesLine;
  onChange(showChanges);
}

function showChanges() {
  const line = changesLine();
  byId("changes").textContent = line;
  byId("changes").title = line;
  // A copy of the page begins with the same design.
  document.documentElement.dataset.changes = fragment();
  showActualDimensions();
}

// Nominal values stay beside those that are changed.
function showActualDimensions() {
  const sheet = byId("dimensions");
  if (sheet === null || live.listed === live.dimensions) return;
  live.listed = live.dimensions;
  sheet.lastChild.replaceWith(dimensionTable(({ name }) => live.dimensions.get(name)));
}
