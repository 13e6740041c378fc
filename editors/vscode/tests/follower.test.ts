import assert from "node:assert/strict";
import test from "node:test";

import { Follower } from "../src/page/follower.ts";

/** Work that ends when a test lets it, or when it is stopped. */
class Steps {
  readonly begun: string[] = [];
  readonly stopped: string[] = [];
  #end: () => void = () => {};

  readonly work = (state: string, stop: AbortSignal): Promise<void> =>
    new Promise((resolve) => {
      this.begun.push(state);
      this.#end = resolve;
      stop.addEventListener("abort", () => {
        this.stopped.push(state);
        resolve();
      });
    });

  async end(): Promise<void> {
    this.#end();
    await new Promise((resolve) => setImmediate(resolve));
  }
}

test("states that come during a run are replaced by the newest", async () => {
  const steps = new Steps();
  const follower = new Follower(steps.work, 60_000);
  for (const state of ["a", "b", "c", "d"]) follower.push(state);
  assert.deepEqual(steps.begun, ["a"]);
  await steps.end();
  assert.deepEqual(steps.begun, ["a", "d"]);
  await steps.end();
  follower.push("e");
  assert.deepEqual(steps.begun, ["a", "d", "e"]);
  assert.deepEqual(steps.stopped, []);
  follower.end();
});

test("a long run is stopped for a newer state, and for no other reason", async () => {
  const steps = new Steps();
  const follower = new Follower(steps.work, 20);
  follower.push("long");
  await new Promise((resolve) => setTimeout(resolve, 60));
  assert.deepEqual(steps.stopped, []);
  follower.push("new");
  await new Promise((resolve) => setTimeout(resolve, 60));
  assert.deepEqual(steps.stopped, ["long"]);
  assert.deepEqual(steps.begun, ["long", "new"]);
  follower.end();
});

test("the end stops the run and takes no state", async () => {
  const steps = new Steps();
  const follower = new Follower(steps.work, 60_000);
  follower.push("a");
  follower.push("b");
  follower.end();
  follower.push("c");
  await steps.end();
  assert.deepEqual(steps.stopped, ["a"]);
  assert.deepEqual(steps.begun, ["a"]);
});
