// Figures and dimensions, a column for each design that is shown. The others are compared with the
// first one.

function part(value, first) {
  if (value === null || first === null || value === first) return [];
  const change = (100 * (value - first)) / Math.abs(first);
  // Zero has no parts.
  if (!Number.isFinite(change)) return [];
  const words = Math.abs(change) < 0.005 ? "0" : rounded(change, 3).toString();
  return [element("small", {}, `${change > 0 ? "+" : ""}${words} %`)];
}

// A number below this part of the largest of its row is the rounding of zero.
const NOTHING = 1e-13;

function settled(values) {
  const largest = Math.max(...values.map(Math.abs));
  return values.map((value) => (value !== null && Math.abs(value) < NOTHING * largest ? 0 : value));
}

function table(caption, rows) {
  const columns = shown();
  const head = columns.map((index) => {
    const { name, page } = data.designs[index];
    return element("th", { scope: "col" }, swatch(index), " ", page === null ? name : element("a", { href: page }, name));
  });
  const body = rows.map(({ name, unit, values }) => {
    const own = settled(values.map((value) => plotValue(value, unit)));
    const cells = columns.map((index) => element("td", {}, short(own[index]), ...part(own[index], own[columns[0]])));
    return element("tr", {}, element("th", { scope: "row" }, labelled(name, plotUnit(unit))), ...cells);
  });
  const title = element("caption", {}, caption);
  return element("div", { class: "scroll" }, element("table", {}, title, element("thead", {}, element("tr", {}, element("th", {}, ""), ...head)), element("tbody", {}, ...body)));
}

// Values of the curves at this position.
function here() {
  return data.curves.map(({ name, unit }, number) => ({ name, unit, values: data.designs.map((design) => design.curves[number][state.row]) }));
}

function startTables() {
  watchers.push(() => {
    const at = withUnit(data.input.values[state.row], data.input.unit);
    const all = [
      ["Of the cycle", data.figures],
      ["Dimensions that differ", data.dimensions],
      [`At ${data.input.name} = ${at}`, here()],
    ];
    byId("tables").replaceChildren(...all.filter(([, rows]) => rows.length > 0).map(([caption, rows]) => table(caption, rows)));
  });
}
