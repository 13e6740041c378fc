// The report that the page shows, and its columns under one roof.

const source = byId("report").textContent.trim();
const report = JSON.parse(source);
resolveReferences();
if (report.live) ownNumbers();
const input = report.input;
const rowCount = input.values.length;

// Every column of every table, and the true velocities and accelerations beside them.
const columns = collectColumns();

// Numbers stand in the data once; elsewhere is said in which column.
function numbersOf(series) {
  return Array.isArray(series) ? series : report.tables[series.table].columns[series.column].values;
}

function resolveReferences() {
  for (const { columns } of report.tables) {
    for (const column of columns) column.values = numbersOf(column.values);
  }
  for (const rate of report.true ?? []) rate.values = numbersOf(rate.values);
  for (const band of report.bands ?? []) band.half = numbersOf(band.half);
  for (const item of [...(report.picture?.points ?? []), ...(report.picture?.directions ?? [])]) {
    item.at = item.at.map(numbersOf);
  }
}

function collectColumns() {
  const all = [];
  for (const table of report.tables) {
    for (const column of table.columns) all.push({ ...column, table: table.function });
  }
  for (const column of report.true ?? []) all.push({ ...column, meaning: "true" });
  for (const column of all) {
    column.key = [column.table, column.meaning === "true" ? "true" : "", column.name, column.unit].join("|");
    column.bands = bandsOf(column);
  }
  return all;
}

function bandsOf(column) {
  if (column.meaning === "true") return [];
  return (report.bands ?? []).filter((band) => band.table === column.table && band.column === column.name);
}

// The row whose input is nearest. Inputs rise or fall steadily; of equally near rows the first is taken.
function nearestRow(value) {
  let best = 0;
  for (let row = 1; row < rowCount; row += 1) {
    if (Math.abs(input.values[row] - value) < Math.abs(input.values[best] - value)) best = row;
  }
  return best;
}

function inputText(value) {
  return `${input.name} = ${withUnit(value, input.unit)}`;
}

// Short: for axes and sentences, where the radians stand elsewhere.
function inputShort(value) {
  const unit = plotUnit(input.unit);
  return `${digits(rounded(plotValue(value, input.unit), 6))}${unit ? " " + unit : ""}`;
}
