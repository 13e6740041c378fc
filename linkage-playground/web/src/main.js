// The playground: text, messages and mechanism, and the buttons above them.

import { Analyses } from "./analyses.js";
import { Assist } from "./assist.js";
import { showSteps, startButtons } from "./buttons.js";
import { format, offerChanges } from "./changes.js";
import { Compiler } from "./compiler.js";
import { byId, element } from "./dom.js";
import { TextDrag } from "./drag.js";
import { makeEditor } from "./editor.js";
import { read, saveFile, written } from "./files.js";
import { showHints } from "./hints.js";
import { Keeping } from "./keeping.js";
import { showTab, startBorder, startTabs, startTheme } from "./layout.js";
import { showMessages } from "./messages.js";
import { Shaping } from "./shaping.js";
import { fragmentOf } from "./share.js";
import { say, sayCurrent, sayDone, sayLate, sayMessages, sayMistake, sayStopped } from "./status.js";
import { View } from "./view.js";

const parts = { frame: FRAME, worker: WORKER };

// The pages of the last text without a mistake, and the name of the one that is shown.
const shown = { pages: [], name: null };

async function start() {
  const compiler = new Compiler(parts.worker, byId("module").textContent.trim());
  const framed = View.ready(byId("frame"), parts.frame);
  const [examples, words] = (await Promise.all([compiler.ask({ do: "examples" }), compiler.ask({ do: "words" })])).map(JSON.parse);
  await framed;
  const root = byId("editor").attachShadow({ mode: "open" });
  const text = () => editor.text();
  const assist = new Assist(compiler, text);
  const editor = makeEditor(root, { changed, assist, words });
  const drag = new TextDrag(editor);
  const analyses = new Analyses(compiler, { text, show, tell, late, stopped });
  // Changes of the text that are shown already are not analysed.
  let quiet = false;

  function changed() {
    if (quiet) return;
    say("");
    noteChange();
    analyses.want();
  }

  // The text is kept, and buttons show what can be undone.
  function noteChange() {
    keeping.changed();
    showSteps(editor.steps());
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
    noteChange();
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
    refused: say,
  });

  function go(place) {
    showTab("text");
    editor.go(place);
  }

  function tell(source, messages) {
    editor.tell(messages);
    showMessages(messages, source, go);
    sayMessages(messages);
  }

  function show(source, { messages, pages }) {
    tell(source, messages);
    sayDone();
    assist.hintsLater((found) => showHints(editor.view, found));
    if (pages.length === 0) outdated(messages, source);
    else showSafely(pages);
    document.body.dataset.shown = String(Number(document.body.dataset.shown ?? 0) + 1);
  }

  // What is shown is older than the text, for one of three reasons.
  function outdated(messages, source) {
    view.outdated();
    sayMistake(messages, source, view.handle !== null, go);
  }

  function late() {
    view.outdated();
    sayLate(view.handle !== null, () => analyses.stop());
  }

  function stopped() {
    view.outdated();
    sayStopped(view.handle !== null, () => analyses.want());
  }

  // A page that fails leaves the text alive.
  function showSafely(pages) {
    try {
      showPages(pages);
      sayCurrent();
    } catch (error) {
      view.outdated();
      say(`The mechanism cannot be shown: ${error.message}`);
    }
  }

  function showPages(pages) {
    shown.pages = pages;
    const names = pages.map(({ name }) => name);
    if (!names.includes(shown.name)) shown.name = names.at(-1);
    listMechanisms(names);
    showPage();
  }

  function listMechanisms(names) {
    const list = byId("mechanisms");
    byId("which").hidden = names.length < 2;
    if (names.join() !== [...list.options].map(({ value }) => value).join()) list.replaceChildren(...names.map((name) => element("option", { value: name }, name)));
    list.value = shown.name;
  }

  function showPage() {
    view.show(shown.pages.find(({ name }) => name === shown.name), shaping.isHeld || shaping.isOn);
    shaping.mark();
  }

  // After the editor has another text. `said` is a remark, null if it has not.
  function opened(said) {
    if (said === null) return;
    view.forget();
    showTab("text");
    say(said);
  }

  async function exported(format) {
    const answer = await compiler.ask({ do: "export", text: text(), format, mechanism: shown.name });
    const files = answer === null ? { failure: "The export was stopped, by hand or by a change of the text." } : JSON.parse(answer);
    if (Array.isArray(files)) return files;
    throw new Error(files.failure ?? files.panic);
  }

  async function exportAs(format) {
    say("The files are being made.");
    try {
      const files = await exported(format);
      for (const { name, text } of files) saveFile(name, text);
      say(`Saved: ${files.map(({ name }) => name).join(", ")}.`);
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

  function openFile({ name, text, form, isMixed }) {
    if (text === null) return say(`${name} is not a text in UTF-8, and is not opened.`);
    const mixed = isMixed ? ` It has several ends of lines: Save writes ${form.end === "\n" ? "LF" : "CR LF"}.` : "";
    opened(keeping.open({ name, form }, text) + mixed);
  }

  function save() {
    const { name, form } = editor.file();
    saveFile(name, written(text(), form));
  }

  function shape() {
    const refusal = shaping.isOn ? null : shaping.refusal();
    if (refusal !== null) return say(refusal);
    shaping.turn(!shaping.isOn);
    byId("shape").setAttribute("aria-pressed", String(shaping.isOn));
    say(shaping.isOn ? "Drag the marked joints, or move them by arrow keys: their coordinates in the text change." : "");
    if (shaping.isOn) showTab("view");
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

  startTabs();
  startBorder();
  startTheme((theme) => view.setTheme(theme));
  shaping.start();
  startButtons({
    choose: (value) => opened(keeping.choose(value)),
    export: exportAs,
    select: (name) => {
      shown.name = name;
      showPage();
    },
    open: openFile,
    undo: editor.undo,
    redo: editor.redo,
    save,
    share,
    shape,
    format: () => format(compiler, editor, say),
    offer: () => offerChanges(compiler, editor, say),
    stop: () => analyses.stop(),
  });
  const keeping = new Keeping(editor, examples);
  addEventListener("hashchange", async () => opened(await keeping.openAddress()));
  say(await keeping.begin());
  showSteps(editor.steps());
  analyses.want();
  // For whoever measures or tests it.
  Object.assign(globalThis, { playground: { editor, view, analyses, compiler, openBytes: (name, bytes) => openFile({ name, ...read(bytes) }) } });
}

start();
