// The compiler in its worker: requests as promises, and a way to stop it.

// Milliseconds before another worker begins: answers that are waited for come first.
const PAUSE = 1000;

export class Compiler {
  #address;
  // The compressed module, and the compiled one as soon as a worker has it.
  #packed;
  #module = null;
  #worker;
  // Another worker that has begun already: it takes the place of one that is stopped.
  #spare = null;
  #timer = null;
  // Requests in their order, each with what is done with its answer.
  #waiting = new Map();
  #next = 0;
  // The time at which the worker has begun the request that it answers next.
  #since = 0;

  // `script` is the text of the worker, `packed` the compressed module in base64.
  constructor(script, packed) {
    // A page that was opened from disk may start a worker from a text of its own only.
    this.#address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    this.#packed = packed;
    this.#worker = this.#begun();
    this.#spareLater();
  }

  #spareLater() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      if (this.#module === null) this.#spareLater();
      else this.#spare ??= this.#begun();
    }, PAUSE);
  }

  #begun() {
    const worker = new Worker(this.#address);
    worker.addEventListener("message", ({ data: { module, id, answer } }) => {
      if (module !== undefined) {
        this.#module = module;
        return;
      }
      const waiting = this.#waiting.get(id);
      this.#waiting.delete(id);
      this.#since = performance.now();
      waiting?.done(answer);
    });
    worker.postMessage(this.#module === null ? { packed: this.#packed } : { module: this.#module });
    return worker;
  }

  // The answer as text; null if the compiler was stopped before.
  ask(request) {
    const id = this.#next++;
    if (!this.isBusy) this.#since = performance.now();
    return new Promise((done) => {
      this.#waiting.set(id, { request, done });
      this.#worker.postMessage({ id, request });
    });
  }

  get isBusy() {
    return this.#waiting.size > 0;
  }

  // The request that is computed, and its number; null if there is none.
  get present() {
    const [first] = this.#waiting;
    return first === undefined ? null : { id: first[0], request: first[1].request };
  }

  // The number of the latest request.
  get newest() {
    return this.#next - 1;
  }

  // Milliseconds for which the present request has been computed.
  get busyFor() {
    return this.isBusy ? performance.now() - this.#since : 0;
  }

  // Ends whatever is computed.
  stop() {
    this.#worker.terminate();
    this.#worker = this.#spare ?? this.#begun();
    this.#spare = null;
    this.#spareLater();
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { done } of waiting) done(null);
  }
}
