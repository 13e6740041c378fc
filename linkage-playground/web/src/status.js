// Remarks below the text, and the reason why the mechanism is older than the text.

import { byId } from "./dom.js";
import { lineOf } from "./messages.js";

let remark = "";
let count = "";

function write() {
  byId("status").textContent = [remark, count].filter((part) => part !== "").join(" ");
}

// A remark stays until the text changes.
export function say(text) {
  remark = text;
  write();
}

export function sayMessages(messages) {
  const { length } = messages.filter(({ severity }) => severity === "error");
  count = length === 0 ? "" : `${length} ${length === 1 ? "mistake" : "mistakes"} in the text.`;
  byId("text-tab").textContent = length === 0 ? "Text" : `Text (${length} ${length === 1 ? "mistake" : "mistakes"})`;
  write();
}

// The reason is the first mistake: it is shown beside the mechanism, since the text may be on another tab.
export function sayStale(messages, text, hasMechanism, go) {
  const first = messages.find(({ severity }) => severity === "error") ?? messages[0];
  const [fact] = (first?.text ?? "there is no mechanism in the text").split("\n");
  const [words, button] = byId("stale").children;
  const where = first === undefined ? "" : `Line ${lineOf(text, first.from)}: `;
  words.textContent = `${where}${fact}. ${hasMechanism ? "This is the last mechanism without a mistake." : "There is no mechanism to show yet."}`;
  button.onclick = () => go(first?.from ?? 0);
  byId("stale").hidden = false;
}

export function sayCurrent() {
  byId("stale").hidden = true;
}
