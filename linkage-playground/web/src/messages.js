// The list of messages below the text.

import { byId, element } from "./dom.js";

export function showMessages(messages, text, go) {
  const rows = messages.map(({ from, severity, text: words }) => {
    const line = text.slice(0, from).split("\n").length;
    const button = element("button", { type: "button" }, element("small", {}, `line ${line} `), words);
    button.addEventListener("click", () => go(from));
    return element("li", { "data-severity": severity }, button);
  });
  byId("messages").replaceChildren(...rows);
}
