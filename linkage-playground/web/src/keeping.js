// The text of the page: what it begins with, how another one takes its place, and where it stays.

import { byId, element } from "./dom.js";
import { NEW_FILE } from "./file_state.js";
import { textOf } from "./share.js";
import { Storage } from "./storage.js";

// Milliseconds after the last key.
const PAUSE = 300;

export class Keeping {
  #editor;
  #examples;
  #storage = new Storage();
  #timer = null;
  // Texts that are elsewhere as well: in the examples, and in the address.
  #known;

  constructor(editor, examples) {
    this.#editor = editor;
    this.#examples = examples;
    this.#known = new Set(examples.map(({ text }) => text));
    const now = () => this.#timer !== null && this.#keep();
    addEventListener("pagehide", now);
    document.addEventListener("visibilitychange", now);
    addEventListener("beforeunload", (event) => {
      now();
      if (!this.#storage.isKept && !this.#known.has(editor.text())) event.preventDefault();
    });
  }

  // The text of this page before it was loaded again, otherwise that of the address, the latest one that was written, or the first example. The answer
  // is a remark about it.
  async begin() {
    const shared = await textOf(location.hash);
    if (shared !== null) this.#known.add(shared);
    const before = this.#storage.resumed();
    if (before !== null) this.#resume(before);
    else if (shared !== null) this.#editor.begin(shared, NEW_FILE);
    else this.#beginWithLatest();
    this.#list();
    if (location.hash.includes("text=") && shared === null) return "The text in the address is damaged.";
    const isOther = before !== null && shared !== null && before.address !== location.hash && shared !== this.#editor.text();
    return isOther ? this.open(NEW_FILE, shared) : "";
  }

  #beginWithLatest() {
    const [latest] = this.#storage.earlier();
    const [{ name, text }] = this.#examples;
    if (latest === undefined) this.#editor.begin(text, { ...NEW_FILE, name: `${name}.mech` });
    else this.#editor.begin(latest.text, { ...NEW_FILE, name: latest.name });
  }

  // Steps that another version of the page has written may be of another form.
  #resume({ text, name, editor }) {
    try {
      this.#editor.resume(editor);
    } catch {
      this.#editor.begin(text, { ...NEW_FILE, name });
    }
  }

  // Opens another text; one step of undo leads back. The answer is a remark about it.
  open(file, text) {
    if (this.#timer !== null) this.#keep();
    this.#storage.another();
    this.#editor.open(text, file);
    return `${file.name} is open. Undo leads back to the text before.`;
  }

  // The text of an address that the reader has come to.
  async openAddress() {
    const shared = await textOf(location.hash);
    if (shared === null || shared === this.#editor.text()) return null;
    this.#known.add(shared);
    return this.open(NEW_FILE, shared);
  }

  // A text of the list of examples and earlier texts.
  choose(value) {
    const example = this.#examples.find(({ name }) => `example ${name}` === value);
    if (example !== undefined) return this.open({ ...NEW_FILE, name: `${example.name}.mech` }, example.text);
    const earlier = this.#storage.earlier().find(({ id }) => `earlier ${id}` === value);
    return earlier === undefined ? null : this.open({ ...NEW_FILE, name: earlier.name }, earlier.text);
  }

  // The text has changed.
  changed() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#keep(), PAUSE);
  }

  #keep() {
    clearTimeout(this.#timer);
    this.#timer = null;
    const text = this.#editor.text();
    const { name } = this.#editor.file();
    this.#storage.keep({ text, name, address: location.hash, editor: this.#editor.state(), isKnown: this.#known.has(text) || text.trim() === "" });
    byId("unkept").hidden = this.#storage.isKept;
    this.#list();
  }

  #list() {
    const group = (label, options) => element("optgroup", { label }, ...options);
    const option = ({ name, about }) => element("option", { value: `example ${name}` }, `${name}: ${about}`);
    const labels = [...new Set(this.#examples.map((example) => example.group))];
    const examples = labels.map((label) => group(label, this.#examples.filter((example) => example.group === label).map(option)));
    const now = this.#editor.text();
    const earlier = this.#storage.earlier().filter(({ text }) => text !== now);
    const texts = earlier.map((kept) => element("option", { value: `earlier ${kept.id}` }, earlierText(kept)));
    byId("examples").replaceChildren(element("option", { value: "" }, "Examples"), ...examples, ...(texts.length > 0 ? [group("Earlier texts", texts)] : []));
  }
}

function earlierText({ name, text, time }) {
  const [, mechanism = ""] = /\bstruct\s+([\p{L}_][\p{L}\d_]*)/u.exec(text) ?? [];
  const when = new Date(time).toLocaleString([], { dateStyle: "short", timeStyle: "short" });
  return [mechanism, name, when].filter((part) => part !== "").join(", ");
}
