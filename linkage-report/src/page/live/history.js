// Undo and redo: earlier dimensions, arguments and assemblies.

// The number of steps that are kept.
const MOST_STEPS = 100;

const past = { steps: [], next: [], last: null };

function snapshot() {
  return { dimensions: new Map(live.dimensions), given: new Map(live.given), modes: live.modes, choice: live.choice, assemblies: live.assemblies };
}

function sameMaps(a, b) {
  return [...a].every(([name, value]) => b.get(name) === value);
}

// A change is complete: a drag is one step.
function keepStep() {
  const now = snapshot();
  if (sameMaps(now.dimensions, past.last.dimensions) && sameMaps(now.given, past.last.given) && now.modes.join() === past.last.modes.join() && now.choice === past.last.choice) return;
  past.steps.push(past.last);
  if (past.steps.length > MOST_STEPS) past.steps.shift();
  past.next = [];
  past.last = now;
  writeLink();
  host?.kept();
  showHistory();
}

function goBack(from, to) {
  if (from.length === 0) return;
  to.push(past.last);
  past.last = from.pop();
  forgetRefusals();
  live.given = new Map(past.last.given);
  Object.assign(live, { modes: past.last.modes, choice: past.last.choice, assemblies: past.last.assemblies });
  tell(change(past.last.dimensions));
  writeLink();
  host?.kept();
  showHistory();
}

function undo() {
  goBack(past.steps, past.next);
}

function redo() {
  goBack(past.next, past.steps);
}

// The state of the report.
function resetAll() {
  backToReport();
  tell(change(new Map()));
  keepStep();
}

function showHistory() {
  byId("undo").disabled = past.steps.length === 0;
  byId("redo").disabled = past.next.length === 0;
  byId("reset").disabled = !isChanged() && refusals().length === 0;
}
