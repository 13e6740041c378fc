// The language server: a process of the command, which is started again on request.

import { tmpdir } from "node:os";
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";

import { serverFault } from "./command.ts";
import { showFault } from "./settings.ts";

export class Server {
  readonly #output: vscode.LogOutputChannel;
  #client: LanguageClient | undefined;
  /** The last change of the server: changes come one after the other. */
  #changed: Promise<void> = Promise.resolve();

  constructor(output: vscode.LogOutputChannel) {
    this.#output = output;
  }

  /** Starts the server, or starts it again. In folders that are not trusted there is none. */
  restart(command: string): Promise<void> {
    return this.#next(async () => {
      await this.#stop();
      if (vscode.workspace.isTrusted) await this.#start(command);
    });
  }

  /** Ends the server. */
  stop(): Promise<void> {
    return this.#next(() => this.#stop());
  }

  #next(change: () => Promise<void>): Promise<void> {
    const report = (error: unknown) => this.#output.error(String(error));
    this.#changed = this.#changed.then(change).catch(report);
    return this.#changed;
  }

  async #start(command: string): Promise<void> {
    const fault = await serverFault(command, tmpdir());
    if (fault !== undefined) {
      // Nobody waits for the answer to the message.
      void showFault(fault);
      return;
    }
    const client = new LanguageClient(
      "linkage",
      "linkage",
      // Standard input and output, as without `transport`: with it the client adds the argument `--stdio`.
      { command, args: ["lsp"] },
      { documentSelector: [{ language: "linkage" }], outputChannel: this.#output },
    );
    await client.start();
    this.#client = client;
  }

  async #stop(): Promise<void> {
    const client = this.#client;
    this.#client = undefined;
    await client?.dispose();
  }
}
