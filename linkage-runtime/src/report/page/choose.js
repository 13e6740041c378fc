// Which columns are plotted.

const MEANINGS = {
  value: "values",
  rate: "analogues",
  true: "true velocities and accelerations",
  sensitivity: "sensitivities",
  margin: "margin",
  picture: "points of the picture",
};

// Curves at the start: enough to see what there is, few enough to tell them apart.
const FIRST_CURVES = 3;

const chosen = new Set();

// Values, then what is derived from them; a table that is a picture alone shows the traced points.
function firstChoice() {
  const few = (meaning) => columns.filter((column) => column.meaning === meaning && finite(column)).slice(0, FIRST_CURVES);
  const rates = few("true").length > 0 ? few("true") : few("rate");
  const some = [...few("value"), ...rates];
  return some.length > 0 ? some : tracedColumns();
}

function finite(column) {
  return column.values.some((value) => value !== null);
}

function tracedColumns() {
  const traced = (picture?.traces ?? []).map((index) => picture.points[index].name);
  const shown = columns.filter((column) => column.meaning === "picture" && finite(column));
  const named = shown.filter((column) => traced.some((name) => column.name.includes(name)));
  return (named.length > 0 ? named : shown).slice(0, FIRST_CURVES);
}

function startChooser(changed) {
  for (const column of firstChoice()) chosen.add(column.key);
  const groups = [];
  for (const [title, members] of grouped()) groups.push(chooserGroup(title, members, changed));
  const count = element("span", { class: "count" });
  const search = element("input", { type: "search", placeholder: "Find by name", "aria-label": "Find quantities by name" });
  search.addEventListener("input", () => filterChoices(search.value));
  const box = fold("Quantities ", false, search, element("div", { class: "groups" }, ...groups));
  box.id = "quantities";
  box.firstChild.append(count);
  byId("chooser").append(box);
  const tell = () => { count.textContent = `${chosen.size} of ${columns.length}`; };
  box.addEventListener("change", tell);
  tell();
}

function grouped() {
  const groups = new Map();
  for (const column of columns) {
    const title = `${column.table}: ${MEANINGS[column.meaning] ?? column.meaning}`;
    if (!groups.has(title)) groups.set(title, []);
    groups.get(title).push(column);
  }
  return groups;
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
  return element("label", { class: "choice" }, box, ` ${column.name}`, element("small", {}, column.unit ? ` ${column.unit}` : ""));
}

function filterChoices(words) {
  for (const label of document.querySelectorAll("#chooser .choice")) {
    label.hidden = !label.textContent.toLowerCase().includes(words.toLowerCase());
  }
  for (const group of document.querySelectorAll("#chooser fieldset")) {
    group.hidden = group.querySelector(".choice:not([hidden])") === null;
  }
}
