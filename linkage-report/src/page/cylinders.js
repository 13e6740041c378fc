// Cylinders: a barrel from the one end, a piston rod from the other.

const BARREL = { half: 7.5, share: 0.8, least: 0.3, rod: 4 };

function cylinderPart(guide, index) {
  const outline = shape("path", { class: "outline" });
  const rod = shape("path", { class: "body" });
  const barrel = shape("path", { class: "barrel" });
  const title = shape("title", {}, `cylinder ${guide.name}`);
  const node = shape("g", { class: "link slot cylinder", style: `--colour: ${linkColour(hueOf("guides", index, picture.links.length + index))}` }, title, outline, rod, barrel);
  set(node, { "data-guide": guide.name });
  return {
    node,
    update(row) {
      const [origin, direction, slider] = guidePlaces(guide, row);
      if (origin === null || direction === null || slider === null) return null;
      const [low, high] = reachOf(guide);
      // The piston rod shows at every position.
      const length = Math.max(BARREL.share * low, BARREL.least * high);
      const [foot, mouth, eye] = [origin, along(origin, direction, length), slider].map(project);
      for (const line of [outline, rod]) set(line, { d: lineThrough([foot, eye]) });
      const apart = Math.hypot(mouth[0] - foot[0], mouth[1] - foot[1]) || 1;
      const [x, y] = [mouth[1] - foot[1], foot[0] - mouth[0]].map((across) => (BARREL.half * across) / apart);
      const beside = ([left, top], side) => [left + side * x, top + side * y];
      const corners = [beside(foot, 1), beside(mouth, 1), beside(mouth, -1), beside(foot, -1)];
      set(barrel, { d: `${lineThrough(corners)}Z` });
      this.covers = [taken([foot, eye], BARREL.rod), taken(corners, 1)];
      return meanNearness([foot, eye]);
    },
  };
}
