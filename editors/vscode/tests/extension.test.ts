// The bundle, with a stand-in for the editor: it loads, and registers its commands.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");

interface Extension {
  activate(context: { subscriptions: unknown[]; extensionUri: object }): Promise<void>;
  deactivate(): Promise<void>;
}

/** Returns a class, a function and an object with everything, as modules that extend the editor need it. */
function anything(): object {
  class Anything {}
  return new Proxy(Anything, { get: (target, key) => (key in target ? Reflect.get(target, key) : typeof key === "string" ? anything() : undefined) });
}

/** Loads the bundle with an editor. */
async function loaded(editor: object): Promise<Extension> {
  const source = await readFile(join(ROOT, "dist/extension.js"), "utf8");
  const load = createRequire(import.meta.url);
  const module = { exports: {} as Extension };
  const require = (name: string) => (name === "vscode" ? editor : load(name));
  new Function("module", "exports", "require", source)(module, module.exports, require);
  return module.exports;
}

test("the extension registers the commands of its manifest, and starts nothing in a folder that is not trusted", async () => {
  const registered: string[] = [];
  const shown: string[] = [];
  const known: Record<string, object> = {
    commands: { registerCommand: (name: string) => registered.push(name) },
    window: { createOutputChannel: () => ({ error: (text: string) => shown.push(text), dispose: () => {} }), showErrorMessage: (text: string) => shown.push(text) },
    workspace: { isTrusted: false, getConfiguration: () => ({ get: (_: string, value: string) => value }), onDidChangeConfiguration: () => ({}), onDidGrantWorkspaceTrust: () => ({}) },
  };
  const editor = new Proxy(known, { get: (target, key: string) => target[key] ?? anything() });
  const { activate, deactivate } = await loaded(editor);
  await activate({ subscriptions: [], extensionUri: {} });
  const { contributes } = JSON.parse(await readFile(join(ROOT, "package.json"), "utf8"));
  assert.deepEqual(registered.sort(), contributes.commands.map(({ command }: { command: string }) => command).sort());
  assert.deepEqual(shown, []);
  await deactivate();
});
