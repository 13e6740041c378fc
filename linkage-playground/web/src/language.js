// Colours for the words of the language.

import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { tags } from "@lezer/highlight";

const ITEMS = new Set("unit param input unknown let const argument loop joint link slider gears belt weld part body mass inertia gravity force moment spring damper friction cam law struct impl fn pub pin in at along on around through length teeth radii radius block allow over from to".split(" "));

const parser = {
  name: "linkage",
  startState: () => ({ comment: false }),
  token(stream, state) {
    if (state.comment) {
      if (stream.skipTo("*/")) {
        stream.pos += 2;
        state.comment = false;
      } else stream.skipToEnd();
      return "comment";
    }
    if (stream.eatSpace()) return null;
    if (stream.match("//")) {
      stream.skipToEnd();
      return "comment";
    }
    if (stream.match("/*")) {
      state.comment = true;
      return "comment";
    }
    if (stream.match(/^\d[\d_]*(\.\d+)?([eE][-+]?\d+)?/)) return "number";
    if (stream.match(/^[\p{L}_][\p{L}\d_]*/u)) return wordKind(stream);
    stream.next();
    return "operator";
  },
  languageData: { commentTokens: { line: "//" }, closeBrackets: { brackets: ["(", "[", "{"] } },
};

function wordKind(stream) {
  const word = stream.current();
  // A unit is right behind its number.
  const before = stream.string[stream.start - 1];
  if (before !== undefined && /\d/.test(before)) return "unit";
  if (ITEMS.has(word)) return "keyword";
  return stream.match(/^\s*\(/, false) ? "function" : "variableName";
}

const language = StreamLanguage.define({
  ...parser,
  tokenTable: { unit: tags.unit, function: tags.function(tags.variableName) },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--comment)" },
  { tag: tags.keyword, color: "var(--keyword)", fontWeight: "600" },
  { tag: tags.number, color: "var(--number)" },
  { tag: tags.unit, color: "var(--unit)" },
  { tag: tags.function(tags.variableName), color: "var(--function)" },
]);

export const linkage = [language, syntaxHighlighting(colours)];
