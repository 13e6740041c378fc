// Changes of the text by hand in the drawing: while something is dragged the text follows, and the whole drag is one step of undo.

import { difference } from "./difference.js";

export class TextDrag {
  #editor;
  #base = null;
  // The state of the editor before the drag: its steps of undo know nothing of what the drag has shown.
  #before = null;
  #edits = [];
  #shown = null;

  constructor(editor) {
    this.#editor = editor;
  }

  get isRunning() {
    return this.#base !== null;
  }

  // Shows the text with some stretches replaced, from the text `base`, which must be that of the editor at the start.
  follow(base, edits) {
    const { text, preview } = this.#editor;
    if (this.#base === null && text() !== base) return false;
    if (this.#base !== null && text() !== this.#shown) return false;
    if (this.#base === null) this.#before = this.#editor.view.state;
    this.#base ??= base;
    this.#edits = edits;
    const next = applied(this.#base, edits);
    const change = difference(text(), next);
    if (change !== null) preview(change);
    this.#shown = text();
    return true;
  }

  // Ends the drag.
  end() {
    if (this.#base === null) return;
    const { view, text, commit } = this.#editor;
    const isOwn = text() === this.#shown;
    const changes = this.#edits.filter(({ from, to, insert }) => this.#base.slice(from, to) !== insert);
    if (isOwn) {
      view.setState(this.#before);
      if (changes.length > 0) commit(changes);
    }
    this.#base = null;
    this.#before = null;
    this.#edits = [];
    this.#shown = null;
  }
}

export function applied(base, edits) {
  let text = base;
  for (const { from, to, insert } of edits.toSorted((a, b) => b.from - a.from)) text = text.slice(0, from) + insert + text.slice(to);
  return text;
}
