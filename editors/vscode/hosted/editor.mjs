// VS Code as a server with the packaged extension, and its window in Chromium.

import { execFile, spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { delimiter, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

import { chromium } from "playwright-core";

const HERE = dirname(fileURLToPath(import.meta.url));
const SERVER = join(HERE, "node_modules/code-server/lib/vscode/out/server-main.js");
const EXTENSION = join(HERE, "../linkage.vsix");

/** Names of the browser. */
const BROWSERS = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/** Returns the file of the browser: `CHROMIUM`, or the first in PATH; `undefined` if there is none. */
export function browser() {
  const folders = (process.env.PATH ?? "").split(delimiter);
  const files = BROWSERS.flatMap((name) => folders.map((folder) => join(folder, name)));
  return process.env.CHROMIUM ?? files.find((file) => existsSync(file));
}

/** Milliseconds until the server listens, and until something is in the window. */
const PATIENCE = 60_000;

/** An editor with a folder of texts. */
export class Editor {
  #folder;
  #server;
  #browser;
  /** The window. */
  page;

  /** Installs the extension, and opens a folder with texts. `command` is the file of the command `linkage`. */
  static async open(texts, command) {
    const editor = new Editor();
    editor.#folder = await mkdtemp(join(tmpdir(), "linkage-hosted-"));
    const at = (...parts) => join(editor.#folder, ...parts);
    await mkdir(at("data/data/Machine"), { recursive: true });
    const settings = { "linkage.path": command, "workbench.startupEditor": "none" };
    await writeFile(at("data/data/Machine/settings.json"), JSON.stringify(settings));
    await mkdir(at("texts"));
    await Promise.all(Object.entries(texts).map(([name, text]) => writeFile(at("texts", name), text)));

    const environment = { ...process.env, HOME: editor.#folder };
    const folders = ["--server-data-dir", at("data"), "--extensions-dir", at("extensions")];
    await promisify(execFile)(process.execPath, [SERVER, "--install-extension", EXTENSION, ...folders], { env: environment });
    const network = ["--host", "127.0.0.1", "--port", "0", "--without-connection-token"];
    const consent = ["--accept-server-license-terms", "--telemetry-level", "off"];
    editor.#server = spawn(process.execPath, [SERVER, ...network, ...consent, ...folders], { env: environment });
    const port = await listening(editor.#server);

    editor.#browser = await chromium.launch({ executablePath: browser(), args: ["--no-sandbox"] });
    editor.page = await editor.#browser.newPage({ viewport: { width: 1400, height: 900 } });
    editor.page.setDefaultTimeout(PATIENCE);
    await editor.page.goto(`http://127.0.0.1:${port}/?folder=${at("texts")}`);
    return editor;
  }

  /** Trusts the folder, as the editor asks. */
  async trust() {
    await this.page.getByRole("button", { name: "Yes, I trust the authors" }).click();
  }

  /** Shows a text. */
  async show(name) {
    await this.page.locator(".explorer-folders-view .monaco-list-row", { hasText: name }).dblclick();
    await this.page.locator(".tab.active", { hasText: name }).waitFor();
  }

  /** Moves the caret to the end of a line, counted from 1. */
  async goTo(line) {
    await this.page.keyboard.press("Control+G");
    await this.page.keyboard.type(String(line));
    await this.page.keyboard.press("Enter");
    await this.page.keyboard.press("End");
  }

  /** Returns the first piece of the text that is a word. */
  word(word) {
    return this.page.locator(".view-line span", { hasText: new RegExp(`^${word}$`) }).first();
  }

  /** Waits for the frame of a panel whose page contains a text. */
  async frameWith(text) {
    const end = Date.now() + PATIENCE;
    while (Date.now() < end) {
      for (const frame of this.page.frames().slice(1)) {
        const content = await frame.evaluate(() => document.body?.innerText ?? "").catch(() => "");
        if (content.includes(text)) return frame;
      }
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
    throw new Error(`no panel contains \`${text}\``);
  }

  /** Ends the editor, and removes its folder. */
  async close() {
    await this.#browser?.close();
    this.#server?.kill();
    await rm(this.#folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** Waits until a server listens. Returns its port. */
function listening(server) {
  return new Promise((resolve, reject) => {
    let output = "";
    const read = (text) => {
      output += text;
      const port = output.match(/listening on (\d+)/)?.[1];
      if (port !== undefined) resolve(Number(port));
    };
    server.stdout.on("data", read);
    server.stderr.on("data", read);
    server.on("exit", () => reject(new Error(output)));
    setTimeout(() => reject(new Error(output)), PATIENCE).unref();
  });
}
