// The data of the page as files.

function quoted(field) {
  return /[",\r\n]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field;
}

// A zero keeps its sign, which String() drops; no value is an empty field.
function fieldOf(number) {
  if (number === null) return "";
  return Object.is(number, -0) ? "-0" : String(number);
}

// The input, then the columns.
function csvOf(members) {
  const head = [input, ...members].map(({ name, unit }) => quoted(titled(name, unit)));
  const lines = input.values.map((value, row) =>
    [value, ...members.map((column) => column.values[row])].map(fieldOf).join(","));
  const note = saved.note();
  return [...(note ? [quoted(`# ${note}`)] : []), head.join(","), ...lines, ""].join("\r\n");
}

function download(name, blob) {
  const address = URL.createObjectURL(blob);
  const link = element("a", { href: address, download: name });
  link.click();
  // After the browser has taken it.
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

// The original report, names of files, and a line that all files have. A page that computes has others for changed data.
const saved = { json: () => sourceInDecimals(), name: (name) => name, note: () => "" };

function downloadButton(name, make) {
  const button = element("button", { type: "button", "data-file": name }, name);
  button.addEventListener("click", async () => {
    // A film takes its time.
    button.disabled = true;
    try {
      download(saved.name(name), await make());
    } finally {
      button.disabled = false;
    }
  });
  return button;
}

function startDownloads() {
  const csv = report.tables.map((table) =>
    downloadButton(`${table.function}.csv`, () => new Blob([csvOf(columns.filter((column) => column.table === table.function))], { type: "text/csv" })));
  const copy = downloadButton("page.html", async () => new Blob([host === null ? pageCopy() : await host.page()], { type: "text/html" }));
  const json = downloadButton("data.json", () => new Blob([saved.json()], { type: "application/json" }));
  addSheet("Data", true,
    ...(report.thinned ? [element("p", {}, thinnedText())] : []),
    element("p", {}, "All values of the page with all their digits. Angles are in radians; a value that does not exist is empty in CSV and null in JSON."),
    element("p", { class: "buttons" }, json, ...csv, copy),
    element("p", {}, "The mechanism and the plots as they are seen now."),
    element("p", { class: "buttons" }, ...pictureButtons()));
}
