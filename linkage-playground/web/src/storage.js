// Texts that stay in the browser: that of this page for a reload, with its steps of undo, and earlier ones.

const SESSION = "linkage-playground";
const TEXTS = "linkage-playground/";
// Further texts replace the oldest ones.
const MOST_TEXTS = 16;

// A store of the browser. Browsers may refuse it when it is asked for.
function stored(name) {
  try {
    return globalThis[name];
  } catch {
    return null;
  }
}

function parsed(json) {
  try {
    return JSON.parse(json);
  } catch {
    return null;
  }
}

export class Storage {
  // Texts of all pages, and the text of this page.
  #texts = stored("localStorage");
  #session = stored("sessionStorage");
  #id = crypto.randomUUID();
  // False after the browser has refused to keep a text.
  isKept = true;

  // The state that this page had before it was loaded again; null if it is opened for the first time.
  resumed() {
    const before = parsed(this.#session?.getItem(SESSION) ?? null);
    if (before === null) return null;
    // A copy of a window has the same session, and is another document.
    const [{ type } = {}] = performance.getEntriesByType("navigation");
    if (type === "reload") this.#id = before.id;
    return before;
  }

  // Texts that follow belong to another document. The one before stays among the earlier texts.
  another() {
    this.#id = crypto.randomUUID();
  }

  // Keeps a text with the name of its file. A text that is known elsewhere is kept for a reload only.
  keep({ text, name, address, editor, isKnown }) {
    const before = this.earlier();
    const same = before.filter((other) => other.text === text || other.id === this.#id);
    try {
      for (const { id } of same) this.#texts.removeItem(TEXTS + id);
      if (!isKnown) this.#texts.setItem(TEXTS + this.#id, JSON.stringify({ text, name, time: Date.now() }));
      for (const { id } of this.earlier().slice(MOST_TEXTS)) this.#texts.removeItem(TEXTS + id);
      this.#session.setItem(SESSION, JSON.stringify({ id: this.#id, address, text, name }));
      this.isKept = true;
    } catch {
      this.isKept = false;
      return;
    }
    this.#keepSteps({ id: this.#id, address, text, name, editor });
  }

  // Steps of undo may be larger than the browser allows. The text is kept without them then.
  #keepSteps(state) {
    try {
      this.#session.setItem(SESSION, JSON.stringify(state));
    } catch (error) {
      if (error.name !== "QuotaExceededError") throw error;
    }
  }

  // All texts that are kept, the latest first.
  earlier() {
    if (this.#texts === null) return [];
    const keys = Object.keys(this.#texts).filter((key) => key.startsWith(TEXTS));
    const all = keys.map((key) => ({ ...parsed(this.#texts.getItem(key)), id: key.slice(TEXTS.length) }));
    return all.filter(({ text }) => typeof text === "string").sort((a, b) => b.time - a.time);
  }
}
