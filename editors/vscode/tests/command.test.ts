import assert from "node:assert/strict";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

import { CommandError, commandOf, faultMessage, run, serverFault } from "../src/command.ts";

const NODE = process.execPath;

test("the setting is a name or a file", () => {
  for (const [setting, command] of [
    ["", "linkage"],
    [" linkage ", "linkage"],
    ["~/bin/linkage", join("/home/me", "bin/linkage")],
    ["./target/linkage", join("/project", "target/linkage")],
    ["/opt/linkage", "/opt/linkage"],
  ] as const) {
    assert.equal(commandOf(setting, "/home/me", "/project"), command);
  }
  assert.equal(commandOf("a/linkage", "/home/me", undefined), "a/linkage");
});

test("a run returns status and outputs", async () => {
  const ended = await run(NODE, ["-e", "console.log('out'); console.error('err'); process.exit(3)"], tmpdir());
  assert.deepEqual(ended, { status: 3, output: "out\n", errors: "err\n" });
});

test("a run is stopped", async () => {
  const stop = new AbortController();
  const running = run(NODE, ["-e", "setTimeout(() => {}, 60000)"], tmpdir(), stop.signal);
  setTimeout(() => stop.abort(), 50);
  assert.equal((await running).status, null);
});

test("a command that is absent, or no program, has its message", async () => {
  await assert.rejects(run("linkage-that-is-absent", [], tmpdir()), (error) => error instanceof CommandError && error.fault.kind === "absent");
  assert.deepEqual(await serverFault("linkage-that-is-absent", tmpdir()), { kind: "absent", command: "linkage-that-is-absent" });
  const folder = await mkdtemp(join(tmpdir(), "linkage-test-"));
  const file = join(folder, "text");
  await writeFile(file, "no program", { mode: 0o644 });
  assert.equal((await serverFault(file, folder))?.kind, "not executable");
  await rm(folder, { recursive: true });
});

test("a command without a server is found", async () => {
  const folder = await mkdtemp(join(tmpdir(), "linkage-test-"));
  const [old, present] = [join(folder, "old"), join(folder, "present")];
  await writeFile(old, "#!/bin/sh\nexit 2\n", { mode: 0o755 });
  await writeFile(present, '#!/bin/sh\ntest "$1 $2" = "lsp --help"\n', { mode: 0o755 });
  assert.equal((await serverFault(old, folder))?.kind, "without server");
  assert.equal(await serverFault(present, folder), undefined);
  await rm(folder, { recursive: true });
});

test("messages name the command and the setting", () => {
  for (const kind of ["absent", "not executable", "without server"] as const) {
    const message = faultMessage({ kind, command: "/opt/linkage" });
    assert.match(message, /`\/opt\/linkage`/);
    assert.match(message, /`linkage\.path`/);
  }
});
