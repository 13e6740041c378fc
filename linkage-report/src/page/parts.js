// Parts of the drawing. Each part is a node and a function that puts it where the mechanism is, and
// returns its nearness to the eye; null if it cannot be drawn there.

// A part leaves its area on the screen in `covers`: names of points keep clear of that.

// Half the widths of the outlines that the style has.
const BAR_HALF = 5.5;
const SLOT_HALF = 3;

function linkColour(index) {
  return `var(--link-${index})`;
}

// Two strokes, one in the other: a bar or plate with an outline.
function outlined(kind, colour, name) {
  const outline = shape("path", { class: "outline" });
  const body = shape("path", { class: "body" });
  const node = shape("g", { class: kind, style: `--colour: ${colour}` }, shape("title", {}, name), outline, body);
  const draw = (d) => {
    set(outline, { d });
    set(body, { d });
  };
  return [node, draw];
}

function meanNearness(places) {
  return places.reduce((sum, place) => sum + place[2], 0) / places.length;
}

function linkPart(link, index) {
  const { points, arcs } = outlineOf(link, index);
  const plate = arcs.length > 0 || points.length > 2;
  const [node, draw] = outlined(plate ? "link plate" : "link bar", linkColour(hueOf("links", index, index)), `link ${link.name}`);
  set(node, { "data-link": link.name });
  return {
    node,
    update(row) {
      const slots = arcs.map((guide) => arcNow(guide, row));
      const places = points.map((point) => pointAt(point, row));
      if (places.includes(null) || slots.includes(null)) return null;
      places.push(...slots.flatMap(arcLine));
      const seen = places.map(project);
      const around = plate ? hull(seen) : seen;
      draw(lineThrough(around) + (plate ? "Z" : ""));
      this.covers = [taken(around, BAR_HALF)];
      return meanNearness(seen);
    },
  };
}

// A guide on the frame: a hatched rail beside the block in the plane, a rod in space.
function framePart(guide) {
  const rail = shape("path", { class: "rail" });
  const hatch = shape("path", { class: "hatching" });
  const node = shape("g", { class: "guide", "data-guide": guide.name }, shape("title", {}, `guide ${guide.name}`), hatch, rail);
  return {
    node,
    update(row) {
      const ends = guideEnds(guide, row, reachOf(guide), 22);
      if (ends === null) return null;
      const [from, to] = isSpatial() ? ends : besideBlock(ends);
      set(rail, { d: lineThrough([from, to]) });
      set(hatch, { d: isSpatial() ? null : hatching(from, to) });
      // Hatching goes down from the rail.
      this.covers = [isSpatial() ? taken([from, to], 1) : taken([from, to], 9)];
      return meanNearness(ends);
    },
  };
}

// Turns ends from left to right, so that the hatching is below, and moves them aside by half a
// block. A frame that turns keeps its side.
function besideBlock(ends) {
  const [from, to] = isStanding() || ends[0][0] <= ends[1][0] ? ends : [ends[1], ends[0]];
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  const [x, y] = [(-8 * (to[1] - from[1])) / length, (8 * (to[0] - from[0])) / length];
  return [[from[0] + x, from[1] + y], [to[0] + x, to[1] + y]];
}

// Both ends on the screen, some pixels beyond the range of the slider.
function guideEnds(guide, row, [low, high], beyond) {
  const [origin, direction] = guidePlaces(guide, row);
  if (origin === null || direction === null || !(high >= low)) return null;
  const more = beyond / cameraScale();
  return [low - more, high + more].map((distance) => project(along(origin, direction, distance)));
}

// A guide that moves: a slot in its link, or a bar of its own that turns about the origin.
function movingPart(guide, index) {
  const own = guide.on === "itself";
  const reach = ([low, high]) => (own ? [Math.min(0, low), Math.max(0, high)] : [low, high]);
  const colour = linkColour(own ? hueOf("guides", index, picture.links.length + index) : hueOf("links", guide.on, guide.on));
  const [node, draw] = outlined("link slot", colour, `guide ${guide.name}`);
  set(node, { "data-guide": guide.name });
  return {
    node,
    update(row) {
      const ends = guideEnds(guide, row, reach(reachOf(guide)), own ? 0 : 18);
      if (ends === null) return null;
      draw(lineThrough(ends));
      this.covers = [taken(ends, SLOT_HALF)];
      return meanNearness(ends);
    },
  };
}

function blockPart(guide) {
  const body = shape("path", { class: "block" });
  const node = shape("g", { "data-slider": guide.name }, shape("title", {}, `slider ${guide.name}`), body);
  return {
    node,
    update(row) {
      const [, direction, slider] = guidePlaces(guide, row);
      if (slider === null || direction === null) return null;
      const seen = project(slider);
      const corners = block(seen, projectDirection(direction));
      set(body, { d: `${lineThrough(corners)}Z` });
      this.covers = [taken(corners, 1)];
      return seen[2] + 1e-3 * camera.box.radius;
    },
  };
}

// An axis in space: a dash-dotted line.
function axisPart(axis) {
  const node = shape("path", { class: "axis" });
  return {
    node,
    update(row) {
      const [point, direction] = [pointAt(axis.point, row), directionAt(axis.direction, row)];
      if (point === null || direction === null) return null;
      const half = 0.25 * camera.box.radius;
      const ends = [-half, half].map((distance) => project(along(point, direction, distance)));
      set(node, { d: lineThrough(ends) });
      this.covers = [taken(ends, 1)];
      return meanNearness(ends);
    },
  };
}

function guideParts(guide, index) {
  if (guide.shape === "cylinder") return [cylinderPart(guide, index)];
  if (guide.shape === "arc") return [arcPart(guide, index)];
  const line = guide.on === "frame" ? framePart(guide) : movingPart(guide, index);
  return [line, blockPart(guide)];
}
