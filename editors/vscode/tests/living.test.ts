import assert from "node:assert/strict";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

import { LivingPage } from "../src/page/living.ts";

/** A command that writes its arguments and the text as a page, and fails for a text with `wrong`. */
const COMMAND = `#!/usr/bin/env node
const { mkdirSync, readFileSync, writeFileSync } = require("node:fs");
const args = process.argv.slice(2);
const text = readFileSync(args[1], "utf8");
if (text.includes("wrong")) { console.error("error: wrong\\n --> " + args[1] + ":1:1"); process.exit(1); }
mkdirSync(args[3], { recursive: true });
writeFileSync(args[3] + "/index.html", args.join(" ") + "\\n" + text);
`;

test("a text that is not saved gets its page, or its mistakes", async () => {
  const folder = await mkdtemp(join(tmpdir(), "linkage-test-"));
  const command = join(folder, "command");
  await writeFile(command, COMMAND, { mode: 0o755 });
  const living = new LivingPage();
  const { signal } = new AbortController();
  const write = (text: string, mechanism?: string) => living.write({ file: "/elsewhere/a.mech", text, mechanism, command }, signal);
  assert.deepEqual(await write("first"), { page: "page a.mech -o page\nfirst" });
  assert.deepEqual(await write("wrong"), { mistakes: "error: wrong\n --> a.mech:1:1" });
  assert.deepEqual(await write("second", "Former"), { page: "page a.mech -o page --mechanism Former\nsecond" });
  assert.equal(await living.write({ file: "a.mech", text: "", mechanism: undefined, command }, AbortSignal.abort()), undefined);
  await living.remove();
  await rm(folder, { recursive: true });
});

test("the command writes pages of templates", { skip: process.env["LINKAGE_COMMAND"] === undefined }, async () => {
  const command = process.env["LINKAGE_COMMAND"] ?? "";
  const living = new LivingPage();
  const { signal } = new AbortController();
  const text = "struct A { unit mm; param r = 5mm; input phi = 0deg in 0deg..360deg; let p = polar(r, phi); }\nimpl A { fn f(phi) -> F { p } }";
  const good = await living.write({ file: "a.mech", text, mechanism: undefined, command }, signal);
  assert.ok(good !== undefined && "page" in good && good.page.includes("<title>A</title>"));
  const bad = await living.write({ file: "a.mech", text: text.replace("5mm", "5foo"), mechanism: undefined, command }, signal);
  assert.ok(bad !== undefined && "mistakes" in bad && bad.mistakes.includes("a.mech:1:"));
  await living.remove();
});
