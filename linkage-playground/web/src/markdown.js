// The Markdown of descriptions as elements: paragraphs, rules, lines of code, words in back-ticks, strong words.

import { element } from "./dom.js";

export function shownMarkdown(text) {
  const blocks = text.split(/^```[a-z]*\n([^]*?)^```$/m);
  return blocks.flatMap((block, k) => (k % 2 === 1 ? [element("pre", {}, block.trimEnd())] : paragraphs(block)));
}

function paragraphs(text) {
  const all = text.split(/\n{2,}/).map((paragraph) => paragraph.trim()).filter((paragraph) => paragraph !== "");
  return all.map((paragraph) => (/^-{3,}$/.test(paragraph) ? element("hr") : element("p", {}, ...inline(paragraph))));
}

function inline(text) {
  return text.split(/(`[^`]+`|\*\*[^*]+\*\*)/).map((part) => {
    if (/^`.+`$/.test(part)) return element("code", {}, part.slice(1, -1));
    if (/^\*\*.+\*\*$/.test(part)) return element("strong", {}, part.slice(2, -2));
    return part;
  });
}
