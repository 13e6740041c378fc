// The keyboard.

const STEPS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

// Returns true if the key has another meaning where it was pressed.
function keyBelongsToField(event) {
  const target = event.target;
  if (target.tagName === "SELECT" || (target.matches("[type=search], [type=text], [type=range]") && target.id !== "position")) return true;
  return event.key === " " && target.matches("button, summary, a, [type=checkbox], [role=button]");
}

// Only sideways keys move from anywhere; up and down scroll the page unless the slider has the focus.
function stepOf(event) {
  const step = STEPS[event.key];
  const upright = event.key === "ArrowUp" || event.key === "ArrowDown";
  if (step === undefined || (upright && event.target.id !== "position")) return 0;
  return step * (event.shiftKey ? 10 : 1);
}

function destination(event) {
  if (event.key === "Home") return 0;
  if (event.key === "End") return rowCount - 1;
  const step = stepOf(event);
  return step === 0 ? null : position.row + step;
}

function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || keyBelongsToField(event)) return;
  if (event.key === " ") {
    setPlaying(!player.playing);
  } else {
    const row = destination(event);
    if (row === null) return;
    setPlaying(false);
    moveTo(row);
  }
  event.preventDefault();
}

function startKeys() {
  listen(document, "keydown", onKey);
}
