// The tables below the plots.

// Cells are words, nodes, or numbers; numbers are set to the right.
function grid(id, heads, rows) {
  const cell = (value) => {
    const number = typeof value === "number" || value === null;
    return number ? showNumber(element("td", { class: "number" }), value) : element("td", {}, value);
  };
  const names = heads.map((name) => element("th", { scope: "col" }, name));
  const head = heads.length > 0 ? [element("thead", {}, element("tr", {}, ...names))] : [];
  const body = rows.map((row) => element("tr", {}, ...row.map(cell)));
  return element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": id },
    element("table", { "data-table": id }, ...head, element("tbody", {}, ...body)));
}

// An angle, which is shown in degrees, gets its radians beside them.
function inRadians(value, unit, sign = "") {
  if (unit !== "rad" || value === null) return [];
  return [element("small", {}, showNumber(element("span"), value, sign), " rad")];
}

// A button that moves the mechanism to where something is.
function placeButton(value) {
  if (value === null || value === undefined) return "";
  const button = element("button", { type: "button", class: "place", title: inputText(value) }, inputShort(value));
  button.addEventListener("click", () => {
    setPlaying(false);
    moveTo(nearestRow(value));
  });
  return button;
}

function addSheet(title, open, ...children) {
  const sheet = fold(title, open, ...children);
  byId("tables").append(sheet);
  return sheet;
}

function startTables() {
  if (report.summary?.length) addSheet("Cycle summary", true, summaryTable(report.summary)).id = "summary";
  startMoments();
  const facts = [...speedFacts(), ...(report.facts ?? []).map(({ name, text }) => [name, text])];
  if (facts.length > 0) addSheet("Facts", true, grid("facts", [], facts));
  if (report.dimensions?.length) addSheet("Dimensions and tolerances", true, dimensionTable()).id = "dimensions";
  if (report.accuracy?.length) addSheet("Accuracy", true, ...accuracyTables()).id = "accuracy";
  if (report.structure) addSheet("Structure", true, ...structureTables(report.structure));
  startValues();
  startDownloads();
  if (report.notes?.length) addSheet("Notes", true, element("ul", {}, ...report.notes.map((note) => element("li", {}, note))));
}

// The speed that all true velocities, accelerations and forces belong to.
function speedFacts() {
  if (!report.speed) return [];
  const { omega, epsilon } = report.speed;
  const per = (time) => `${input.unit || "1"}/${time}`;
  const turns = input.unit === "rad" ? ` (${short((omega * 30) / Math.PI)} revolutions per minute)` : "";
  const speed = [`Speed of ${input.name}`, `${short(omega)} ${per("s")}${turns}`];
  return epsilon ? [speed, [`Acceleration of ${input.name}`, `${short(epsilon)} ${per("s^2")}`]] : [speed];
}

// A row that `stands` is that of the report, and not of changed dimensions.
function summaryTable(figures) {
  const rows = figures.map(({ quantity, what, value, unit, at, stands }) =>
    [quantity, stands ? `${what} (as in the report)` : what, placeButton(at), withDegrees(value, unit), plotUnit(unit)]);
  // Places before values: on a phone they must not be out of sight.
  return grid("summary", ["quantity", "what", `at ${input.name}`, "value", "unit"], rows);
}

function dimensionTable(actualOf = ({ value }) => value) {
  const changed = report.dimensions.some((own) => actualOf(own) !== own.nominal);
  const rows = report.dimensions.map((own) => {
    const { name, unit, nominal, tolerance } = own;
    const actual = changed ? [actualOf(own) === nominal ? "" : withDegrees(actualOf(own), unit)] : [];
    return [name, withDegrees(nominal, unit), tolerance === 0 ? "" : withDegrees(tolerance, unit, "\u00b1 "), ...actual, plotUnit(unit)];
  });
  return grid("dimensions", ["dimension", "nominal", "tolerance", ...(changed ? ["actual"] : []), "unit"], rows);
}

// A number, the radians of an angle on a line below.
function withDegrees(value, unit, sign = "") {
  return element("span", { class: "amount" }, showNumber(element("span"), plotValue(value, unit), sign), ...inRadians(value, unit, sign));
}

function accuracyTables() {
  contributions.folds = report.accuracy.map((_, index) => contributionsFold(index));
  return [accuracyGrid(), ...contributions.folds.map(({ box }) => box)];
}

function accuracyGrid() {
  const rows = report.accuracy.map(({ quantity, worst, statistical, unit, at }) =>
    [quantity, plotValue(worst, unit), plotValue(statistical, unit), plotUnit(unit), placeButton(at)]);
  return grid("accuracy", ["quantity", "worst case \u00b1", "statistical \u00b1", "unit", `at ${input.name}`], rows);
}

// The contributors to the worst case. Closed rows are rebuilt when they are opened.
const contributions = { folds: [] };

function contributionsFold(index) {
  const box = fold(`Contributions to ${report.accuracy[index].quantity}`, false, contributionsGrid(index));
  const own = { box, old: false, refresh };
  function refresh() {
    if (own.old) box.lastChild.replaceWith(contributionsGrid(index));
    own.old = false;
  }
  box.addEventListener("toggle", refresh);
  return own;
}

// The largest first, with bars.
function contributionsGrid(index) {
  const { quantity, unit, worst, contributions: parts } = report.accuracy[index];
  const sorted = [...parts].sort((a, b) => Math.abs(b.amount) - Math.abs(a.amount));
  const rows = sorted.map(({ parameter, amount }) => {
    const share = worst ? (100 * Math.abs(amount)) / worst : 0;
    const bar = element("span", { class: "bar", style: `width: ${share.toFixed(1)}%` });
    return [parameter, plotValue(amount, unit), plotUnit(unit), element("span", { class: "bars", title: `${share.toFixed(1)} %` }, bar)];
  });
  return grid(`contributions ${quantity}`, ["dimension", "amount", "unit", "share of the worst case"], rows);
}

function structureTables({ mobility, groups, functions, prepare }) {
  const rows = groups.map((group, index) => [
    index + 1, group.kind, group.class || "", group.order || "", group.mode ?? "",
    group.joints || group.loops.join(", "), group.unknowns.join(", "), group.method,
  ]);
  const closed = groups.some(({ joints }) => joints) ? "joints" : "loops";
  const heads = ["group", "kind", "class", "order", "mode", closed, "unknowns", "method"];
  const counts = [["assemble", prepare], ...(functions ?? []).map((item) => [item.name, item.operations ?? item])];
  const costs = counts.filter(([, operations]) => operations).map(([name, operations]) => [name, ...costOf(operations)]);
  return [
    element("p", {}, `Mobility ${mobility}.`),
    groups.length > 0 ? withHeads(grid("groups", heads, rows), heads) : "",
    grid("operations", ["function", "operations", "of which"], costs),
  ];
}

// Each cell has the head of its column, for screens that are too narrow for columns.
function withHeads(box, heads) {
  for (const row of box.querySelectorAll("tbody tr")) [...row.cells].forEach((cell, k) => set(cell, { "data-head": heads[k] }));
  return box;
}

// The same text as in print.
const OPERATIONS = ["add", "mul", "div", "sqrt", "sin_cos", "atan2", "other"];

function costOf(operations) {
  const kinds = OPERATIONS.map((kind) => [kind, operations[kind] ?? 0]).filter(([, count]) => count > 0);
  const total = kinds.reduce((sum, [, count]) => sum + count, 0);
  return [total, kinds.map(([kind, count]) => `${count} ${kind}`).join(", ")];
}
