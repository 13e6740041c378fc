// Hover and completion, from the code of the language server.

import { element } from "./dom.js";
import { shownMarkdown } from "./markdown.js";

export function hoverWith(compiler, text) {
  return async (_, at) => {
    const answer = await compiler.ask({ do: "hover", text: text(), at });
    const found = answer === null ? null : JSON.parse(answer);
    if (!found?.markdown) return null;
    const create = () => ({ dom: element("div", { class: "hover" }, ...shownMarkdown(found.markdown)) });
    return { pos: found.from, end: found.to, above: true, create };
  };
}

export function completeWith(compiler, text) {
  return async (context) => {
    const { pos, explicit } = context;
    if (!explicit && context.matchBefore(/[\p{L}\d_.]$/u) === null) return null;
    const answer = await compiler.ask({ do: "complete", text: text(), at: pos });
    const found = answer === null ? null : JSON.parse(answer);
    return found?.options?.length > 0 ? { ...found, validFor: /^[\p{L}\d_]*$/u } : null;
  };
}
