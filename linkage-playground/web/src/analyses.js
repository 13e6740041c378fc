// Analyses of the text: always the latest one, and never two at once.

// An analysis that takes longer may be stopped by hand, and is stopped by the next key.
const PATIENCE = 1000;

export class Analyses {
  #compiler;
  #text = null;
  #wanted = false;
  #running = false;
  #since = 0;

  // `text` gives the current text, `show` takes it with its analysis, `waiting` hears whether one takes long.
  constructor(compiler, { text, show, waiting }) {
    this.#compiler = compiler;
    Object.assign(this, { text, show, waiting });
  }

  // The text has changed.
  async want() {
    this.#wanted = true;
    if (this.#running) {
      if (performance.now() - this.#since > PATIENCE) this.#compiler.stop();
      return;
    }
    this.#running = true;
    while (this.#wanted) {
      this.#wanted = false;
      const text = this.text();
      this.#since = performance.now();
      const long = setTimeout(() => this.waiting(true), PATIENCE);
      const answer = await this.#compiler.ask({ do: "analyse", text });
      clearTimeout(long);
      this.waiting(false);
      if (answer !== null) this.show(text, analysisOf(answer));
    }
    this.#running = false;
  }
}

// Lines of the answer: messages and names, then the report and the programs of each mechanism.
function analysisOf(answer) {
  const [first, ...lines] = answer.split("\n");
  const { messages, names, panic, failure } = JSON.parse(first);
  if (messages === undefined) {
    const text = `the compiler has failed: ${panic ?? failure}\nhelp: the last change that was understood is still shown`;
    return { messages: [{ from: 0, to: 0, severity: "error", text, fixes: [] }], pages: [] };
  }
  const pages = names.map((name, k) => ({ name, report: lines[2 * k], programs: lines[2 * k + 1] }));
  return { messages, pages };
}
