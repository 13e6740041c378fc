// The arguments of functions at the rows of the report: its input runs, all others are given.

function isKnown(name) {
  return name === input.name || live.given.has(name);
}

// A function of the row that returns the arguments of these names, always in the same list.
function argumentsAt(names) {
  const at = argumentsOf(names);
  return (row) => at(input.values[row]);
}
