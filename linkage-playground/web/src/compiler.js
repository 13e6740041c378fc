// The compiler in its worker: requests as promises, and a way to stop it.

export class Compiler {
  #address;
  #module;
  #worker;
  // Another worker that has begun already: it takes the place of one that is stopped.
  #spare = null;
  // Requests in their order, each with what is done with its answer.
  #waiting = new Map();
  #next = 0;
  // The time at which the worker has begun the request that it answers next.
  #since = 0;

  // `script` is the text of the worker, `module` the compiled module.
  constructor(script, module) {
    // A page that was opened from disk may start a worker from a text of its own only.
    this.#address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    this.#module = module;
    this.#worker = this.#begun();
  }

  #begun() {
    const worker = new Worker(this.#address);
    worker.addEventListener("message", ({ data: { id, answer } }) => {
      const waiting = this.#waiting.get(id);
      this.#waiting.delete(id);
      this.#since = performance.now();
      // Not before: its start would delay this answer.
      this.#spare ??= this.#begun();
      waiting?.done(answer);
    });
    worker.postMessage({ module: this.#module });
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

  // The request that is computed; null if there is none.
  get present() {
    const [first] = this.#waiting.values();
    return first?.request ?? null;
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
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { done } of waiting) done(null);
  }
}

// The base64 of a compressed module as a module.
export async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
