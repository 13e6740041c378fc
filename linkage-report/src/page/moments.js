// The cyclogram as text: the events of all organs in their order, and simultaneous motions of two
// organs.

function motionWords({ bands, unit }, { motion, band }) {
  const space = unit === "" ? "" : " ";
  return motion === "dwell" ? `dwell (${bands[band]}${space}${unit})` : motion;
}

// The end and the beginning at an event.
function changeAt({ events, intervals }, event) {
  return [intervals[(event + events.length - 1) % events.length], intervals[event]];
}

// A dwell that begins or ends, or a motion that begins.
function happening({ organ: index, event }) {
  const organ = report.cyclogram.organs[index];
  const [ends, begins] = changeAt(organ, event);
  const isEnd = ends.motion === "dwell" && begins.motion !== "dwell";
  return `${organ.name}'s ${motionWords(organ, isEnd ? ends : begins)} ${isEnd ? "ends" : "begins"}`;
}

function organWords({ name, stands }) {
  return stands ? `${name} (as in the report)` : name;
}

// All events in the order of the shaft's angle.
function cycleTable() {
  const { organs, order } = report.cyclogram;
  const rows = order.map(({ organ: index, event, at, after, follows }) => {
    const organ = organs[index];
    const shift = hasShifts() ? [toDegrees(organ.events[event].shift)] : [];
    return [organWords(organ), ...changeAt(organ, event).map((own) => motionWords(organ, own)), placeButton(at), ...shift, toDegrees(after), happening(follows)];
  });
  return grid("cyclogram", ["organ", "ends", "begins", `at ${input.name}`, ...(hasShifts() ? ["\u00b1 deg"] : []), "deg", "after"], rows);
}

// The motion of an organ, below its name: places must not be out of sight on a phone.
function deed(organ, done) {
  return element("span", { class: "deed" }, organWords(organ), element("small", {}, motionWords(organ, done)));
}

// Intervals in which two organs both dwell, both advance or both return.
function overlapTable() {
  const { organs, overlaps } = report.cyclogram;
  const rows = overlaps.map(({ organs: indices, motions, bands, from, to, range }) => {
    const both = indices.map((index, k) => deed(organs[index], { motion: motions[k], band: bands[k] }));
    return [...both, placeButton(from), placeButton(to), toDegrees(range)];
  });
  if (rows.length === 0) return element("p", {}, "No two organs do the same at once.");
  return grid("overlaps", ["organ", "organ", `from ${input.name}`, `to ${input.name}`, "for, deg"], rows);
}

function hasShifts() {
  return cycle.organs.some(({ events }) => events.some(({ shift }) => shift !== null));
}

// They are made anew in their place where the cyclogram is.
const momentTables = { events: null, overlaps: null };

function startMoments() {
  if (cycle.organs.length === 0) return;
  momentTables.events = addSheet("Cyclogram", true, cycleTable());
  momentTables.events.id = "events";
  if (cycle.organs.length === 1) return;
  momentTables.overlaps = addSheet("At the same time", true, overlapTable());
  momentTables.overlaps.id = "overlaps";
}

function remakeMoments() {
  momentTables.events.lastChild.replaceWith(cycleTable());
  momentTables.overlaps?.lastChild.replaceWith(overlapTable());
}
