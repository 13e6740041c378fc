// Other inputs that run through their ranges by themselves, each as fast as the first one does.

function rangeOfInput(name) {
  const all = engine.programs.flatMap(({ inputs }) => inputs);
  return all.find((own) => own.name === name)?.range ?? null;
}

// Plays an input; null for all that has no range to run through.
function runButton({ name, unit, slider, put }) {
  const range = rangeOfInput(name);
  if (range === null) return null;
  const [low, high] = range;
  const isTurn = unit === "rad" && Math.abs(high - low - 2 * Math.PI) < 1e-9;
  const run = { on: false, backward: false, last: null };
  const button = element("button", { type: "button", class: "run", "data-runs": name });
  const show = () => set(button, { "data-playing": run.on, "aria-label": `${run.on ? "Pause" : "Play"} ${name}`, title: `Play or pause ${name}` });
  // A whole turn begins again, any other range is run through to and fro.
  const next = (value) => {
    if (value >= low && value <= high) return value;
    if (isTurn) return value > high ? low : high;
    run.backward = value > high;
    return run.backward ? high : low;
  };
  const frame = (now) => {
    if (!run.on || life.signal.aborted) return;
    const seconds = run.last === null ? 0 : Math.min(0.25, (now - run.last) / 1000);
    run.last = now;
    tell(put(next(valueNow(name) + ((run.backward ? -1 : 1) * seconds * (high - low)) / player.period)));
    requestAnimationFrame(frame);
  };
  const stop = () => {
    if (!run.on) return;
    run.on = false;
    show();
    keepStep();
  };
  button.addEventListener("click", () => {
    if (run.on) return stop();
    Object.assign(run, { on: true, last: null });
    show();
    requestAnimationFrame(frame);
  });
  slider.addEventListener("pointerdown", stop);
  show();
  return button;
}
