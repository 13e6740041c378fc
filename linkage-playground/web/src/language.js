// Colours for the words of the language.

import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { tags } from "@lezer/highlight";

// `keywords` and `functions` are the words that the compiler has.
function parserOf({ keywords, functions }) {
  const [fixed, called] = [new Set(keywords), new Set(functions)];
  const wordKind = (stream) => {
    const word = stream.current();
    // A unit is right behind its number.
    const before = stream.string[stream.start - 1];
    if (before !== undefined && /\d/.test(before)) return "unit";
    if (called.has(word) && stream.peek() === "(") return "function";
    return fixed.has(word) ? "keyword" : "variableName";
  };
  return {
    name: "linkage",
    startState: () => ({ comment: false, depth: 0 }),
    token: (stream, state) => tokenOf(stream, state, wordKind),
    indent: ({ depth }, after, { unit }) => Math.max(0, depth - (/^\s*[})\]]/.test(after) ? 1 : 0)) * unit,
    // The end of a block is on a line of its own, where a bracket that the editor has written would be a second one.
    languageData: { commentTokens: { line: "//" }, closeBrackets: { brackets: ["(", "["] }, indentOnInput: /^\s*[})\]]$/ },
  };
}

function tokenOf(stream, state, wordKind) {
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
  state.depth = Math.max(0, state.depth + (DEPTHS[stream.next()] ?? 0));
  return "operator";
}

const DEPTHS = { "{": 1, "(": 1, "[": 1, "}": -1, ")": -1, "]": -1 };

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--comment)" },
  { tag: tags.keyword, color: "var(--keyword)", fontWeight: "600" },
  { tag: tags.number, color: "var(--number)" },
  { tag: tags.unit, color: "var(--unit)" },
  { tag: tags.function(tags.variableName), color: "var(--function)" },
]);

export function colouredWith(words) {
  const language = StreamLanguage.define({ ...parserOf(words), tokenTable: { unit: tags.unit, function: tags.function(tags.variableName) } });
  return [language, syntaxHighlighting(colours)];
}
