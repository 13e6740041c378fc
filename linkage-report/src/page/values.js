// All values at the mechanism's position.

const values = { cells: [], sheet: null };

function startValues() {
  const rows = columns.map((column) => {
    const cell = element("td", { class: "number", "data-value": column.key });
    const radians = element("td", { class: "number" });
    values.cells.push({ column, cell, radians });
    return element("tr", {}, element("td", {}, column.table), element("td", {}, column.name), cell,
      element("td", {}, plotUnit(column.unit)), radians);
  });
  values.where = element("p", { class: "where" });
  const table = grid("values", ["function", "quantity", "value", "unit", ""], []);
  table.querySelector("tbody").append(...rows);
  values.sheet = fold("Values at this position", false, values.where, table);
  values.sheet.id = "values";
  byId("tables").append(values.sheet);
  // Hidden values need no work while the mechanism runs.
  values.sheet.addEventListener("toggle", () => showAllValues(position.row));
  onMove(showAllValues);
}

function showAllValues(row) {
  if (!values.sheet.open) return;
  values.where.textContent = inputText(input.values[row]);
  for (const { column, cell, radians } of values.cells) {
    const value = column.values[row];
    showNumber(cell, plotValue(value, column.unit));
    radians.replaceChildren(...inRadians(value, column.unit));
  }
}
