// The compiler in its worker: requests as promises, and a way to stop it.

export class Compiler {
  #address;
  #module;
  #worker = null;
  #waiting = new Map();
  #next = 0;

  // `script` is the text of the worker, `module` the compiled module.
  constructor(script, module) {
    // A page that was opened from disk may start a worker from a text of its own only.
    this.#address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    this.#module = module;
    this.#start();
  }

  #start() {
    this.#worker = new Worker(this.#address);
    this.#worker.addEventListener("message", ({ data: { id, answer, took } }) => {
      const done = this.#waiting.get(id);
      this.#waiting.delete(id);
      done?.({ answer, took });
    });
    this.#worker.postMessage({ module: this.#module });
  }

  // The answer as text; null if the compiler was stopped before.
  ask(request) {
    const id = this.#next++;
    return new Promise((done) => {
      this.#waiting.set(id, done);
      this.#worker.postMessage({ id, request });
    }).then((answered) => answered?.answer ?? null);
  }

  get isBusy() {
    return this.#waiting.size > 0;
  }

  // Ends whatever is computed, and starts again.
  stop() {
    this.#worker.terminate();
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    this.#start();
    for (const done of waiting) done(null);
  }
}

// The base64 of a compressed module as a module.
export async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}
