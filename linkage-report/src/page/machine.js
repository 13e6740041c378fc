// The parts of a machine: their colours, and which of them are shown.

const machine = { parts: picture?.parts ?? [], hidden: new Set() };

// Indices of the parts that have something of a kind: `points`, `links`, `guides`.
function partsWith(kind, index) {
  return machine.parts.flatMap((part, own) => (part[kind].includes(index) ? [own] : []));
}

// A node of several parts is shown as long as one of them is.
function isHidden([kind, index]) {
  const parts = partsWith(kind, index);
  return parts.length > 0 && parts.every((own) => machine.hidden.has(own));
}

// Colours that are listed; links without parts begin again behind the last one.
const LINK_COLOURS = 6;

// The number of the colour of a link or guide: that of its part, after all parts that of the
// machine itself; without parts each has its own.
function hueOf(kind, index, own) {
  return machine.parts.length === 0 ? own % LINK_COLOURS : partsWith(kind, index)[0] ?? machine.parts.length;
}

// The nodes of the drawing, with their owners.
function ownedBy(part, ...owners) {
  return Object.assign(part, { owners, away: false });
}

function ownersOfDrive({ turn, slide }) {
  return turn ? ["points", turn[1]] : ["guides", slide];
}

// While the reader is on a link, the motions of inputs against the frame are not seen.
function findAway() {
  for (const part of [...drawing.bodies, ...drawing.tops, ...drawing.signs]) {
    part.away = part.owners.some(isHidden) || (isStanding() && part.drive === true);
  }
}

function togglePart(index) {
  if (!machine.hidden.delete(index)) machine.hidden.add(index);
  const shown = !machine.hidden.has(index);
  byId("parts").querySelector(`[data-part="${index}"]`).setAttribute("aria-pressed", shown);
  fadeOrgans();
  findAway();
  redraw();
  hideCurves();
}

// The part of a column: the one whose name its quantity has, as in `hook.tip.y` and
// `shape[hook.tip].y`, otherwise the one whose name its function has, `hook` or `hook_way`. The
// longest of several names counts; -1 where there is none.
function partOfColumn({ name, of, meaning, table }) {
  const [, shown] = (meaning === "picture" && /\[(?:along )?(.*)\]/.exec(name)) || [];
  const quantity = shown ?? of ?? name;
  const bears = (text, end) => (part) => text === part.name || text.startsWith(part.name + end);
  const longest = (fits) => machine.parts.reduce((best, part, k) => (fits(part) && part.name.length > (machine.parts[best]?.name.length ?? 0) ? k : best), -1);
  const own = longest(bears(quantity, "."));
  return own >= 0 ? own : longest(bears(table, "_"));
}

function isOfHiddenPart(column) {
  return machine.hidden.size > 0 && machine.hidden.has(partOfColumn(column));
}

// Their curves are gone with a part, and its quantities are pale among those that can be chosen.
function hideCurves() {
  const hidden = new Set(columns.filter(isOfHiddenPart).map(({ key }) => key));
  for (const box of byId("chooser").querySelectorAll("input[data-column]")) box.parentNode.classList.toggle("off", hidden.has(box.dataset.column));
  if (plots.width > 0) makePanels();
}

function startMachine() {
  if (machine.parts.length === 0) return;
  const buttons = machine.parts.map(({ name }, index) => {
    const swatch = element("span", { class: "chip", style: `--colour: ${linkColour(index)}` });
    const button = element("button", { type: "button", "data-part": index, "aria-pressed": "true", title: `Show or hide ${name}` }, swatch, name);
    button.addEventListener("click", () => togglePart(index));
    return button;
  });
  byId("hint").textContent += " Double-click a link to stand on it.";
  byId("parts").hidden = false;
  byId("parts").append(element("div", { class: "names", role: "group", "aria-label": "Parts" }, ...buttons), standChoice());
}
