// The worker: it answers requests one after the other, so that the page never waits for the compiler.

import { started, unpacked } from "./module.js";

// Descriptions of mechanisms stay in the memory of a module. One that has grown so far is replaced.
const MOST_BYTES = 400e6;

let module = null;
let running = null;

// The page begins meanwhile. It gives the module to further workers.
async function unpack(packed) {
  module = await unpacked(packed);
  postMessage({ module });
  return started(module);
}

addEventListener("message", async ({ data }) => {
  const { packed, id, request } = data;
  if (packed !== undefined) {
    running = unpack(packed);
    return;
  }
  if (data.module !== undefined) {
    module = data.module;
    // The first request does not wait for it.
    running = started(module);
    return;
  }
  const { ask, bytes } = await running;
  const answer = ask(request);
  const panicked = answer.startsWith('{"panic"');
  if (panicked || bytes() > MOST_BYTES) running = started(module);
  postMessage({ id, answer });
});
