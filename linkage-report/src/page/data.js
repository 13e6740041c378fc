// The report that the page shows, and its columns under one roof.

let source = byId("report").textContent.trim();
const report = reportFrom(source);
if (report.live) ownNumbers(report);
const input = report.input;
// A motion under forces, whose rows are times; null for a mechanism over its range.
const driven = report.live?.motion ?? null;
const rowCount = input.values.length;

// The state of the page that the host showed before, if that was of the same mechanism.
const before = host?.before?.title === report.title ? host.before : null;

// Every column of every table, and the true velocities and accelerations beside them.
const columns = collectColumns();

// A report with its numbers where they are used. Equal columns are one list.
function reportFrom(text) {
  const own = JSON.parse(text, (_, value) => (value?.f64?.length > 0 ? unpacked(value.f64) : value));
  resolveReferences(own);
  return own;
}

// One number for all rows, or the bytes of all, as little-endian processors have them.
function unpacked(packed) {
  if (Array.isArray(packed)) return Array(packed[1]).fill(packed[0]);
  return Array.from(new Float64Array(bytesOf(packed).buffer), (x) => (x === x ? x : null));
}

// New browsers have a function for this.
function bytesOf(letters) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(letters);
  const own = atob(letters);
  const bytes = new Uint8Array(own.length);
  for (let k = 0; k < own.length; k += 1) bytes[k] = own.charCodeAt(k);
  return bytes;
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
function resolveReferences({ tables, true: rates, bands, picture }) {
  const numbersOf = (series) => (Array.isArray(series) ? series : tables[series.table].columns[series.column].values);
  for (const { columns } of tables) {
    for (const column of columns) column.values = numbersOf(column.values);
  }
  for (const rate of rates ?? []) rate.values = numbersOf(rate.values);
  for (const band of bands ?? []) band.half = numbersOf(band.half);
  for (const item of [...(picture?.points ?? []), ...(picture?.directions ?? [])]) {
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
