// Answers of the module outside of a browser: `node answers.mjs MODULE.wasm` reads requests, a line each, and writes their answers.

import { readFile } from "node:fs/promises";
import { createInterface } from "node:readline";
import { started } from "./src/module.js";

const module = await WebAssembly.compile(await readFile(process.argv[2]));
const { ask } = await started(module);
for await (const line of createInterface({ input: process.stdin })) {
  const begin = performance.now();
  const answer = ask(JSON.parse(line));
  console.log(JSON.stringify({ answer, milliseconds: performance.now() - begin }));
}
