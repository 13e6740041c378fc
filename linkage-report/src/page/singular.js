// Singular positions: forces grow without bound there, although all loops close.

// Forces below this part of the largest one at their position are rounding.
const FORCE_ROUNDING = 1e-6;
// The reciprocal of a force is nearly straight through a pole, compared with its change over it.
const BENT = 0.4;

// Where the forces of the report grow without bound; null if they do nowhere.
function singularWords() {
  const forces = columns.filter(({ unit, meaning }) => meaning === "value" && /(^|[^A-Za-z])N([^A-Za-z]|$)/.test(unit));
  const found = new Map();
  for (const { name, values } of forces) {
    for (let row = 1; row + 2 < rowCount; row += 1) {
      const share = poleBetween(values, row);
      if (share === null || !isLargeForce(forces, values, row)) continue;
      const at = input.values[row] + share * (input.values[row + 1] - input.values[row]);
      found.set(row, { at, names: [...(found.get(row)?.names ?? []), name] });
    }
  }
  if (found.size === 0) return null;
  const places = [...found.values()].map(({ at, names }) => `${listed([...new Set(names)])} at ${input.name} = ${singularPlace(at)}`);
  return `Forces grow without bound at singular positions, which the mechanism passes: ${places.join("; ")}.`;
}

function listed(names) {
  return names.length > 1 ? `${names.slice(0, -1).join(", ")} and ${names.at(-1)}` : names[0];
}

function singularPlace(value) {
  const unit = plotUnit(input.unit);
  return `${digits(rounded(plotValue(value, input.unit), 4))}${unit ? " " + unit : ""}`;
}

// The place of a pole between a row and the next one, as a share of the step; null if the force stays finite.
function poleBetween(values, row) {
  // Most forces keep their sign.
  if (!(values[row] * values[row + 1] < 0)) return null;
  const four = values.slice(row - 1, row + 3);
  if (four.includes(null)) return null;
  const [before, from, to, after] = four.map((value) => 1 / value);
  const rise = to - from;
  const bends = [before - 2 * from + to, from - 2 * to + after];
  return bends.every((bend) => Math.abs(bend) < BENT * Math.abs(rise)) ? -from / rise : null;
}

function isLargeForce(forces, values, row) {
  const most = (own) => Math.max(...[row, row + 1].map((at) => Math.abs(own[at] ?? 0)));
  return most(values) > FORCE_ROUNDING * Math.max(...forces.map((column) => most(column.values)));
}
