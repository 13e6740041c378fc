// The buttons above the text, and their keys.

import { byId } from "./dom.js";
import { openFile } from "./files.js";

// `does` has the work of the buttons, by their names.
export function startButtons(does) {
  byId("examples").addEventListener("change", ({ target }) => {
    does.choose(target.value);
    target.value = "";
  });
  byId("export").addEventListener("change", ({ target }) => {
    does.export(target.value);
    target.value = "";
  });
  byId("mechanisms").addEventListener("change", ({ target }) => does.select(target.value));
  for (const name of ["undo", "redo", "save", "share", "format", "offer", "shape", "stop"]) byId(name).addEventListener("click", () => does[name]());
  const open = async () => does.open(await openFile());
  byId("open").addEventListener("click", open);
  startMore();
  const keys = { s: does.save, o: open, ".": does.offer };
  document.addEventListener("keydown", (event) => {
    const work = (event.ctrlKey || event.metaKey) && !event.altKey && !event.shiftKey ? keys[event.key] : undefined;
    if (work === undefined) return;
    event.preventDefault();
    work();
  });
}

// On a phone, further buttons are in rows of their own, which close after a choice.
function startMore() {
  const more = byId("more");
  const put = (isOpen) => more.setAttribute("aria-expanded", String(isOpen));
  more.addEventListener("click", () => put(more.getAttribute("aria-expanded") !== "true"));
  byId("further").addEventListener("click", ({ target }) => target.closest("button") && put(false));
  byId("further").addEventListener("change", () => put(false));
  byId("tabs").addEventListener("click", () => put(false));
}

// Buttons that have nothing to do are off.
export function showSteps({ undo, redo }) {
  byId("undo").disabled = undo === 0;
  byId("redo").disabled = redo === 0;
}
