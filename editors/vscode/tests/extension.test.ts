// The bundle, with a stand-in for the editor: it loads, and registers its commands.

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
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

/** The editor as far as the extension uses it: what it registers, shows and posts. */
class Editor {
  readonly commands = new Map<string, () => Promise<void>>();
  readonly errors: string[] = [];
  readonly posted: object[] = [];
  html = "";
  text = "";
  isTrusted = false;
  path = "linkage";
  readonly #listeners: Record<string, ((event: object) => void)[]> = {};
  readonly document = { uri: { path: "/project/a.mech", toString: () => "file:///project/a.mech" }, languageId: "linkage", getText: () => this.text, offsetAt: () => 0, isUntitled: false };

  /** Sends an event to the extension. */
  fire(event: string, data: object = {}): void {
    for (const listener of this.#listeners[event] ?? []) listener(data);
  }

  /** Returns the module `vscode`. */
  module(): object {
    const on = (event: string) => (listener: (event: object) => void) => {
      (this.#listeners[event] ??= []).push(listener);
      return { dispose: () => {} };
    };
    const editor = this;
    const webview = {
      set html(html: string) { editor.html = html; },
      postMessage: async (message: object) => this.posted.push(message),
      onDidReceiveMessage: on("message"),
    };
    const events = ["onDidChangeConfiguration", "onDidGrantWorkspaceTrust", "onDidChangeTextDocument", "onDidChangeTextEditorSelection"];
    const known: Record<string, object> = {
      commands: { registerCommand: (name: string, run: () => Promise<void>) => this.commands.set(name, run) },
      Uri: { joinPath: (_: object, ...parts: string[]) => ({ fsPath: join(ROOT, ...parts) }) },
      ViewColumn: { Beside: -2 },
      window: {
        activeTextEditor: { document: this.document, selection: { active: {} } },
        createOutputChannel: () => ({ error: (text: string) => this.errors.push(text), warn: () => {}, dispose: () => {} }),
        createWebviewPanel: () => ({ webview, onDidDispose: on("dispose"), reveal: () => this.posted.push({ revealed: true }), dispose: () => this.fire("dispose") }),
        showErrorMessage: async (text: string) => { this.errors.push(text); },
        showWarningMessage: async (text: string) => { this.errors.push(text); },
        onDidChangeTextEditorSelection: on("onDidChangeTextEditorSelection"),
      },
      workspace: {
        ...Object.fromEntries(events.map((event) => [event, on(event)])),
        asRelativePath: () => "a.mech",
        getConfiguration: () => ({ get: () => this.path }),
      },
    };
    Object.defineProperty(known["workspace"], "isTrusted", { get: () => this.isTrusted });
    return new Proxy(known, { get: (target, key: string) => target[key] ?? anything() });
  }
}

const CONTEXT = { subscriptions: [], extensionUri: {} };

test("the extension registers the commands of its manifest, and starts nothing in a folder that is not trusted", async () => {
  const editor = new Editor();
  const { activate, deactivate } = await loaded(editor.module());
  await activate(CONTEXT);
  const { contributes } = JSON.parse(await readFile(join(ROOT, "package.json"), "utf8"));
  assert.deepEqual([...editor.commands.keys()].sort(), contributes.commands.map(({ command }: { command: string }) => command).sort());
  assert.deepEqual(editor.errors, []);
  await editor.commands.get("linkage.openPage")?.();
  assert.match(editor.errors.join(), /trusted folder/);
  assert.equal(editor.html, "");
  await deactivate();
});

/** A command without a server, whose page is the text; a text with `wrong` has a mistake. */
const COMMAND = `#!/bin/sh
test "$1" = page || exit 2
if grep -q wrong "$2"; then echo "error: wrong" >&2; exit 1; fi
mkdir -p "$4"
{ printf '<script>'; cat "$2"; printf '</script>'; } > "$4/index.html"
`;

async function until(holds: () => boolean): Promise<void> {
  for (let tries = 0; !holds() && tries < 500; tries++) await new Promise((resolve) => setTimeout(resolve, 10));
}

test("the page follows the text", async () => {
  const folder = await mkdtemp(join(tmpdir(), "linkage-test-"));
  const editor = new Editor();
  Object.assign(editor, { isTrusted: true, path: join(folder, "linkage"), text: "first" });
  await writeFile(editor.path, COMMAND, { mode: 0o755 });
  const { activate, deactivate } = await loaded(editor.module());
  await activate(CONTEXT);
  assert.match(editor.errors.join(), /has no language server/);

  await editor.commands.get("linkage.openPage")?.();
  const nonce = editor.html.match(/script-src 'nonce-([\w-]+)'/)?.[1];
  const page = (text: string) => ({ page: `<script nonce="${nonce}">${text}</script>` });
  // Messages wait for the script of the panel.
  await new Promise((resolve) => setTimeout(resolve, 300));
  assert.deepEqual(editor.posted, []);
  editor.fire("message");
  await until(() => editor.posted.length === 1);
  editor.text = "wrong";
  editor.fire("onDidChangeTextDocument", { document: editor.document });
  editor.fire("onDidChangeTextDocument", { document: {} });
  await until(() => editor.posted.length === 2);
  editor.text = "second";
  editor.fire("onDidChangeTextDocument", { document: editor.document });
  await until(() => editor.posted.length === 3);
  // The page of a text is opened once.
  await editor.commands.get("linkage.openPage")?.();
  assert.deepEqual(editor.posted, [page("first"), { mistakes: "error: wrong" }, page("second"), { revealed: true }]);

  editor.fire("dispose");
  editor.text = "third";
  editor.fire("onDidChangeTextDocument", { document: editor.document });
  await new Promise((resolve) => setTimeout(resolve, 200));
  assert.equal(editor.posted.length, 4);
  await deactivate();
  await rm(folder, { recursive: true });
});
