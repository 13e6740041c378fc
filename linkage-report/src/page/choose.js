// The choice of plotted columns.

const MEANINGS = {
  value: "values",
  rate: "analogues",
  true: "true velocities and accelerations",
  sensitivity: "sensitivities",
  margin: "margin",
  picture: "points of the picture",
};

// Curves at the start: enough to get an impression, few enough to be distinguished.
const FIRST_VALUES = 3;
const FIRST_RATES = 6;
// And of one function that is asked for.
const MOST_VALUES = 12;
// And of a motion under forces.
const MOST_OF_MOTION = 24;

const chosen = new Set();
// Shows in the boxes and on the buttons what is chosen.
let showChoice = null;

// The values that the functions list first, with their derivatives by time, or by the input.
function firstChoice() {
  if (driven !== null) return columns.filter((column) => finite(column) && isOfMotion(column)).slice(0, MOST_OF_MOTION);
  const some = firstAmong(() => true);
  return some.length > 0 ? some : firstOf("picture", isTraced, FIRST_VALUES);
}

// Inputs, speeds and results of a motion under forces.
function isOfMotion({ table, meaning }) {
  return [driven.state, driven.table].some((index) => report.tables[index].function === table) && meaning !== "picture" && meaning !== "sensitivity";
}

function firstAmong(fits, most = FIRST_VALUES) {
  const values = firstOf("value", fits, most);
  const names = values.map((column) => column.name);
  const ofThem = (column) => fits(column) && names.includes(column.of);
  const rates = firstOf("true", ofThem, FIRST_RATES);
  return [...values, ...(rates.length > 0 ? rates : firstOf("rate", ofThem, FIRST_RATES))];
}

// The first columns of a meaning with numbers in them. A column of several tables is shown once,
// with its bands if it has some.
function firstOf(meaning, fits, most) {
  const some = columns.filter((column) => column.meaning === meaning && finite(column) && fits(column));
  const named = Map.groupBy(some, (column) => column.name);
  const once = [...named.values()].map((same) => same.find((column) => column.bands.length > 0) ?? same[0]);
  const first = once.slice(0, most);
  // Not half of a vector.
  const rest = once.slice(most).filter((column) => first.some((other) => vectorOf(column) === vectorOf(other)));
  return [...first, ...rest];
}

function vectorOf({ name }) {
  return name.replace(/\.[xyz]$/, "");
}

function finite(column) {
  return column.values.some((value) => value !== null);
}

// Returns true for a column of a traced point, as `p.x` and `shape[p].x` are of `p`.
function isTraced(column) {
  const traced = (picture?.traces ?? []).map((index) => picture.points[index].name);
  return traced.some((name) => column.name.startsWith(`${name}.`) || column.name.includes(`[${name}]`));
}

function startChooser(changed) {
  for (const key of before?.chosen ?? firstChoice().map((column) => column.key)) chosen.add(key);
  const groups = [];
  for (const [title, members] of grouped()) groups.push(chooserGroup(title, members, changed));
  const count = element("span", { class: "count" });
  const search = element("input", { type: "search", placeholder: "Find by name", "aria-label": "Find quantities by name" });
  search.addEventListener("input", () => filterChoices(search.value));
  const box = fold("Quantities ", false, search, element("div", { class: "groups" }, ...groups));
  box.id = "quantities";
  box.firstChild.append(count);
  byId("chooser").append(box);
  const switches = functionSwitches(changed);
  if (switches.length > 1) byId("chooser").prepend(element("div", { id: "functions", role: "group", "aria-label": "Functions in the plots" }, "Plots of", ...switches));
  showChoice = () => {
    count.textContent = `${chosen.size} of ${columns.length}`;
    for (const own of box.querySelectorAll("[data-column]")) own.checked = chosen.has(own.dataset.column);
    for (const own of switches) own.setAttribute("aria-pressed", shownPart(own.dataset.function));
  };
  box.addEventListener("change", showChoice);
  showChoice();
}

// A button for each function with values, which plots all of them that are not plotted, or none.
function functionSwitches(changed) {
  const names = new Set(columns.filter((column) => column.meaning === "value" && finite(column)).map(({ table }) => table));
  return [...names].map((name) => {
    const button = element("button", { type: "button", "data-function": name, title: `Plots of the function ${name}` }, name);
    button.addEventListener("click", () => {
      if (shownPart(name) === "true") for (const { key } of chosenOf(name)) chosen.delete(key);
      else for (const { key } of missingOf(name)) chosen.add(key);
      showChoice();
      changed();
    });
    return button;
  });
}

// What is plotted of the values of a function, by other functions of the same names, too.
function shownPart(name) {
  if (missingOf(name).length === 0) return "true";
  return chosenOf(name).length > 0 ? "mixed" : "false";
}

function missingOf(name) {
  const plottedNames = new Set(columns.filter(({ key }) => chosen.has(key)).map((column) => column.name));
  return firstAmong(({ table }) => table === name, MOST_VALUES).filter((column) => !plottedNames.has(column.name));
}

function chosenOf(name) {
  return columns.filter(({ table, key }) => table === name && chosen.has(key));
}

function grouped() {
  return Map.groupBy(columns, ({ table, meaning }) => `${table}: ${MEANINGS[meaning] ?? meaning}`);
}

function chooserGroup(title, members, changed) {
  const boxes = members.map((column) => choiceBox(column, changed));
  return element("fieldset", {}, element("legend", {}, title), ...boxes);
}

function choiceBox(column, changed) {
  const box = element("input", { type: "checkbox", "data-column": column.key, checked: chosen.has(column.key) });
  box.addEventListener("change", () => {
    if (box.checked) chosen.add(column.key);
    else chosen.delete(column.key);
    changed();
  });
  return element("label", { class: "choice" }, box, ` ${column.name}`, element("small", {}, column.unit ? ` ${plotUnit(column.unit)}` : ""));
}

function filterChoices(words) {
  for (const label of document.querySelectorAll("#chooser .choice")) {
    label.hidden = !label.textContent.toLowerCase().includes(words.toLowerCase());
  }
  for (const group of document.querySelectorAll("#chooser fieldset")) {
    group.hidden = group.querySelector(".choice:not([hidden])") === null;
  }
}
