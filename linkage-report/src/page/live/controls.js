// Sliders and numbers for dimensions and other inputs, and the buttons beside them.

// The range of a slider on both sides: a part of the dimension, for angles so many radians.
const REACH = { part: 0.5, angle: Math.PI / 2 };

const controls = { rows: new Map() };

function startLive() {
  startModel();
  startGhost();
  startChanges();
  startText();
  makeControls();
  onChange(showChange);
  onChange(showControls);
  const changes = host === null ? location.hash || `#${document.documentElement.dataset.changes ?? ""}` : "#";
  if (changes === "#") showControls();
  else say(readLink(changes));
  past.last = snapshot();
  listen(document, "keydown", onLiveKey);
  listen(window, "hashchange", ({ newURL }) => {
    // The page may have written its own address before it hears of a new one.
    const { hash } = new URL(newURL);
    if (hash.slice(1) === fragment()) return;
    say(readLink(hash));
    keepStep();
  });
  // A page that goes has its last change in its address.
  listen(window, "pagehide", () => link.waiting !== null && writeLinkNow());
  startPulling();
  if (picture) byId("hint").firstChild.after(" Pull pivots and bars to change dimensions, with shift to all digits.");
}

function makeControls() {
  const rows = [];
  for (const { name, unit } of report.dimensions) rows.push(controlRow(name, unit, (to, stop) => change(new Map([[name, to]]), stop)));
  for (const name of live.given.keys()) {
    const own = argumentOf(name);
    rows.push(controlRow(name, own.unit, (to) => give(name, to)));
  }
  const copy = (id, word, make) => pushButton(id, word, `Copy: ${word}`, () => copyText(make()));
  const buttons = element("div", { class: "line buttons" },
    pushButton("reset", "Reset", "All as in the report", resetAll),
    pushButton("undo", "Undo", "Undo (ctrl z)", undo),
    pushButton("redo", "Redo", "Redo (ctrl y)", redo),
    keepButton(),
    ...(live.firstModes.length > 0 || engine.programs[0].coupled.length > 0 ? [assemblyChoice()] : []),
    element("span", { class: "choices" }, "Copy ", copy("copy-rust", "Rust", asRust), copy("copy-text", "text", asText), ...(host === null ? [copy("copy-link", "link", addressNow)] : [])));
  const says = element("p", { id: "says", role: "status" });
  // On a phone the plots come first.
  const box = fold("Change dimensions", matchMedia("(min-width: 861px)").matches, buttons, says, element("div", { class: "dimensions" }, ...rows));
  box.id = "live";
  byId("stage").append(box);
}

// The range of a slider: about the value in the report, or that of an argument.
function rangeOf(name, unit) {
  return (live.stands.has(name) && argumentOf(name).range) || dimensionRange(unit, valueInReport(name));
}

function dimensionRange(unit, value) {
  const half = unit === "rad" ? REACH.angle : REACH.part * (Math.abs(value) || largestDimension(unit));
  return [value - half, value + half];
}

function largestDimension(unit) {
  return Math.max(0, ...report.dimensions.filter((own) => own.unit === unit).map(({ value }) => Math.abs(value))) || 1;
}

function argumentOf(name) {
  for (const unit of engine.programs) {
    const own = [...unit.inputs, ...unit.arguments].find((one) => one.name === name);
    if (own !== undefined) return own;
  }
  return { unit: "" };
}

// Angles are shown in degrees. `put` takes a value, and gives the error if the mechanism cannot be assembled with it.
function controlRow(name, unit, put) {
  const shown = (number) => rounded(plotValue(number, unit), 12);
  const slider = element("input", { type: "range", step: "any", "data-slides": name, "aria-label": name });
  const field = element("input", { type: "text", autocomplete: "off", spellcheck: "false", "data-dimension": name, "aria-label": `${name}${unit ? ` in ${plotUnit(unit)}` : ""}` });
  const row = { name, unit, slider, field, shown, put, refused: null };
  slider.addEventListener("pointermove", ({ shiftKey }) => (row.exact = shiftKey));
  slider.addEventListener("input", () => whenDrawn(() => slide(row)));
  slider.addEventListener("change", () => { drawNow(); keepStep(); });
  field.addEventListener("change", () => takeTyped(row));
  field.addEventListener("keydown", (event) => onFieldKey(event, row));
  controls.rows.set(name, row);
  centre(row);
  return element("label", { class: "dimension" }, element("span", { class: "name" }, ...breakable(name)), slider, field, element("small", {}, plotUnit(unit), ...[runButton(row)].filter((own) => own !== null)));
}

function centre({ name, unit, slider, shown }) {
  const [low, high] = rangeOf(name, unit).map(shown);
  set(slider, { min: low, max: high });
}

// A long name goes on after a point or a low line.
function breakable(name) {
  return name.split(/(?<=[._])/).flatMap((part, k) => (k === 0 ? [part] : [element("wbr"), part]));
}

// A slider tells as many digits as its pixels do.
function slide({ name, unit, slider, put, exact }) {
  const step = exact ? null : stepOfPixel((slider.max - slider.min) / slider.clientWidth);
  tell(put(fromPlot(toStep(Number(slider.value), step), unit), stopAtStep([name], step)));
}

// At most one change for each picture that the screen shows.
const waiting = { change: null, asked: false };

function whenDrawn(make) {
  waiting.change = make;
  if (waiting.asked) return;
  waiting.asked = true;
  requestAnimationFrame(drawNow);
}

function drawNow() {
  waiting.asked = false;
  const make = waiting.change;
  waiting.change = null;
  if (make !== null) make();
}

function showControls() {
  const assembly = byId("assembly");
  if (assembly !== null) showAssembly(assembly);
  for (const [name, row] of controls.rows) {
    const { slider } = row;
    // Rounding takes longer than all the rest.
    if (row.now !== valueNow(name)) Object.assign(row, { now: valueNow(name), value: row.shown(valueNow(name)) });
    const { value } = row;
    showField(row);
    if (value < Number(slider.min)) slider.min = value;
    if (value > Number(slider.max)) slider.max = value;
    if (slider.value !== String(value)) slider.value = value;
    row.field.closest("label").classList.toggle("changed", valueNow(name) !== valueInReport(name));
  }
  showHistory();
}

function sayingOf(error) {
  return error === null ? null : `That far and no farther. ${error.message}`;
}

function tell(error) {
  say(sayingOf(error));
}

function say(text) {
  const still = live.tables.filter(({ why }) => why !== null).map(({ table, why }) => `${table.function} is not computed here: ${why}.`);
  const all = [text, ...refusals(), ...negativeLengths(), ...(isChanged() ? still : [])].filter((own) => own !== null);
  byId("says").textContent = all.join(" ");
}

function copyText(text) {
  const field = element("textarea", { class: "copied", readonly: true });
  field.value = text;
  document.body.append(field);
  field.select();
  // Pages that were opened as files have no other way to the clipboard in some browsers.
  const done = document.execCommand("copy");
  field.remove();
  byId("says").textContent = done ? `Copied: ${text}` : text;
}

function onLiveKey(event) {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return;
  // What is being typed has its own steps.
  if ([...controls.rows.values()].some(({ field, written }) => field === event.target && field.value !== written)) return;
  if (key === "y" || event.shiftKey) redo();
  else undo();
  event.preventDefault();
}
