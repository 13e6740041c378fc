// Change points in the range of the input: rows have values on both sides, and the mechanism may go on in another assembly.

// The criterion of the compiler for a slack that only touches zero, at samples of a degree or two and at dips between them.
const DEAD = CORE.DEAD;
const END = CORE.END;
const AT_END = CORE.AT_END;
const SAMPLES = 256;

// A sentence for each group that has some; null where there is none.
function changePointWords() {
  const told = engine.programs.flatMap((unit, number) =>
    unit.groups.flatMap(({ loops, joints, unknowns, slack }, group) => {
      if (slack === "prepared" || slack === "signed") return [];
      const places = touches(number, group).map(inputShort);
      if (places.length === 0) return [];
      const numbers = `${loops.length === 1 ? "loop" : "loops"} ${loops.join(", ")}`;
      const loop = `${joints || numbers} (${unknowns.join(", ")})`;
      return [`At ${input.name} = ${places.join(", ")} the mechanism passes through a change point: from there ${loop} can go on in another assembly.`];
    }));
  return told.length === 0 ? null : told.join(" ");
}

// The places in the rows' range where a slack touches zero.
function touches(number, group) {
  const own = live.assemblies[number];
  const out = new Float64Array(own.unit.groups.length);
  const slack = (position) => {
    const x = inputsAt(own.unit, position);
    own.unit.slacks(own, x, own.statesAt(x), out);
    return out[group];
  };
  const [low, high] = [input.values[0], input.values.at(-1)];
  // A range may end at a dead point.
  const inside = END * (high - low);
  const at = (k) => low + (high - low) * (Math.min(Math.max(k, 0), SAMPLES) / SAMPLES);
  const all = Array.from({ length: SAMPLES + 1 }, (_, k) => slack(at(k)));
  const dead = DEAD * Math.max(...all.map((own) => Math.abs(own) || 0));
  const places = all.flatMap((here, k) => {
    const [before, after] = [all[Math.max(k - 1, 0)], all[Math.min(k + 1, SAMPLES)]];
    if (!(before >= here && after >= here && before + after > 2 * here && here > -dead)) return [];
    const [from, to] = goldenSections(at(k - 1), at(k + 1), (a, b) => slack(a) <= slack(b));
    const place = (from + to) / 2;
    if (!(Math.abs(slack(Math.min(Math.max(place, low + inside), high - inside))) < dead)) return [];
    return [[low, high].find((end) => Math.abs(place - end) < AT_END * (high - low)) ?? place];
  });
  return places.filter((place, k) => k === 0 || place - places[k - 1] > (high - low) / SAMPLES);
}
