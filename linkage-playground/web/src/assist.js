// Hover, completion, calls and values, from the code of the language server.

import { element } from "./dom.js";
import { shownMarkdown } from "./markdown.js";

// Milliseconds without a key before values are asked for.
const PAUSE = 400;

// The answers about the text of the editor; null if the compiler was stopped, or knows nothing.
export class Assist {
  #compiler;
  #text;
  #timer = null;

  // `text` gives the current text.
  constructor(compiler, text) {
    this.#compiler = compiler;
    this.#text = text;
  }

  async #ask(request) {
    const answer = await this.#compiler.ask({ ...request, text: this.#text() });
    return answer === null ? null : JSON.parse(answer);
  }

  hover = async (_, at) => {
    const found = await this.#ask({ do: "hover", at });
    if (!found?.markdown) return null;
    const create = () => ({ dom: element("div", { class: "hover" }, ...shownMarkdown(found.markdown)) });
    return { pos: found.from, end: found.to, above: true, create };
  };

  complete = async (context) => {
    const { pos, explicit } = context;
    if (!explicit && context.matchBefore(/[\p{L}\d_.]$/u) === null) return null;
    const found = await this.#ask({ do: "complete", at: pos });
    return found?.options?.length > 0 ? { ...found, validFor: /^[\p{L}\d_]*$/u } : null;
  };

  signature = async (at) => {
    const found = await this.#ask({ do: "signature", at });
    return found?.label === undefined ? null : found;
  };

  // Gives values next to names, and names that are words elsewhere, to `show`, unless the text changes before.
  hintsLater(show) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(async () => {
      const text = this.#text();
      const found = await this.#ask({ do: "hints" });
      if (found?.values !== undefined && text === this.#text()) show(found);
    }, PAUSE);
  }
}
