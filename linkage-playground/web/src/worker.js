// The worker: it answers requests one after the other, so that the page never waits for the compiler.

import { started } from "./module.js";

// Descriptions of mechanisms stay in the memory of a module. One that has grown so far is replaced.
const MOST_BYTES = 400e6;

let module = null;
let running = null;

addEventListener("message", async ({ data }) => {
  if (data.module) {
    module = data.module;
    // The first request does not wait for it.
    running = started(module);
    return;
  }
  const { id, request } = data;
  const { ask, bytes } = await running;
  const answer = ask(request);
  const panicked = answer.startsWith('{"panic"');
  if (panicked || bytes() > MOST_BYTES) running = started(module);
  postMessage({ id, answer });
});
