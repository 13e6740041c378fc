// Other assemblies: groups with two modes are turned over.

// More modes than this are not listed: every one doubles the number of assemblies.
const MOST_MODES = 6;

// All modes in which the mechanism closes with these dimensions, those of the report first.
function assembliesNow() {
  const [unit] = engine.programs;
  const count = unit.modes.length;
  if (count === 0 || count > MOST_MODES) return [live.modes];
  const first = live.firstModes;
  const all = Array.from({ length: 2 ** count }, (_, flips) => first.map((mode, k) => ((flips >> k) & 1 ? -mode : mode)));
  return all.filter(closes);
}

function closes(modes) {
  const before = live.modes;
  live.modes = modes;
  try {
    assembledWith(live.dimensions, live.assemblies);
    return true;
  } catch (thrown) {
    if (thrown instanceof engine.AssemblyError) return false;
    throw thrown;
  } finally {
    live.modes = before;
  }
}

// A word for each: the signs of the modes.
function modesText(modes) {
  return modes.map((mode) => (mode > 0 ? "+" : "\u2212")).join(" ");
}

function assemblyChoice() {
  const select = element("select", { id: "assembly", "aria-label": "Assembly" });
  select.addEventListener("change", () => {
    live.modes = select.value.split(",").map(Number);
    tell(change(new Map()));
    keepStep();
  });
  // Which ones there are is asked when somebody wants to choose.
  for (const event of ["pointerdown", "focus"]) select.addEventListener(event, () => fillAssemblies(select, assembliesNow()));
  fillAssemblies(select, [live.modes]);
  return element("label", { class: "choices" }, "Assembly ", select);
}

function fillAssemblies(select, all) {
  const options = all.map((modes) => element("option", { value: modes.join() }, modesText(modes)));
  select.replaceChildren(...options);
  select.value = live.modes.join();
}
