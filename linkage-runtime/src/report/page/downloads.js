// The data as files, made from what the page holds.

function quoted(field) {
  return /[",\r\n]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field;
}

// The input, then the columns; no value is an empty field.
function csvOf(members) {
  const head = [input, ...members].map(({ name, unit }) => quoted(titled(name, unit)));
  const lines = input.values.map((value, row) =>
    [value, ...members.map((column) => column.values[row])].map((number) => (number === null ? "" : String(number))).join(","));
  return [head.join(","), ...lines, ""].join("\r\n");
}

function download(name, type, text) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = element("a", { href: address, download: name });
  link.click();
  // After the browser has taken it.
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

function downloadButton(name, type, make) {
  const button = element("button", { type: "button", "data-file": name }, name);
  button.addEventListener("click", () => download(name, type, make()));
  return button;
}

function startDownloads() {
  const csv = report.tables.map((table) =>
    downloadButton(`${table.function}.csv`, "text/csv", () => csvOf(columns.filter((column) => column.table === table.function))));
  const json = downloadButton("data.json", "application/json", () => source);
  addSheet("Data", true,
    element("p", {}, "All values with all their digits. Angles are in radians; a value that does not exist is empty in CSV and null in JSON."),
    element("p", { class: "buttons" }, json, ...csv));
}
