// Values as they are typed: numbers with units, sums and products of them, as `--set` takes them.

// Powers of length, force, time and mass.
const QUANTITIES = { number: [0, 0, 0, 0], length: [1, 0, 0, 0], force: [0, 1, 0, 0], time: [0, 0, 1, 0], mass: [0, 0, 0, 1], energy: [1, 1, 0, 0], power: [1, 1, -1, 0], pressure: [-2, 1, 0, 0] };

// By quantity: the unit, its power of ten, a whole factor, and a whole divisor if it has one.
const UNITS = new Map(Object.entries({
  length: "m 0 1 mm -3 1 cm -2 1 um -6 1 \u00b5m -6 1 \u03bcm -6 1 nm -9 1 inch -4 254 ft -4 3048",
  mass: "kg 0 1 g -3 1 mg -6 1 t 3 1 lb -8 45359237",
  force: "N 0 1 mN -3 1 kN 3 1 lbf -13 44482216152605",
  time: "s 0 1 ms -3 1 min 0 60",
  energy: "J 0 1 mJ -3 1 kJ 3 1",
  power: "W 0 1 mW -3 1 kW 3 1",
  pressure: "Pa 0 1 kPa 3 1 MPa 6 1 psi -5 44482216152605/64516",
}).flatMap(([quantity, list]) => list.match(/\S+ \S+ \S+/g).map((row) => {
  const [name, ten, factor] = row.split(" ");
  const [whole, divisor = 1] = factor.split("/").map(Number);
  return [name, { powers: QUANTITIES[quantity], ten: Number(ten), whole, divisor }];
})));

// Angles: how many of them are half a turn.
const ANGLES = { deg: 180, rad: Math.PI, arcmin: 10800, arcsec: 648000, turn: 0.5 };

// Angular speeds: how many of them are half a turn in a second.
const SPINS = { rpm: 30 };

const CALLS = {
  sqrt: { of: Math.sqrt, count: 1 }, abs: { of: Math.abs, count: 1 }, min: { of: Math.min, count: 2 }, max: { of: Math.max, count: 2 }, hypot: { of: Math.hypot, count: 2 },
  sin: { of: Math.sin, count: 1, takes: "angle" }, cos: { of: Math.cos, count: 1, takes: "angle" }, tan: { of: Math.tan, count: 1, takes: "angle" },
  asin: { of: Math.asin, count: 1, gives: "angle" }, acos: { of: Math.acos, count: 1, gives: "angle" }, atan: { of: Math.atan, count: 1, gives: "angle" }, atan2: { of: Math.atan2, count: 2, gives: "angle" },
};

// Why a text is no value.
class TypedError extends Error {}

function refuse(why) {
  throw new TypedError(why);
}

// The value of a text in a unit of the report. A number without a unit is in the unit that is shown, angles in degrees.
function typedValue(text, unit) {
  const lengths = (unit.match(/[a-z\u00b5\u03bc]+/gi) ?? []).filter((name) => UNITS.get(name)?.powers === QUANTITIES.length);
  const length = UNITS.get(lengths[0] ?? "m");
  const found = readTyped(text, length);
  if (!Number.isFinite(found.x)) refuse("this is no number");
  if (found.bare) return fromPlot(found.x, unit);
  const wanted = readTyped(unit || "1", length);
  const own = found.angle && unit === "" ? null : inPowers(found, wanted, length);
  return own === null ? refuse(`this is ${kindOf(found)}, and not ${unit ? `in ${plotUnit(unit)}` : "a number"}`) : own.x / wanted.x;
}

function kindOf({ powers, angle }) {
  if (angle) return "an angle";
  const [name] = Object.entries(QUANTITIES).find(([, own]) => own.join() === powers.join()) ?? ["product"];
  return `${/^[aeiou]/.test(name) ? "an" : "a"} ${name}`;
}

// With the powers of another value, if only masses are written as forces over accelerations; null otherwise.
function inPowers(value, { powers }, length) {
  if (value.powers.join() === powers.join()) return value;
  const apart = powers[3] - value.powers[3];
  // One kilogram is one newton and square second over a metre.
  const moved = value.powers.map((power, k) => power + [apart, -apart, -2 * apart, apart][k]);
  if (moved.join() !== powers.join()) return null;
  return { ...value, powers: moved, x: value.x / (10 ** length.ten * length.whole) ** apart };
}

