// Everything together.

function startDesigns() {
  const buttons = data.designs.map((design, index) => {
    const button = element("button", { type: "button", "data-design": index, title: design.about || null }, swatch(index), design.name);
    button.addEventListener("click", () => toggle(index));
    return button;
  });
  byId("designs").replaceChildren(...buttons);
  watchers.push(() => {
    for (const [index, button] of buttons.entries()) set(button, { "aria-pressed": String(state.shown.has(index)) });
  });
}

function startPosition() {
  const slider = set(byId("position"), { max: data.input.values.length - 1 });
  slider.addEventListener("input", () => stand(Number(slider.value)));
  watchers.push(() => {
    slider.value = state.row;
    const at = withUnit(data.input.values[state.row], data.input.unit);
    set(slider, { "aria-valuetext": at });
    write(byId("readout"), `${data.input.name} = ${at}`);
  });
}

write(byId("title"), data.title);
if (data.about) write(byId("about"), data.about);
startTheme();
startDesigns();
startDrawing();
startPosition();
startFront();
startTables();
startPlots();
changed();
document.body.dataset.ready = "true";
