// The living page in its frame: it shows one report after the other, and reports what is dragged in it.

// `changed` hears that dimensions were changed in the page, `kept` that a change is complete, `page` makes the page as a file of its own.
export class View {
  #frame;
  #host;
  #handle = null;
  #before = null;

  constructor(frame, host) {
    this.#frame = frame;
    this.#host = host;
  }

  // The frame has the page's style and script, as a document of its own.
  static ready(frame, { style, body, script }) {
    return new Promise((done) => {
      frame.addEventListener("load", done, { once: true });
      frame.srcdoc = `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><style>${style}</style></head><body>${body}<script>${script}</script></body></html>`;
    });
  }

  get document() {
    return this.#frame.contentDocument;
  }

  get handle() {
    return this.#handle;
  }

  // Shows a report. `frozen` holds the picture's size and position, while a joint is dragged.
  show({ report, programs }, frozen = false) {
    const all = [JSON.parse(programs)];
    if (!this.#handle?.renew(report, all, frozen)) this.#start(report, all, frozen);
    this.document.body.classList.remove("stale", "empty");
    return this.#handle;
  }

  // Makes the elements of a report.
  #start(report, programs, frozen) {
    const { contentWindow: page, contentDocument: document } = this.#frame;
    const hasFocus = this.#frame.ownerDocument.activeElement === this.#frame;
    const point = hasFocus ? document.activeElement?.dataset.point : undefined;
    if (this.#handle !== null) {
      this.#before = this.#handle.state();
      this.#handle.end();
    }
    this.#handle = null;
    document.getElementById("report").textContent = report;
    const before = this.#before && { ...this.#before, ...(frozen ? { playing: false } : { box: null }) };
    this.#handle = page.startPage({ programs, before, ...this.#host });
    // A reader who moves a joint by keys goes on with the same joint.
    if (point !== undefined) document.querySelector(`[data-point="${CSS.escape(point)}"]`)?.focus({ preventScroll: true });
  }

  // What is shown is older than the text.
  outdated() {
    const { classList } = this.document.body;
    classList.add("stale");
    classList.toggle("empty", this.#handle === null);
  }

  // The next report has nothing to do with this one.
  forget() {
    this.#handle?.end();
    this.#handle = null;
    this.#before = null;
  }

  setTheme(theme) {
    if (theme === null) delete this.document.documentElement.dataset.theme;
    else this.document.documentElement.dataset.theme = theme;
  }
}
