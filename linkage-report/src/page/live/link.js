// The changes in the address of the page, and as text to copy.

// No dimension is called so: names have no spaces.
const MODES = "assembly modes";
const START = "assembly start";

function fragment() {
  const modes = areOtherModes() ? [[MODES, live.modes.join()]] : [];
  // Steps begin so near to the solution that these digits are enough.
  const start = live.choice === 0 ? [] : [[START, statesNow().flat().map((x) => rounded(x, 8)).join()]];
  return [...changedOnes(), ...modes, ...start].map(([name, value]) => `${encodeURIComponent(name)}=${value}`).join("&");
}

// Browsers let an address be written one or two hundred times in ten seconds: this many milliseconds lie between two of ours.
const LINK_EVERY = 120;

const link = { last: -Infinity, waiting: null };

function writeLink() {
  // The address is that of the host.
  if (host !== null || link.waiting !== null) return;
  const rest = link.last + LINK_EVERY - performance.now();
  if (rest <= 0) writeLinkNow();
  else link.waiting = setTimeout(writeLinkNow, rest);
}

function writeLinkNow() {
  clearTimeout(link.waiting);
  [link.last, link.waiting] = [performance.now(), null];
  history.replaceState(null, "", `#${fragment()}`);
}

function addressNow() {
  writeLinkNow();
  return location.href;
}

// Applies an address to the report. Unknown names, invalid numbers, and assemblies that do not
// close are reported.
function readLink(hash) {
  const parts = hash.slice(1).split("&").filter((part) => part !== "");
  const wrong = [];
  const changes = new Map();
  const asked = {};
  backToReport();
  for (const part of parts) {
    const [name, text] = splitPart(part);
    const value = Number(text);
    if (name === MODES && areModes(text)) asked.modes = { part, value: text.split(",").map(Number) };
    else if (name === START && statesOf(text) !== null) asked.states = { part, value: statesOf(text) };
    else if (text === "" || !Number.isFinite(value)) wrong.push(part);
    else if (live.declared.has(name)) changes.set(name, value);
    else if (live.given.has(name)) live.given.set(name, value);
    else wrong.push(part);
  }
  wrong.push(...whatDoesNotClose(asked, new Map([...live.dimensions, ...changes])));
  const error = change(changes);
  return wrong.length === 0 ? sayingOf(error) : notUnderstood(wrong);
}

// Takes the assembly that is asked for, its modes alone if its start leads nowhere; gives the parts of the address that are left.
function whatDoesNotClose({ modes, states }, dimensions) {
  // With the report's dimensions others are gone to as far as possible.
  const takes = (own) => [dimensions, live.declared].some((there) => takeAssembly(own, there));
  const own = { modes: modes?.value ?? live.modes, states: states?.value ?? [] };
  if ((!modes && !states) || takes(own)) return [];
  if (!modes || !states) return [(modes ?? states).part];
  return takes({ ...own, states: [] }) ? [states.part] : [modes.part, states.part];
}

function areModes(text) {
  const modes = text.split(",").map(Number);
  return modes.length === live.firstModes.length && modes.every((mode) => Math.abs(mode) === 1);
}

// One for each group without a closed form; null for anything else.
function statesOf(text) {
  const numbers = text.split(",").map(Number);
  const sizes = engine.programs[0].coupled.map(({ size }) => size);
  const count = sizes.reduce((sum, size) => sum + size, 0);
  if (text === "" || numbers.length !== count || !numbers.every(Number.isFinite)) return null;
  return sizes.map((size) => numbers.splice(0, size));
}

function splitPart(part) {
  const at = part.lastIndexOf("=");
  if (at < 0) return [part, ""];
  try {
    return [decodeURIComponent(part.slice(0, at)), part.slice(at + 1)];
  } catch {
    return [part, ""];
  }
}

function notUnderstood(wrong) {
  return `The address says what this mechanism does not have: ${wrong.join(", ")}`;
}

// The changes as Rust: the fields that differ from the declaration.
function asRust() {
  const { name, dimensions } = engine.programs[0];
  const fields = new Map();
  const changed = new Set(changedFromDeclaration().map(rustField));
  for (const own of dimensions) {
    const value = rustNumber(live.dimensions.get(own.name) ?? own.value);
    fields.set(rustField(own.name), [...(fields.get(rustField(own.name)) ?? []), value]);
  }
  const text = ([field, numbers]) => (numbers.length > 1 ? `${field}: linkage::Vector${numbers.length}::new(${numbers.join(", ")})` : `${field}: ${numbers[0]}`);
  const own = [...fields].filter(([field]) => changed.has(field)).map(text);
  return own.length === 0 ? `${name}::default()` : `${name} { ${own.join(", ")}, ..${name}::default() }`;
}

// The field that a dimension is, or is a component of; those of parts have the part in front, `hook_crank`.
function rustField(name) {
  const stem = name.slice(0, Math.max(0, name.lastIndexOf(".")));
  const members = engine.programs[0].dimensions.filter((own) => own.name.startsWith(`${stem}.`)).map((own) => own.name.slice(stem.length + 1));
  // Lengths of a part may be called `x` and `y`, too.
  const isVector = members.length > 1 && members.every((own, k) => own === "xyz"[k]) && machine.parts.every((part) => part.name !== stem);
  return (isVector ? stem : name).replaceAll(".", "_");
}

function rustNumber(value) {
  const text = String(value);
  return /[.e]/.test(text) ? text : `${text}.0`;
}

// Dimensions that are not those of the declaration, which those of the report may be neither.
function changedFromDeclaration() {
  const own = engine.programs[0].dimensions.filter(({ name, value }) => (live.dimensions.get(name) ?? value) !== value);
  return own.map(({ name }) => name);
}

// The changes as options `--set` of the command.
function asText() {
  return changedOnes().map(([name, value]) => `${name}=${value}${unitOfName(name)}`).join("\n");
}

function unitOfName(name) {
  return report.dimensions.find((own) => own.name === name)?.unit ?? "";
}
