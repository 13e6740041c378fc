// Hover and completion, from the code of the language server.

import { element } from "./dom.js";

export function hoverWith(compiler, text) {
  return async (_, at) => {
    const answer = await compiler.ask({ do: "hover", text: text(), at });
    const found = answer === null ? null : JSON.parse(answer);
    if (!found?.text) return null;
    const create = () => ({ dom: element("div", { class: "hover" }, found.text) });
    return { pos: found.from, end: found.to, above: true, create };
  };
}

export function completeWith(compiler, text) {
  return async ({ pos, explicit, matchBefore, ...context }) => {
    const word = context.state.doc.sliceString(Math.max(0, pos - 80), pos).match(/[\p{L}\d_.]*$/u)[0];
    if (word === "" && !explicit) return null;
    const answer = await compiler.ask({ do: "complete", text: text(), at: pos });
    const found = answer === null ? null : JSON.parse(answer);
    return found?.options?.length > 0 ? found : null;
  };
}
