// All values at the mechanism's position.

const values = { cells: [], sheet: null };

function startValues() {
  const rows = columns.map((column) => {
    const cell = element("td", { class: "number", "data-value": column.key });
    const degrees = element("td", { class: "number" });
    values.cells.push({ column, cell, degrees });
    return element("tr", {}, element("td", {}, column.table), element("td", {}, column.name), cell,
      element("td", {}, column.unit), degrees);
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
  for (const { column, cell, degrees } of values.cells) {
    showNumber(cell, column.values[row]);
    degrees.textContent = inDegrees(column.values[row], column.unit);
  }
}
