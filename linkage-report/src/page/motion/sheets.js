// Phase portraits and the check of the energy, below the plots over time.

function startCharts() {
  const parts = [element("h2", { id: "portraits-title" }, "Phase portraits"), ...foldChoice(), element("div", { class: "charts" }, ...portraits())];
  if (driven.energy !== null) parts.push(element("h2", { id: "energy-title" }, "Energy check"), element("p", { id: "drift", role: "status" }), element("div", { class: "charts" }, ...energyCharts()));
  byId("plots").after(element("section", { id: "motion", "aria-label": "Phase portraits and energy" }, ...parts));
  observeSize(document.querySelector("#motion .charts"), measureCharts);
  onMove(markCharts);
  measureCharts();
  sayDrift();
}

// The width of a column of charts.
function measureCharts() {
  const width = Math.floor(document.querySelector("#motion .panel").clientWidth);
  if (width === charts.width || !(width > 0)) return;
  charts.width = width;
  drawCharts();
}

function motionColumn(table, name) {
  return columns.find((column) => column.table === report.tables[table].function && column.name === name);
}

function portraits() {
  return driven.inputs.map(({ name, speed }) => {
    const [x, y] = [name, speed].map((own) => motionColumn(driven.state, own));
    return makeChart(`portrait ${name}`, `${speed} over ${name}`, { x: name, y: speed }, [chartCurve(speed, x, y)]);
  });
}

// A box for mechanisms with an angle that turns.
function foldChoice() {
  if (driven.inputs.every(({ name }) => motionColumn(driven.state, name).unit !== "rad")) return [];
  const box = element("input", { id: "folds", type: "checkbox" });
  box.addEventListener("change", () => {
    charts.folds = box.checked;
    drawCharts();
  });
  return [element("label", { class: "aside" }, box, " Over one turn")];
}

function energyCharts() {
  const time = { values: input.values, unit: input.unit };
  const curves = (names) => names.map((name, k) => ({ ...chartCurve(name, time, motionColumn(driven.energy.table, name)), colour: `var(--curve-${k})`, dash: DASHES[k] }));
  return [
    makeChart("energies", "Kinetic and potential energy, and the work of motors and dampers", { x: input.name, y: "energy" }, curves(["kinetic", "potential", "work"])),
    makeChart("drift", "Energy less that of the start and the work", { x: input.name, y: "drift" }, curves(["drift"])),
  ];
}

function showCharts() {
  drawCharts();
  sayDrift();
}

// The largest difference, also as a share of the largest energy that has moved.
function sayDrift() {
  if (driven.energy === null) return;
  const [kinetic, potential, work, drift] = ["kinetic", "potential", "work", "drift"].map((name) => motionColumn(driven.energy.table, name));
  const largest = (numbers) => numbers.reduce((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);
  const most = largest(drift.values);
  const moved = Math.max(largest(kinetic.values), largest(work.values), largest(potential.values.map((value) => value - potential.values[0])));
  const share = moved > 0 ? `, ${rounded(most / moved, 2).toExponential()} of the largest energy that moves` : "";
  byId("drift").textContent = `Kinetic and potential energy differ from the start and the work of motors and dampers by at most ${rounded(most, 2).toExponential()} ${drift.unit}${share}.`;
}
