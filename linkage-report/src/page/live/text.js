// The text of the mechanism with the dimensions of the page as its defaults.

function startText() {
  if (report.live.source === undefined) return;
  byId("tables").querySelector("[data-file='data.json']").after(downloadButton(`${engine.programs[0].name}.mech`, () => new Blob([textNow()], { type: "text/plain" })));
}

function textNow() {
  const { edits, lost } = textEdits();
  let text = report.live.source;
  for (const { from, to, insert } of edits.toReversed()) text = text.slice(0, from) + insert + text.slice(to);
  const line = changesLine();
  const notes = [...(line ? [line] : []), ...(lost.length > 0 ? [`not part of this text: ${lost.join(", ")}`] : [])];
  return notes.map((note) => `// ${note}\n`).join("") + text;
}

// The stretches of the text that are other dimensions now, in order; `lost` are the names of dimensions without a stretch of their own.
function textEdits() {
  const places = changedFromDeclaration().map((name) => ({ name, place: defaultPlace(report.live.source, name) }));
  const edits = places.filter(({ place }) => place !== null).map(({ name, place: [from, to] }) => ({ from, to, insert: declaredText(name) }));
  const lost = places.filter(({ place }) => place === null).map(({ name }) => name);
  return { edits: edits.sort((a, b) => a.from - b.from), lost };
}

// A dimension in the unit of the report, as a literal.
function declaredText(name) {
  const { unit } = engine.programs[0].dimensions.find((own) => own.name === name);
  const value = live.dimensions.get(name);
  return unit === "rad" ? `${rounded(toDegrees(value), 15)}deg` : `${value}${unit}`;
}

// Where the default of a dimension is in the text, without its tolerance; null where it is no number or vector of its own.
function defaultPlace(source, name) {
  // Comments are as long as before, and say nothing.
  const text = source.replace(/\/\/[^\n]*|\/\*[^]*?\*\//g, (comment) => comment.replace(/[^\n]/g, " "));
  const word = (own) => `(?<![\\p{L}\\d_])${own}(?![\\p{L}\\d_])`;
  const [begin] = placeAfter(text, new RegExp(`${word("struct")}\\s+${word(engine.programs[0].name)}`, "gu"), 0) ?? [text.length];
  const end = placeAfter(text, new RegExp(word("struct"), "gu"), begin)?.[0] ?? text.length;
  const find = (own) => {
    const found = placeAfter(text, new RegExp(`${word("param")}\\s+${word(own)}\\s*=\\s*`, "gu"), begin);
    return found !== null && found[0] < end ? found[0] : jointPlace(text, own, begin, end);
  };
  const whole = find(name);
  if (whole !== null) return nominalPlace(text, whole);
  const link = /^(.*)\.length$/.exec(name)?.[1];
  if (link !== undefined) return lengthPlace(text, link, begin, end);
  const [, stem, axis] = /^([^.]*)\.([xyz])$/.exec(name) ?? [];
  const vector = stem === undefined ? null : find(stem);
  if (vector === null || text[vector] !== "(") return null;
  let place = nominalPlace(text, vector + 1);
  for (let k = 0; k < "xyz".indexOf(axis); k += 1) {
    const comma = endOf(text, place[1], ",");
    if (text[comma] !== ",") return null;
    place = nominalPlace(text, comma + 1);
  }
  // What stands in brackets may be a part of a longer expression.
  const closing = endOf(text, place[1], ")");
  return /^\)\s*([;,]|\+\s*-|\+\/-)/.test(text.slice(closing)) ? place : null;
}

// Where the drawn position of a joint begins; null for names of other things.
function jointPlace(text, name, begin, end) {
  for (const { index, 0: word } of text.slice(begin, end).matchAll(/(?<![\p{L}\d_])joint(?![\p{L}\d_])/gu)) {
    for (let at = begin + index + word.length; at < end; at = endOf(text, at, ",", ";") + 1) {
      const [before, own] = /^\s*([\p{L}_][\p{L}\d_]*)\s*=\s*/u.exec(text.slice(at, end)) ?? [];
      if (own === name) return at + before.length;
      if (own === undefined || text[endOf(text, at, ",", ";")] === ";") break;
    }
  }
  return null;
}

// Where the length of a link is, if it is written as a number.
function lengthPlace(text, link, begin, end) {
  const pattern = new RegExp(`(?<![\\p{L}\\d_])link\\s+${link}\\s*:[^;]*?(?<![\\p{L}\\d_])length\\s+(?=[-\\d.]+\\s*[a-z]*\\s*([,;+]|mass|inertia|at))`, "gu");
  const found = placeAfter(text, pattern, begin);
  if (found === null || found[0] >= end) return null;
  return [found[0], found[0] + /^[-\d.]+\s*(?!mass|inertia|at)[a-z]*/.exec(text.slice(found[0]))[0].trimEnd().length];
}

function placeAfter(text, pattern, from) {
  pattern.lastIndex = from;
  return pattern.exec(text) === null ? null : [pattern.lastIndex];
}

// A value up to its tolerance or its end, without the spaces around it.
function nominalPlace(text, from) {
  const begin = from + /^\s*/.exec(text.slice(from))[0].length;
  const end = endOf(text, begin, "+-", ";", ",");
  return [begin, begin + text.slice(begin, end).trimEnd().length];
}

// Where one of some signs is outside of inner brackets, or these end.
function endOf(text, from, ...signs) {
  let depth = 0;
  for (let at = from; at < text.length; at += 1) {
    if (depth === 0 && (text[at] === ")" || signs.some((sign) => (sign === "+-" ? /^\+\/?\s*-/.test(text.slice(at, at + 9)) : text[at] === sign)))) return at;
    depth += { "(": 1, ")": -1 }[text[at]] ?? 0;
  }
  return text.length;
}
