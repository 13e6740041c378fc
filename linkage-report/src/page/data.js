// The report that the page shows, and its columns under one roof.

const source = byId("report").textContent.trim();
const report = JSON.parse(source, (_, value) => (value?.f64?.length > 0 ? unpacked(value.f64) : value));
resolveReferences();
if (report.live) ownNumbers();
const input = report.input;
const rowCount = input.values.length;

// The state of the page that the host showed before, if that was of the same mechanism.
const before = host?.before?.title === report.title ? host.before : null;

// Every column of every table, and the true velocities and accelerations beside them.
const columns = collectColumns();

// One number for all rows, or the bytes of all, as little-endian processors have them.
function unpacked(packed) {
  if (Array.isArray(packed)) return Array(packed[1]).fill(packed[0]);
  const letters = atob(packed);
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k += 1) bytes[k] = letters.charCodeAt(k);
  const numbers = [...new Float64Array(bytes.buffer)];
  for (let k = 0; k < numbers.length; k += 1) if (Number.isNaN(numbers[k])) numbers[k] = null;
  return numbers;
}

// The data with lists of decimals, as the file beside the page has them.
function sourceInDecimals() {
  return source.replace(/\{"f64":("[^"]*"|\[[^\]]*\])\}/g, (_, packed) => `[${unpacked(JSON.parse(packed)).map(decimalsOf).join(",")}]`);
}

// Whole numbers have a point, too, and a zero keeps its sign.
function decimalsOf(number) {
  const text = Object.is(number, -0) ? "-0" : String(number);
  return /^-?\d+$/.test(text) ? `${text}.0` : text;
}

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
