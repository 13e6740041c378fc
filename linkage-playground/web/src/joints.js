// Joints as they are drawn, in the text: where their coordinates are, and other ones.

const WORD = "[\\p{L}_][\\p{L}\\d_]*";
const NUMBER = "[-+\\u2212]?\\s*\\d[\\d_]*(?:\\.\\d+)?(?:[eE][-+]?\\d+)?";
const JOINT = new RegExp(`(${WORD})\\s*=\\s*\\(\\s*(${NUMBER})\\s*([a-z\\u00b5]*)\\s*,\\s*(${NUMBER})\\s*([a-z\\u00b5]*)\\s*\\)`, "gudi");

// Metres.
const LENGTHS = { m: 1, mm: 1e-3, cm: 1e-2, um: 1e-6, "\u00b5m": 1e-6, inch: 0.0254, ft: 0.3048 };

// All joints of a text whose two coordinates are written as numbers, by name: the stretch of each coordinate, its number and its unit.
export function drawnJoints(text) {
  const plain = text.replace(/\/\/[^\n]*|\/\*[^]*?\*\//g, (comment) => comment.replace(/[^\n]/g, " "));
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
