// The extension: the language server, and a living page beside the text.

import * as vscode from "vscode";

import { commandPath } from "./settings.ts";
import { Pages } from "./page/pages.ts";
import { Server } from "./server.ts";

let server: Server | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const output = vscode.window.createOutputChannel("linkage", { log: true });
  const started = new Server(output);
  const pages = new Pages(context.extensionUri, output);
  server = started;
  context.subscriptions.push(
    output,
    pages,
    vscode.commands.registerCommand("linkage.openPage", () => pages.open(vscode.window.activeTextEditor)),
    vscode.commands.registerCommand("linkage.restartServer", () => started.restart(commandPath())),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      if (change.affectsConfiguration("linkage.path")) await started.restart(commandPath());
    }),
    vscode.workspace.onDidGrantWorkspaceTrust(() => started.restart(commandPath())),
  );
  await started.restart(commandPath());
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}
