// Play, pause, speed, direction, and the slider.

// Seconds that the range takes.
const PERIODS = [1, 2, 4, 8, 16, 32, 64];
// Times that a motion under forces is slowed.
const SLOWED = [1, 2, 5, 10, 100];

const player = { playing: false, backward: false, period: before?.period ?? 8, value: 0, last: null };

function span() {
  return input.values[rowCount - 1] - input.values[0];
}

// The input's steady speed in the machine, or null. An accelerated input has its speed at every position: how long the
// range takes is not known. The input of a motion under forces is the time itself.
function trueSpeed() {
  if (driven !== null) return 1;
  const { omega, epsilon } = report.speed ?? {};
  return omega && !epsilon ? omega : null;
}

// Seconds that the range takes in the machine, or null.
function truePeriod() {
  return trueSpeed() === null ? null : Math.abs(span() / trueSpeed());
}

// True if the machine runs through the rows from the last to the first.
function runsBackward() {
  return (report.speed?.omega ?? 0) * span() < 0;
}

// Seconds from where the machine enters the range.
function trueTime(value) {
  const begin = input.values[runsBackward() ? rowCount - 1 : 0];
  return Math.abs((value - begin) / trueSpeed());
}

function setPlaying(playing) {
  if (playing === player.playing) return;
  player.playing = playing;
  player.last = null;
  player.value = input.values[position.row];
  set(byId("play"), { "aria-label": playing ? "Pause" : "Play", "data-playing": playing });
  if (playing) requestAnimationFrame(playFrame);
}

// Time goes on smoothly and the nearest row is shown: between rows nothing is known.
function playFrame(now) {
  if (!player.playing) return;
  if (player.last !== null) {
    const seconds = Math.min(0.25, (now - player.last) / 1000);
    const sign = player.backward ? -1 : 1;
    player.value = playedValue(player.value + (sign * seconds * span()) / player.period);
    moveTo(nearestRow(player.value));
  }
  player.last = now;
  requestAnimationFrame(playFrame);
}

// A whole turn and a motion under forces begin again, any other range is run through to and fro.
function playedValue(value) {
  const start = input.values[0];
  const part = (value - start) / span();
  if (part >= 0 && part <= 1) return value;
  if (input.periodic || driven !== null) return start + (part - Math.floor(part)) * span();
  setBackward(part > 1);
  return part > 1 ? input.values[rowCount - 1] : start;
}

function setBackward(backward) {
  player.backward = backward;
  const button = byId("direction");
  const word = backward ? "Backward" : "Forward";
  button.replaceChildren(backward ? "\u2190" : "\u2192", element("span", { class: "word" }, ` ${word}`));
  set(button, { "aria-label": `Direction: ${word.toLowerCase()}`, title: "Direction of play" });
}

// The listed speeds: values of the choice, and their words.
function speedChoices() {
  if (driven !== null) return SLOWED.map((factor) => [factor, factor === 1 ? "real time" : `1/${factor} of real time`]);
  const real = truePeriod();
  const periods = real === null ? PERIODS : [real, ...PERIODS.filter((period) => period !== real)];
  return periods.map((period) => [period, speedText(period)]);
}

// The seconds of a chosen speed: those of the range, of a motion under forces so many times its own.
function playedPeriod(choice) {
  return Number(choice) * (driven === null ? 1 : span());
}

// A listed speed in the machine's time.
function speedText(period) {
  const real = truePeriod();
  const whole = input.periodic ? "cycle" : "range";
  const seconds = `${digits(rounded(period, 3))} s per ${whole}`;
  if (real === null) return seconds;
  const factor = period / real;
  if (Math.abs(factor - 1) < 1e-9) return `true time (${seconds})`;
  const times = digits(rounded(factor > 1 ? factor : 1 / factor, 3));
  return `${seconds}, ${factor > 1 ? "slowed" : "sped up"} ${times} times`;
}

function startPlayer() {
  const speed = byId("speed");
  for (const [value, words] of speedChoices()) speed.append(element("option", { value }, words));
  if (driven === null) speed.value = player.period;
  else player.period = playedPeriod(speed.value);
  speed.addEventListener("change", () => { player.period = playedPeriod(speed.value); });

  const slider = byId("position");
  slider.max = rowCount - 1;
  slider.addEventListener("input", () => {
    setPlaying(false);
    moveTo(Number(slider.value));
  });
  byId("play").addEventListener("click", () => setPlaying(!player.playing));
  byId("direction").addEventListener("click", () => setBackward(!player.backward));
  setBackward(before?.backward ?? runsBackward());
  onMove(showPosition);
}

// The inputs of a motion under forces, as columns of its state.
function movingInputs() {
  return driven === null ? [] : report.tables[driven.state].columns.slice(0, driven.inputs.length);
}

function showPosition(row) {
  const value = input.values[row];
  const slider = byId("position");
  slider.value = row;
  slider.setAttribute("aria-valuetext", `${input.name} ${inputShort(value)}`);
  const time = trueSpeed() === null || driven !== null ? "" : `, t = ${digits(rounded(trueTime(value), 6))} s`;
  const radians = input.unit === "rad" ? [element("small", {}, `${short(value)} rad`)] : [];
  byId("readout").replaceChildren(
    element("b", {}, `${input.name} = ${withUnit(value, input.unit).replace(/ \(.*/, "")}`),
    ...radians,
    ...movingInputs().map(({ name, values: numbers, unit }) => element("small", {}, `${name} = ${withUnit(numbers[row], unit)}`)),
    element("small", {}, `row ${row + 1} of ${rowCount}${time}`),
  );
}
