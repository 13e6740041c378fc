// Simultaneous motions of two organs with the present dimensions.

function overlapsNow(all) {
  return all.flatMap((first, one) => all.slice(one + 1).flatMap((second, k) => {
    const pair = [one, one + 1 + k];
    const found = first.intervals.flatMap((a) => second.intervals.filter(({ motion }) => motion === a.motion).flatMap((b) =>
      commonOf(a, b).map((interval) => ({ organs: pair, motions: [a.motion, b.motion], bands: [a.band, b.band], ...interval }))));
    return found.sort((a, b) => a.from - b.from);
  }));
}

// Nothing, one interval, or two where both together are longer than a cycle.
function commonOf(a, b) {
  const { from: low, to: high } = organs.declared;
  const width = high - low;
  return [-width, 0, width].flatMap((turn) => {
    const from = Math.max(a.from, b.from + turn);
    const to = Math.min(a.from + a.range, b.from + b.range + turn);
    // A motion that begins at the end of the range begins the next cycle.
    return to > from ? [{ from: from >= high ? from - width : Math.max(from, low), to: to > high ? to - width : to, range: to - from }] : [];
  });
}
