// The panels with living pages, one for each text.

import { readFile } from "node:fs/promises";
import * as vscode from "vscode";

import { CommandError } from "../command.ts";
import { commandPath, showFault } from "../settings.ts";
import { Follower } from "./follower.ts";
import { framed, newNonce, panelDocument } from "./frame.ts";
import { LivingPage, type Wanted } from "./living.ts";
import { mechanismAt } from "./mechanisms.ts";
import type { Message } from "./shell.ts";

/** Milliseconds after which a page is not waited for if its text has changed. */
const PATIENCE = 2000;

/** The language of Rust files, which may have the macro. */
const RUST = "rust";

export class Pages implements vscode.Disposable {
  readonly #extension: vscode.Uri;
  readonly #output: vscode.LogOutputChannel;
  readonly #open = new Map<string, Page>();

  constructor(extension: vscode.Uri, output: vscode.LogOutputChannel) {
    this.#extension = extension;
    this.#output = output;
  }

  /** Opens the page of the text in an editor, or shows it if it is open. */
  async open(editor: vscode.TextEditor | undefined): Promise<void> {
    if (editor === undefined) return;
    if (!vscode.workspace.isTrusted) {
      await vscode.window.showWarningMessage("The living page runs the command of linkage, which needs a trusted folder.");
      return;
    }
    const key = editor.document.uri.toString();
    const known = this.#open.get(key);
    if (known !== undefined) {
      known.reveal();
      return;
    }
    const script = vscode.Uri.joinPath(this.#extension, "dist", "shell.js").fsPath;
    const page = new Page(editor, await readFile(script, "utf8"), this.#output);
    this.#open.set(key, page);
    page.onClosed(() => this.#open.delete(key));
  }

  dispose(): void {
    for (const page of this.#open.values()) page.close();
  }
}

/** A panel with the page of one text. */
class Page {
  readonly #panel: vscode.WebviewPanel;
  readonly #document: vscode.TextDocument;
  readonly #output: vscode.LogOutputChannel;
  readonly #living = new LivingPage();
  readonly #follower: Follower<Wanted>;
  readonly #nonce = newNonce();
  #offset: number;
  /** Messages for the script of the panel before it runs: the last page and the last mistakes. */
  #early: Message[] | undefined = [];
  /** True after the message about a command that cannot be used, until it can. */
  #warned = false;

  constructor(editor: vscode.TextEditor, script: string, output: vscode.LogOutputChannel) {
    this.#document = editor.document;
    this.#offset = editor.document.offsetAt(editor.selection.active);
    this.#output = output;
    this.#follower = new Follower((wanted, stop) => this.#write(wanted, stop), PATIENCE);
    const name = vscode.workspace.asRelativePath(editor.document.uri);
    const beside = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    this.#panel = vscode.window.createWebviewPanel("linkage.page", `Page of ${name}`, beside, {
      enableScripts: true,
      localResourceRoots: [],
      // The drawing goes on where it was when the panel was hidden.
      retainContextWhenHidden: true,
    });
    const { webview } = this.#panel;
    const listeners = [
      webview.onDidReceiveMessage(() => this.#begin()),
      vscode.workspace.onDidChangeTextDocument(({ document }) => this.#follow(document)),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor, selections }) => {
        if (textEditor.document === this.#document && selections[0]) this.#choose(selections[0].active);
      }),
    ];
    this.onClosed(() => {
      listeners.forEach((listener) => listener.dispose());
      this.#follower.end();
      this.#living.remove().catch((error: unknown) => this.#output.warn(String(error)));
    });
    webview.html = panelDocument(this.#nonce, script);
    this.#follow(this.#document);
  }

  onClosed(then: () => void): void {
    this.#panel.onDidDispose(then);
  }

  reveal(): void {
    this.#panel.reveal(undefined, true);
  }

  close(): void {
    this.#panel.dispose();
  }

  #follow(changed: vscode.TextDocument): void {
    if (changed === this.#document) this.#follower.push(this.#wanted());
  }

  /** Shows the mechanism at the cursor, if there are several. */
  #choose(cursor: vscode.Position): void {
    const before = this.#wanted().mechanism;
    this.#offset = this.#document.offsetAt(cursor);
    if (this.#wanted().mechanism !== before) this.#follow(this.#document);
  }

  #wanted(): Wanted {
    const text = this.#document.getText();
    const mechanism = mechanismAt(text, this.#offset, this.#document.languageId === RUST);
    const ending = this.#document.languageId === RUST ? ".rs" : ".mech";
    const file = this.#document.isUntitled ? `untitled${ending}` : this.#document.uri.path;
    return { file, text, mechanism, command: commandPath() };
  }

  async #write(wanted: Wanted, stop: AbortSignal): Promise<void> {
    try {
      const result = await this.#living.write(wanted, stop);
      if (result === undefined) return;
      this.#take("page" in result ? { page: framed(result.page, this.#nonce) } : result);
      this.#warned = false;
    } catch (error) {
      this.#take({ mistakes: String(error instanceof CommandError ? error.message : error) });
      if (error instanceof CommandError && !this.#warned) void showFault(error.fault);
      this.#warned = true;
    }
  }

  /** Sends the messages that wait for the script of the panel. */
  #begin(): void {
    const early = this.#early ?? [];
    this.#early = undefined;
    early.forEach((message) => this.#take(message));
  }

  #take(message: Message): void {
    if (this.#early === undefined) {
      // A panel that is closing takes no message.
      this.#panel.webview.postMessage(message).then(undefined, () => undefined);
      return;
    }
    const pages = this.#early.filter((early) => "page" in early);
    this.#early = "page" in message ? [message] : [...pages, message];
  }
}
