// Work that follows changes: one run after the other, and always the newest state.

/** Work on a state, which stops early if it is asked to. */
export type Work<State> = (state: State, stop: AbortSignal) => Promise<void>;

/** A run that has not ended. */
interface Running {
  readonly stop: AbortController;
  readonly since: number;
  timer?: ReturnType<typeof setTimeout>;
}

/**
 * Works on the newest state. States that come during a run replace each other and wait for its end. A run that is
 * older than `patience` milliseconds is stopped for a newer state.
 */
export class Follower<State> {
  readonly #work: Work<State>;
  readonly #patience: number;
  #waiting: { state: State } | undefined;
  #running: Running | undefined;
  #ended = false;

  constructor(work: Work<State>, patience: number) {
    this.#work = work;
    this.#patience = patience;
  }

  /** Takes a state. */
  push(state: State): void {
    if (this.#ended) return;
    this.#waiting = { state };
    if (this.#running === undefined) void this.#run();
    else this.#stopLate(this.#running);
  }

  /** Stops the run, and takes no further states. */
  end(): void {
    this.#ended = true;
    this.#waiting = undefined;
    clearTimeout(this.#running?.timer);
    this.#running?.stop.abort();
  }

  #stopLate(running: Running): void {
    const left = running.since + this.#patience - performance.now();
    running.timer ??= setTimeout(() => running.stop.abort(), Math.max(0, left));
  }

  async #run(): Promise<void> {
    while (this.#waiting !== undefined) {
      const { state } = this.#waiting;
      this.#waiting = undefined;
      this.#running = { stop: new AbortController(), since: performance.now() };
      await this.#work(state, this.#running.stop.signal);
      clearTimeout(this.#running.timer);
    }
    this.#running = undefined;
  }
}