function readTyped(text, length) {
  let at = 0;
  let calls = 0;
  const next = (pattern) => {
    const found = new RegExp(`\\s*(${pattern})`, "yu");
    found.lastIndex = at;
    const hit = found.exec(text);
    if (hit === null) return null;
    at = found.lastIndex;
    return hit[1];
  };
  const expected = (what) => refuse(/\S/.test(text.slice(at)) ? `${what} is expected at "${text.slice(at).trim()}"` : `${what} is expected at the end`);
  const sum = () => {
    let own = product();
    for (let sign = next("[-+\u2212\u00b1]"); sign !== null; sign = next("[-+\u2212\u00b1]")) {
      if (sign === "\u00b1" || (sign === "+" && next("[-\u2212]|/\\s*-") !== null)) refuse("a tolerance cannot be changed here");
      own = added(own, product(), sign === "+" ? 1 : -1, length);
    }
    return own;
  };
  const product = () => {
    let own = factor();
    for (let sign = next("[*/\u00b7]"); sign !== null; sign = next("[*/\u00b7]")) own = multiplied(own, factor(), sign === "/" ? -1 : 1);
    return own;
  };
  const factor = () => {
    if (next("[-\u2212]") !== null) {
      const own = factor();
      return { ...own, x: -own.x };
    }
    if (next("\\(") !== null) return closed(sum());
    // Between arguments of a call a comma is no decimal mark.
    const number = next(`(?:\\d[\\d_]*)?[.${calls > 0 ? "" : ","}]?\\d[\\d_]*(?:[eE][-+]?\\d+)?`);
    if (number !== null) return literal(number.replaceAll("_", "").replace(",", "."));
    const word = next("[\\p{L}_][\\p{L}\\d_]*") ?? expected("a number");
    if (word === "PI") return { ...PLAIN, x: Math.PI, angle: true, bare: false };
    // A minute is called so, too.
    if (Object.hasOwn(CALLS, word) && next("\\(") !== null) return called(CALLS[word], word);
    return measured("1", word);
  };
  const closed = (own) => (next("\\)") === null ? expected("a closing bracket") : own);
  const called = (own, word) => {
    calls += 1;
    const values = [sum()];
    while (next(",") !== null) values.push(sum());
    closed(null);
    calls -= 1;
    return callOf(own, word, values, length);
  };
  // The unit is the next word.
  const literal = (number) => {
    const word = next("[\\p{L}_][\\p{L}\\d_]*");
    return word === null ? { ...PLAIN, x: Number(number) } : measured(number, word);
  };
  const measured = (number, word) => {
    const power = Number(next("\\^\\s*-?\\d+")?.slice(1) ?? 1);
    if (Object.hasOwn(ANGLES, word)) return { ...PLAIN, x: word === "rad" ? Number(number) : (Number(number) * Math.PI) / ANGLES[word], angle: true, bare: false };
    if (Object.hasOwn(SPINS, word)) return { powers: [0, 0, -1, 0], x: (Number(number) * Math.PI) / SPINS[word], angle: true, bare: false };
    const unit = UNITS.get(word) ?? refuse(`"${word}" is no unit; units are ${[...UNITS.keys(), ...Object.keys(ANGLES), ...Object.keys(SPINS)].join(" ")}`);
    const powers = unit.powers.map((own) => own * power);
    const ten = power * (unit.ten - unit.powers[0] * length.ten);
    const [above, below] = power > 0 ? [power, 0] : [0, -power];
    const wholes = unit === length ? 1 : unit.whole ** below * unit.divisor ** power * length.whole ** powers[0];
    return { powers, angle: false, bare: false, x: scaledExactly(number, unit === length ? 1 : unit.whole ** above, ten) / wholes };
  };
  const own = sum();
  return /\S/.test(text.slice(at)) ? expected("+, -, * or /") : own;
}

const PLAIN = { powers: QUANTITIES.number, angle: false, bare: true };

// A decimal number times whole numbers, rounded once.
function scaledExactly(number, whole, ten) {
  const [, before, after = "", power = 0] = /^(\d*)\.?(\d*)(?:e([-+]?\d+))?$/i.exec(number);
  return Number(`${BigInt(before + after) * BigInt(whole)}e${Number(power) + ten - after.length}`);
}

function added(a, b, sign, length) {
  const [own, other] = a.bare && a.x === 0 ? [{ ...b, x: 0 }, b] : [a, b.bare && b.x === 0 ? { ...a, x: 0 } : b];
  if (own.bare !== other.bare) refuse("of a sum all parts have units, or none");
  const { x } = inPowers(other, own, length) ?? refuse(`${kindOf(own)} and ${kindOf(other)} have no sum`);
  return { ...own, angle: own.angle || other.angle, x: own.x + sign * x };
}

function multiplied(a, b, sign) {
  const powers = a.powers.map((power, k) => power + sign * b.powers[k]);
  return { powers, angle: a.angle !== b.angle, bare: a.bare && b.bare, x: sign > 0 ? a.x * b.x : a.x / b.x };
}

function callOf({ of, count, takes, gives }, word, values, length) {
  if (values.length !== count) refuse(`${word} takes ${count === 1 ? "one value" : `${count} values`}`);
  const first = values.reduce((one, other) => added(one, other, 1, length));
  const isNumber = first.powers.every((power) => power === 0);
  if (takes === "angle" && !(isNumber && (first.angle || !first.bare))) refuse(`${word} takes an angle, 30deg`);
  const x = of(...values.map((own) => own.x));
  if (takes === "angle") return { ...PLAIN, x };
  if (gives === "angle") return { ...PLAIN, x, angle: true, bare: false };
  return { ...first, x, powers: word === "sqrt" ? first.powers.map((power) => power / 2) : first.powers };
}
