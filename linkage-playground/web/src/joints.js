// Joints as they are drawn, in the text: where their coordinates are, and other ones.

const WORD = "[\\p{L}_][\\p{L}\\d_]*";
const NUMBER = "[-+\\u2212]?\\s*\\d[\\d_]*(?:\\.\\d+)?(?:[eE][-+]?\\d+)?";
const JOINT = new RegExp(`(${WORD})\\s*=\\s*\\(\\s*(${NUMBER})\\s*([a-z\\u00b5]*)\\s*,\\s*(${NUMBER})\\s*([a-z\\u00b5]*)\\s*\\)`, "gudi");

// Metres.
const LENGTHS = { m: 1, mm: 1e-3, cm: 1e-2, um: 1e-6, "\u00b5m": 1e-6, inch: 0.0254, ft: 0.3048 };

const withoutComments = (text) => text.replace(/\/\/[^\n]*|\/\*[^]*?\*\//g, (comment) => comment.replace(/[^\n]/g, " "));

// All joints of a text whose two coordinates are written as numbers, by name: the stretch of each coordinate, its number and its unit.
export function drawnJoints(text) {
  const plain = withoutComments(text);
  const joints = new Map();
  for (const statement of plain.matchAll(/(?<![\p{L}\d_])joint(?![\p{L}\d_])[^;]*;/gu)) {
    for (const found of statement[0].matchAll(JOINT)) {
      const stretch = (number, unit) => {
        const [from] = found.indices[number];
        const [, to] = found.indices[unit];
        return { from: statement.index + from, to: statement.index + to, unit: found[unit], value: Number(found[number].replace(/[\s_]/g, "").replace("\u2212", "-")) };
      };
      joints.set(found[1], [stretch(2, 3), stretch(4, 5)]);
    }
  }
  return joints;
}

const LINK = new RegExp(`(?<![\\p{L}\\d_])link\\s+${WORD}\\s*:\\s*(${WORD})\\s*,\\s*(${WORD})[^;]*?\\bat\\s+(${WORD})\\s*(?=[;\\s])`, "gu");
const INPUT = new RegExp(`(?<![\\p{L}\\d_])input\\s+(${WORD})\\s*=\\s*(${NUMBER})\\s*(deg|rad)`, "gudi");

// The edits that keep the reference of an input at the direction of the link that it drives, if these edits move a joint of it.
export function references(text, edits, pictureUnit) {
  const plain = withoutComments(text);
  const joints = drawnJoints(text);
  const inputs = new Map();
  for (const found of plain.matchAll(INPUT)) {
    const [[from], [, to]] = [found.indices[2], found.indices[3]];
    inputs.set(found[1], { from, to, unit: found[3], value: Number(found[2].replace(/[\s_]/g, "").replace("\u2212", "-")) });
  }
  const place = (joint) => joint.map(({ from, to, unit, value }) => {
    const edit = edits.find((edit) => edit.from === from && edit.to === to);
    const number = edit === undefined ? value : parseFloat(edit.insert);
    return number * LENGTHS[unit || pictureUnit];
  });
  const isMoved = (joint) => joint.some(({ from }) => edits.some((edit) => edit.from === from));
  const found = [];
  for (const [, first, second, name] of plain.matchAll(LINK)) {
    const [a, b, input] = [joints.get(first), joints.get(second), inputs.get(name)];
    if (!a || !b || !input || !(isMoved(a) || isMoved(b))) continue;
    const [[ax, ay], [bx, by]] = [place(a), place(b)];
    const turn = input.unit === "deg" ? 360 : 2 * Math.PI;
    const angle = Math.atan2(by - ay, bx - ax) / (2 * Math.PI) * turn;
    // The turn that is nearest to the number that is written.
    const next = angle + Math.round((input.value - angle) / turn) * turn;
    found.push({ from: input.from, to: input.to, insert: `${Number(next.toFixed(6))}${input.unit}` });
  }
  return found;
}

// The edits of a text that move a joint by a way in the unit of the picture, in whole steps; null if its units are none of lengths.
export function moved(joint, way, pictureUnit, pixel) {
  const units = joint.map(({ unit, value }) => unit || (value === 0 ? pictureUnit : ""));
  if (![pictureUnit, ...units].every((unit) => Object.hasOwn(LENGTHS, unit))) return null;
  return joint.map(({ from, to, value }, k) => {
    const factor = LENGTHS[pictureUnit] / LENGTHS[units[k]];
    const step = 10 ** Math.floor(Math.log10(pixel * factor));
    const next = Number((Math.round((value + way[k] * factor) / step) * step).toPrecision(12));
    return { from, to, insert: `${next}${units[k]}` };
  });
}
