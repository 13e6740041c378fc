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

// The number of mistakes, below the text and on its tab.
export function sayMessages(messages) {
  const { length } = messages.filter(({ severity }) => severity === "error");
  count = length === 0 ? "" : `${length} ${length === 1 ? "mistake" : "mistakes"} in the text.`;
  byId("text-tab").textContent = length === 0 ? "Text" : `Text (${length} ${length === 1 ? "mistake" : "mistakes"})`;
  write();
}

// The reason why the mechanism is older than the text is shown beside the mechanism, since the text may be on another tab. The button leads on.
function sayOlder(reason, button, work, isMistake = false) {
  const [words, leading] = byId("stale").children;
  byId("stale").classList.toggle("mistake", isMistake);
  words.textContent = reason;
  leading.textContent = button;
  leading.onclick = work;
  byId("stale").hidden = false;
}

// `before` names what is shown, if anything is.
const whatIsShown = (hasMechanism, before) => (hasMechanism ? `This is ${before}.` : "There is no mechanism to show yet.");

// The text has a mistake: the reason is the first one.
export function sayMistake(messages, text, hasMechanism, go) {
  const first = messages.find(({ severity }) => severity === "error") ?? messages[0];
  const [fact] = (first?.text ?? "there is no mechanism in the text").split("\n");
  const where = first === undefined ? "" : `Line ${lineOf(text, first.from)}: `;
  sayOlder(`${where}${fact}. ${whatIsShown(hasMechanism, "the last mechanism without a mistake")}`, "Show in the text", () => go(first?.from ?? 0), true);
}

// The text is being compiled.
export function sayLate(hasMechanism, stop) {
  byId("busy").hidden = false;
  sayOlder(`The compiler is at work on the last change. ${whatIsShown(hasMechanism, "the mechanism before it")}`, "Stop", stop);
}

// The compiler was stopped.
export function sayStopped(hasMechanism, again) {
  byId("busy").hidden = true;
  sayOlder(`The compiler was stopped. ${whatIsShown(hasMechanism, "the mechanism before the last change")}`, "Compile again", again);
}

// The mechanism is that of the text.
export function sayCurrent() {
  byId("stale").hidden = true;
}

// The compiler is at work no longer.
export function sayDone() {
  byId("busy").hidden = true;
}
