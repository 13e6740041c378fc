// The abscissa of the plots: the input, or a quantity.

const abscissa = { column: null };

function isAgainstInput() {
  return abscissa.column === null;
}

function abscissaTitle() {
  const { name, unit } = abscissa.column ?? input;
  return titled(name, plotUnit(unit));
}

// Values of the abscissa as they are shown; null where there is none.
function abscissaValues() {
  const { values, unit } = abscissa.column ?? input;
  return values.map((value) => plotValue(value, unit));
}

// The ends of the axis that shows all: those of the input, or some air about a quantity.
function wholeAbscissa() {
  const known = abscissaValues().filter((x) => x !== null);
  const ends = known.reduce(([low, high], x) => [Math.min(low, x), Math.max(high, x)], [Infinity, -Infinity]);
  return isAgainstInput() ? ends : withMargin(ends);
}

function abscissaChoice() {
  const select = element("select", { id: "abscissa" }, element("option", { value: "" }, input.name));
  for (const [title, members] of grouped()) {
    const options = members.filter(finite).map((column) => element("option", { value: column.key }, titled(column.name, column.unit)));
    if (options.length > 0) select.append(element("optgroup", { label: title }, ...options));
  }
  select.addEventListener("change", () => {
    abscissa.column = columns.find((column) => column.key === select.value) ?? null;
    showAll();
  });
  return element("label", { class: "aside" }, "Against ", select);
}

// The row at a place of a panel: with the nearest input, or with the nearest place of a curve.
function rowAtPlace({ scales, curves }, [x, y]) {
  if (isAgainstInput()) {
    return nearestRow(fromPlot(scales.value(x), input.unit));
  }
  let nearest = { row: position.row, apart: Infinity };
  for (const { ys } of curves) {
    scales.xs.forEach((value, row) => {
      if (value === null || ys[row] === null) return;
      const apart = Math.hypot(scales.x(value) - x, scales.y(ys[row]) - y);
      if (apart < nearest.apart) nearest = { row, apart };
    });
  }
  return nearest.row;
}
