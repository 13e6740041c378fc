// The arguments of functions at the rows of a motion: inputs, speeds and accelerations run, loads are given.

// Numbers of all rows by the name of an argument, in the lists of the table of the state, and of the accelerations.
const course = new Map();

function startCourse() {
  const { columns: all } = report.tables[driven.state];
  for (const { name, values: numbers } of all) course.set(name, numbers);
  const results = report.tables[driven.table].columns;
  for (const { acceleration, column } of driven.inputs) if (acceleration !== null) course.set(acceleration, [...results[column].values]);
}

function isKnown(name) {
  return course.has(name) || live.given.has(name);
}

// A function of the row that returns the arguments of these names, always in the same list.
function argumentsAt(names) {
  const at = names.map((name) => live.given.get(name));
  const running = names.flatMap((name, place) => (course.has(name) ? [[place, course.get(name)]] : []));
  return (row) => {
    for (const [place, numbers] of running) at[place] = numbers[row];
    return at;
  };
}

startCourse();
