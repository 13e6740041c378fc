// The list of messages below the text.

import { byId, element } from "./dom.js";

export function lineOf(text, place) {
  return text.slice(0, place).split("\n").length;
}

export function showMessages(messages, text, go) {
  const rows = messages.map(({ from, severity, text: words }) => {
    const button = element("button", { type: "button" }, element("small", {}, `line ${lineOf(text, from)} `), words);
    button.addEventListener("click", () => go(from));
    return element("li", { "data-severity": severity }, button);
  });
  byId("messages").replaceChildren(...rows);
}
