// The playground: text, messages and mechanism, and the buttons above them.

import { Analyses } from "./analyses.js";
import { completeWith, hoverWith } from "./assist.js";
import { format, offerChanges } from "./changes.js";
import { Compiler, unpacked } from "./compiler.js";
import { byId, element } from "./dom.js";
import { TextDrag } from "./drag.js";
import { makeEditor } from "./editor.js";
import { openFile, saveFile } from "./files.js";
import { showTab, startBorder, startTabs, startTheme } from "./layout.js";
import { showMessages } from "./messages.js";
import { Shaping } from "./shaping.js";
import { fragmentOf, textOf } from "./share.js";
import { View } from "./view.js";

const parts = { frame: FRAME, worker: WORKER };

const file = { name: "mechanism.mech" };
// The pages of the last text without a mistake, and the name of the one that is shown.
const shown = { pages: [], name: null };

function say(text) {
  byId("status").textContent = text;
}

async function start() {
  const base64 = byId("module").textContent.trim();
  const framed = View.ready(byId("frame"), parts.frame);
  const compiler = new Compiler(parts.worker, await unpacked(base64));
  await framed;
  const root = byId("editor").attachShadow({ mode: "open" });
  const text = () => editor.text();
  const editor = makeEditor(root, { changed, hover: hoverWith(compiler, text), complete: completeWith(compiler, text) });
  const drag = new TextDrag(editor);
  const analyses = new Analyses(compiler, { text, show, waiting: (long) => (byId("busy").hidden = !long) });
  // Changes of the text that are shown already are not analysed.
  let quiet = false;

  function changed() {
    if (!quiet) analyses.want();
  }

  function quietly(work) {
    quiet = true;
    try {
      return work();
    } finally {
      quiet = false;
    }
  }

  function endDrag() {
    if (!drag.isRunning) return;
    quietly(() => drag.end());
    analyses.want();
  }

  const view = new View(byId("frame"), {
    changed: () => {
      const { edits, lost } = view.handle.edits();
      quietly(() => drag.follow(view.handle.source, edits));
      if (lost.length > 0) say(`${lost.join(", ")}: the text has no number for this. Use "Move joints", or write a length.`);
    },
    kept: endDrag,
    page: async () => (await exported("page"))[0].text,
  });
  const shaping = new Shaping(view, {
    follow: (source, edits) => drag.follow(source, edits),
    done: endDrag,
  });

  function show(source, { messages, pages }) {
    editor.tell(messages);
    showMessages(messages, source, editor.go);
    const isFaulty = messages.some(({ severity }) => severity === "error");
    say(isFaulty ? `${messages.length} ${messages.length === 1 ? "message" : "messages"}` : "");
    if (pages.length === 0) view.outdated();
    else showSafely(pages);
    document.body.dataset.shown = String(Number(document.body.dataset.shown ?? 0) + 1);
  }

  // A page that fails leaves the text alive.
  function showSafely(pages) {
    try {
      showPages(pages);
    } catch (error) {
      view.outdated();
      say(`The mechanism cannot be shown: ${error.message}`);
    }
  }

  function showPages(pages) {
    shown.pages = pages;
    const names = pages.map(({ name }) => name);
    if (!names.includes(shown.name)) shown.name = names.at(-1);
    byId("which").hidden = names.length < 2;
    byId("mechanisms").replaceChildren(...names.map((name) => element("option", { value: name }, name)));
    byId("mechanisms").value = shown.name;
    showPage();
  }

  function showPage() {
    view.show(shown.pages.find(({ name }) => name === shown.name), shaping.isHeld || shaping.isOn);
    shaping.mark();
  }

  function open(name, text) {
    file.name = name;
    view.forget();
    editor.open(text);
    analyses.want();
    showTab("text");
  }

  async function exported(format) {
    const answer = await compiler.ask({ do: "export", text: text(), format, mechanism: shown.name });
    const files = answer === null ? { failure: "stopped" } : JSON.parse(answer);
    if (Array.isArray(files)) return files;
    throw new Error(files.failure ?? files.panic);
  }

  async function exportAs(format) {
    try {
      for (const { name, text } of await exported(format)) saveFile(name, text);
    } catch ({ message }) {
      say(message);
    }
  }

  async function share() {
    const address = `${location.href.split("#")[0]}#${await fragmentOf(text())}`;
    history.replaceState(null, "", address);
    // Pages that were opened as files may not use the clipboard in some browsers: the address has it, too.
    const copied = await navigator.clipboard?.writeText(address).then(() => true, () => false);
    say(copied ? "The address is copied. It has the text in it." : "The address of this page has the text in it.");
  }

  function startButtons(examples) {
    byId("examples").append(element("option", { value: "" }, "choose"), ...examples.map(({ name, about }) => element("option", { value: name }, `${name}: ${about}`)));
    byId("examples").addEventListener("change", ({ target }) => {
      const example = examples.find(({ name }) => name === target.value);
      if (example) open(`${example.name}.mech`, example.text);
      target.value = "";
    });
    const openOwn = async () => {
      const { name, text } = await openFile();
      open(name, text);
    };
    const save = () => saveFile(file.name, text());
    byId("open").addEventListener("click", openOwn);
    byId("save").addEventListener("click", save);
    byId("share").addEventListener("click", share);
    byId("export").addEventListener("change", async ({ target }) => {
      const format = target.value;
      target.value = "";
      await exportAs(format);
    });
    byId("shape").addEventListener("click", ({ target }) => {
      shaping.turn(!shaping.isOn);
      target.setAttribute("aria-pressed", String(shaping.isOn));
      say(shaping.isOn ? "Drag joints that the text has as `joint name = (x, y)`, or move them by arrow keys." : "");
      if (shaping.isOn) showTab("view");
    });
    byId("mechanisms").addEventListener("change", ({ target }) => {
      shown.name = target.value;
      showPage();
    });
    byId("stop").addEventListener("click", () => {
      compiler.stop();
      say("Stopped. The next key starts the compiler again.");
    });
    const offer = () => offerChanges(compiler, editor, say);
    byId("format").addEventListener("click", () => format(compiler, editor, say));
    byId("offer").addEventListener("click", offer);
    const keys = { s: save, o: openOwn, ".": offer };
    document.addEventListener("keydown", (event) => {
      const own = (event.ctrlKey || event.metaKey) && !event.altKey && !event.shiftKey ? keys[event.key] : undefined;
      if (own === undefined) return;
      event.preventDefault();
      own();
    });
  }

  // Steps of the page in the frame are those of the text.
  view.document.addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || (key !== "z" && key !== "y")) return;
    if (event.target.matches?.("input")) return;
    event.preventDefault();
    event.stopPropagation();
    if (key === "y" || event.shiftKey) editor.redo();
    else editor.undo();
  }, { capture: true });
  addEventListener("hashchange", async () => {
    const text = await textOf(location.hash);
    if (text !== null && text !== editor.text()) open(file.name, text);
  });

  startTabs();
  startBorder();
  startTheme((theme) => view.setTheme(theme));
  shaping.start();
  const examples = JSON.parse(await compiler.ask({ do: "examples" }));
  startButtons(examples);
  const shared = await textOf(location.hash);
  open(file.name, shared ?? examples[0].text);
  if (location.hash.includes("text=") && shared === null) say("The text in the address is damaged.");
  // For whoever measures or tests it.
  Object.assign(globalThis, { playground: { editor, view, analyses, compiler } });
}

start();
