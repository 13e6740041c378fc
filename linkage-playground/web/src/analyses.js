// Analyses of the text: always the latest one, and never two at once.

// Milliseconds. Work for an earlier text may take so long after a key, otherwise it is dropped.
const HASTE = 100;
// After an analysis was dropped, the next one has more time: something is shown while keys follow each other.
const LONGEST = 1000;
// After this time a drawing of an earlier text is marked, and the work may be stopped by hand.
const PATIENCE = 500;

export class Analyses {
  #compiler;
  #isWanted = false;
  #isRunning = false;
  #hasDropped = false;
  // True if the last result has taken longer than a key may wait for its messages.
  #isLong = false;
  #late = null;

  // `text` gives the current text, `show` takes it with its analysis, `tell` takes it with the messages that need no solution. `late` hears that the
  // analysis takes long, `stopped` that it was stopped.
  constructor(compiler, { text, show, tell, late, stopped }) {
    this.#compiler = compiler;
    Object.assign(this, { text, show, tell, late, stopped });
  }

  // The text has changed.
  async want() {
    this.#isWanted = true;
    this.#late ??= setTimeout(() => this.late(), PATIENCE);
    this.#limit();
    if (this.#isRunning) return;
    this.#isRunning = true;
    while (this.#isWanted) await this.#analyse();
    this.#isRunning = false;
  }

  // Ends all work, by hand.
  stop() {
    this.#isWanted = false;
    this.#forgetLate();
    this.#compiler.stop();
    this.stopped();
  }

  // Limits the time of requests for an earlier text, up to the newest one: analyses, and values next to names.
  #limit(newest = this.#compiler.newest) {
    const { present, busyFor } = this.#compiler;
    if (present === null || present.id > newest) return;
    const isAnalysis = ["analyse", "messages"].includes(present.request.do);
    const left = (this.#hasDropped && isAnalysis ? LONGEST : HASTE) - busyFor;
    if (left > 0) {
      setTimeout(() => this.#limit(newest), left);
      return;
    }
    this.#hasDropped ||= isAnalysis;
    this.#isWanted = true;
    this.#compiler.stop();
  }

  async #analyse() {
    this.#isWanted = false;
    const text = this.text();
    if (this.#isLong || this.#hasDropped) await this.#tellFirst(text);
    if (this.#isWanted) return;
    const begin = performance.now();
    const answer = await this.#compiler.ask({ do: "analyse", text });
    if (answer === null) return;
    this.#isLong = performance.now() - begin > HASTE;
    this.#hasDropped = false;
    this.#forgetLate();
    if (this.#isWanted) this.#late = setTimeout(() => this.late(), PATIENCE);
    this.show(text, analysisOf(answer));
  }

  // Messages about words and names do not wait for a solution that takes long.
  async #tellFirst(text) {
    const answer = await this.#compiler.ask({ do: "messages", text });
    if (answer !== null && !this.#isWanted) this.tell(text, analysisOf(answer).messages);
  }

  #forgetLate() {
    clearTimeout(this.#late);
    this.#late = null;
  }
}

// Lines of the answer: messages and names, then the report and the programs of each mechanism.
function analysisOf(answer) {
  const [first, ...lines] = answer.split("\n");
  const { messages, names = [], panic, failure } = JSON.parse(first);
  if (messages === undefined) {
    const text = `the compiler has failed: ${panic ?? failure}\nhelp: the last change that was understood is still shown`;
    return { messages: [{ from: 0, to: 0, severity: "error", text, fixes: [] }], pages: [] };
  }
  const pages = names.map((name, k) => ({ name, report: lines[2 * k], programs: lines[2 * k + 1] }));
  return { messages, pages };
}
