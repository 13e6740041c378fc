// The abscissa of the plots: the input, the time that it takes, or a quantity.

// A quantity, or a steady speed of the input for the time.
const abscissa = { column: null, speed: null };

function isAgainstInput() {
  return abscissa.column === null;
}

function abscissaUnit() {
  if (abscissa.speed !== null) return "s";
  return plotUnit((abscissa.column ?? input).unit);
}

function abscissaTitle() {
  return titled(abscissa.speed !== null ? "t" : (abscissa.column ?? input).name, abscissaUnit());
}

// Values of the abscissa as they are shown; null where there is none.
function abscissaValues() {
  if (isAgainstInput()) return input.values.map(inputPlace);
  const { values, unit } = abscissa.column;
  return values.map((value) => plotValue(value, unit));
}

// A value of the input on the abscissa, and back. A speed with the other sign begins at the other end.
function inputPlace(value) {
  return abscissa.speed === null ? plotValue(value, input.unit) : (value - timeBegin()) / abscissa.speed;
}

function inputAtPlace(place) {
  return abscissa.speed === null ? fromPlot(place, input.unit) : place * abscissa.speed + timeBegin();
}

function timeBegin() {
  return input.values[abscissa.speed * span() < 0 ? rowCount - 1 : 0];
}

// A derivative with respect to the input is one with respect to time, if that is the abscissa; other columns are as they are.
function timedColumn(column) {
  const { meaning, order, of, table, unit } = column;
  if (abscissa.speed === null || meaning !== "rate") return column;
  const per = `/${input.unit}${order > 1 ? `^${order}` : ""}`;
  const whole = columns.find((own) => own.table === table && own.name === of && own.meaning === "value")?.unit;
  const stem = whole ?? (unit.endsWith(per) ? unit.slice(0, -per.length) : null);
  if (stem === null) return column;
  const factor = abscissa.speed ** order;
  return {
    ...column,
    unit: `${stem || "1"}/s${order > 1 ? `^${order}` : ""}`,
    get values() {
      return column.values.map((value) => (value === null ? null : value * factor));
    },
  };
}

// Speeds of angles are revolutions per minute.
const TURNING = Math.PI / 30;
const FIRST_TURNING = 60;

// The field of the speed. A report with a speed of its own has its true velocities for that, and stays with it.
function speedField() {
  const unit = input.unit === "rad" ? "rpm" : `${input.unit || "1"}/s`;
  const factor = input.unit === "rad" ? TURNING : 1;
  const own = report.speed?.omega;
  const field = element("input", { id: "turning", type: "text", size: 5, autocomplete: "off", "aria-label": `Speed of ${input.name} in ${unit}`, disabled: own !== undefined });
  field.value = String(own === undefined ? (input.unit === "rad" ? FIRST_TURNING : 1) : rounded(own / factor, 6));
  const label = element("label", { id: "timed", class: "aside", hidden: true }, "at ", field, ` ${unit}`);
  const take = () => {
    const number = Number(field.value.trim().replace(",", "."));
    const isSpeed = field.value.trim() !== "" && Number.isFinite(number) && number !== 0;
    set(field, { "aria-invalid": !isSpeed && "true" });
    if (!isSpeed) return;
    abscissa.speed = own ?? number * factor;
    showAll();
  };
  field.addEventListener("change", take);
  return { label, take };
}

// The ends of the axis that shows all: those of the input, or some air about a quantity.
function wholeAbscissa() {
  const known = abscissaValues().filter((x) => x !== null);
  const ends = known.reduce(([low, high], x) => [Math.min(low, x), Math.max(high, x)], [Infinity, -Infinity]);
  return isAgainstInput() ? ends : withMargin(ends);
}

function abscissaChoice() {
  const { label, take } = speedField();
  // An accelerated input has no time of its own at a position, and the input of a motion is the time.
  const time = report.speed?.epsilon || driven !== null ? [] : [element("option", { value: "time" }, "time")];
  const select = element("select", { id: "abscissa" }, element("option", { value: "" }, input.name), ...time);
  for (const [title, members] of grouped()) {
    const options = members.filter(finite).map((column) => element("option", { value: column.key }, titled(column.name, column.unit)));
    if (options.length > 0) select.append(element("optgroup", { label: title }, ...options));
  }
  select.addEventListener("change", () => {
    abscissa.column = columns.find((column) => column.key === select.value) ?? null;
    abscissa.speed = null;
    label.hidden = select.value !== "time";
    if (label.hidden) showAll();
    else take();
  });
  return [element("label", { class: "aside" }, "Against ", select), label];
}

// The row at a place of a panel: with the nearest input, or with the nearest place of a curve.
function rowAtPlace({ scales, curves }, [x, y]) {
  if (isAgainstInput()) {
    return nearestRow(inputAtPlace(scales.value(x)));
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
