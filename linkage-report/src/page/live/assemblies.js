// Other assemblies: groups with two modes are turned over, groups without a closed form have further solutions.

// More modes than this are not listed: every one doubles the number of assemblies.
const MOST_MODES = 6;
// Two assemblies of one mechanism differ by more than this in the numbers of their states.
const SAME_STATE = 1e-4;

// Assemblies of the first programs, as everywhere where modes are: all that close with these
// dimensions, the modes of the report first.
function assembliesNow() {
  const [unit] = engine.programs;
  const values = valuesOf(unit, live.dimensions);
  const all = modesNow(unit).flatMap((modes) =>
    unit.coupled.length === 0 ? [{ modes, states: [] }] : engine.solutionsAt(unit, values, modes).map((states) => ({ modes, states })));
  const found = all.filter((own) => closes(unit, values, own));
  // A search from many places may miss the one that is shown.
  return found.some(isThisAssembly) ? found : [assemblyNow(), ...found];
}

function modesNow({ modes: { length } }) {
  if (length === 0 || length > MOST_MODES) return [live.modes];
  return Array.from({ length: 2 ** length }, (_, flips) => live.firstModes.map((mode, k) => ((flips >> k) & 1 ? -mode : mode)));
}

function closes(unit, values, { modes, states }) {
  try {
    engine.assembled(unit, values, modes, engine.standing(unit, values, modes, states));
    return true;
  } catch (thrown) {
    if (thrown instanceof engine.AssemblyError) return false;
    throw thrown;
  }
}

// The states that the present assembly has at the reference inputs.
function statesNow() {
  return live.assemblies[0].known().map(({ state }) => [...state]);
}

function isThisAssembly({ modes, states }) {
  const own = statesNow().flat();
  return modes.join() === live.modes.join() && states.flat().every((x, k) => Math.abs(x - own[k]) < SAME_STATE);
}

// A word for each: the signs of the modes, and a number if one of the solutions with them is meant.
function assemblyText({ modes, states }, all) {
  const signs = modes.map((mode) => (mode > 0 ? "+" : "\u2212")).join(" ");
  const alike = all.filter((other) => other.modes.join() === modes.join());
  return states.length === 0 ? signs : `${signs} ${alike.findIndex((other) => other.states === states) + 1}`.trim();
}

function assemblyChoice() {
  const select = element("select", { id: "assembly", "aria-label": "Assembly" });
  select.addEventListener("change", () => choose(choices.all[Number(select.value)]));
  // The list is computed when somebody wants to choose.
  for (const event of ["pointerdown", "focus"]) select.addEventListener(event, () => searchAssemblies(select));
  fillAssemblies(select, [assemblyNow()]);
  return element("label", { class: "choices" }, "Assembly ", select);
}

// The content of the list, the dimensions for which it was searched (null where it was not), and
// the number of choices.
const choices = { all: [], of: null, made: 0 };

// A press brings the focus, too: one search is enough.
function searchAssemblies(select) {
  if (choices.of === live.assemblies) return;
  fillAssemblies(select, assembliesNow());
  choices.of = live.assemblies;
}

function assemblyNow() {
  return { modes: live.modes, states: statesNow() };
}

function choose(own) {
  if (!takeAssembly(own, live.dimensions)) {
    // The list is of other dimensions: undone steps leave it as it was.
    say("With these dimensions that assembly does not close.");
    showControls();
    return;
  }
  if (own.states.length > 0 && isThatOfTheReport(own.modes, own.states)) backToSolution();
  tell(change(new Map()));
  keepStep();
}

// Another assembly with these dimensions, for all that follows; if it does not close there, all is as before, and the answer is false.
function takeAssembly({ modes, states }, dimensions) {
  const [unit] = engine.programs;
  const before = live.modes;
  const start = states.length === 0 ? live.assemblies : live.assemblies.with(0, engine.standing(unit, valuesOf(unit, dimensions), modes, states));
  live.modes = modes;
  try {
    take(dimensions, assembledWith(dimensions, start));
  } catch (thrown) {
    if (!(thrown instanceof engine.AssemblyError)) throw thrown;
    live.modes = before;
    return false;
  }
  if (states.length > 0) live.choice = choices.made += 1;
  return true;
}

// With no other dimensions: then the report's own numbers are shown.
function isThatOfTheReport(modes, states) {
  const first = live.firstAssemblies[0].known().flatMap(({ state }) => [...state]);
  const isNear = states.flat().every((x, k) => Math.abs(x - first[k]) < SAME_STATE);
  return isNear && modes.join() === live.firstModes.join() && changedOnes().length === 0;
}

function backToSolution() {
  live.choice = 0;
  live.assemblies = live.firstAssemblies;
}

function fillAssemblies(select, all) {
  Object.assign(choices, { all, of: null });
  const text = (own) => (all.length === 1 && own.states.length > 0 ? `${assemblyText({ ...own, states: [] }, all)} \u2026`.trim() : assemblyText(own, all));
  select.replaceChildren(...all.map((own, index) => element("option", { value: index }, text(own))));
  select.value = all.findIndex(isThisAssembly);
}

// A list that has the present assembly stays as it is.
function showAssembly(select) {
  const index = choices.all.findIndex(isThisAssembly);
  if (index < 0) fillAssemblies(select, [assemblyNow()]);
  else select.value = index;
}
