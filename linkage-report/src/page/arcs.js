// Curved slots: the stretch of an arc that the slider needs, with round ends.

// The longest step along an arc. Half the width of a slot in its link, and of one in the frame with its hatching.
const ARC = { step: Math.PI / 45, half: 13, hatched: 17 };

// The range of the angle from the direction of an arc to its slider, at most a whole turn; null without a position.
function swingOf(angles) {
  let range = null;
  let last = 0;
  for (const angle of angles.filter((own) => own !== null)) {
    last = range === null ? angle : angle + 2 * Math.PI * Math.round((last - angle) / (2 * Math.PI));
    range = range === null ? [last, last] : [Math.min(range[0], last), Math.max(range[1], last)];
  }
  return range === null ? null : [range[0], Math.min(range[1], range[0] + 2 * Math.PI)];
}

// The angle from the direction of an arc to its slider, from the places of its guide; null if one is missing.
function arcAngle([origin, direction, slider]) {
  if (origin === null || direction === null || slider === null) return null;
  const [x, y] = minus(slider, origin);
  const [c, s] = direction;
  return Math.atan2(c * y - s * x, c * x + s * y);
}

// The centre, the radius, the angle of the first end and the angle from there to the other end; null where the mechanism is not whole.
function arcFrom([origin, direction, slider], swing) {
  if (origin === null || direction === null || slider === null || swing === null) return null;
  const [from, to] = swing;
  return { centre: origin, radius: Math.hypot(...minus(slider, origin)), start: from + Math.atan2(direction[1], direction[0]), span: to - from };
}

function arcAt({ centre }, radius, angle) {
  return [centre[0] + radius * Math.cos(angle), centre[1] + radius * Math.sin(angle)];
}

function arcNow(guide, row) {
  return arcFrom(guidePlaces(guide, row), reachOf(guide));
}

// Angles from one end to the other, at steps that are at most so long.
function arcAngles({ start, span }, step) {
  const count = Math.max(1, Math.ceil(span / step));
  return Array.from({ length: count + 1 }, (_, k) => start + (span * k) / count);
}

// Places of the middle line.
function arcLine(arc) {
  return arcAngles(arc, ARC.step).map((angle) => arcAt(arc, arc.radius, angle));
}

// The points around which a link is drawn, and its curved slots. Their centres are left out unless something turns there.
function outlineOf(link, index) {
  const arcs = picture.guides.filter((guide) => guide.shape === "arc" && guide.on === index);
  const isCentre = (point) => !isDrawn(picture.points[point]) && arcs.some(({ origin }) => origin === point);
  return { points: link.points.filter((point) => !isCentre(point)), arcs };
}

function arcPart(guide, index) {
  const isFixed = guide.on === "frame";
  const own = guide.on === "itself";
  const hatch = shape("path", { class: "hatching" });
  const lines = [...(isFixed ? [] : ["outline", "body"]), "rim", "gap"].map((kind) => shape("path", { class: kind }));
  const colour = linkColour(isFixed || own ? hueOf("guides", index, picture.links.length + index) : hueOf("links", guide.on, guide.on));
  const node = shape("g", { class: `${isFixed ? "guide" : "link"} arc`, style: `--colour: ${colour}` }, shape("title", {}, `slot ${guide.name}`), ...(isFixed ? [hatch] : []), ...lines);
  set(node, { "data-guide": guide.name });
  return {
    node,
    update(row) {
      const arc = arcNow(guide, row);
      if (arc === null) return null;
      const seen = arcLine(arc).map(project);
      for (const line of lines) set(line, { d: lineThrough(seen) });
      if (isFixed) set(hatch, { d: arcHatching(arc) });
      this.covers = seen.slice(1).map((place, i) => taken([seen[i], place], isFixed ? ARC.hatched : ARC.half));
      return meanNearness(seen);
    },
  };
}

// Strokes along the outer side.
function arcHatching(arc) {
  const scale = cameraScale();
  const edge = arc.radius + 8.5 / scale;
  return arcAngles(arc, 6 / (scale * edge)).map((angle) =>
    lineThrough([arcAt(arc, edge, angle), arcAt(arc, edge + 6 / scale, angle - 5 / (scale * edge))].map(project))).join("");
}
