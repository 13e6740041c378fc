// Settings, and the message about a command that cannot be used.

import { homedir } from "node:os";
import * as vscode from "vscode";

import { type CommandFault, commandOf, faultMessage } from "./command.ts";

/** Returns the command of linkage: a name in PATH, or a file. */
export function commandPath(): string {
  const setting = vscode.workspace.getConfiguration("linkage").get<string>("path", "");
  return commandOf(setting, homedir(), vscode.workspace.workspaceFolders?.[0]?.uri.fsPath);
}

/** Shows why the command cannot be used, with a way to the setting. */
export async function showFault(fault: CommandFault): Promise<void> {
  const settings = "Open Settings";
  const chosen = await vscode.window.showErrorMessage(faultMessage(fault), settings);
  if (chosen === settings) await vscode.commands.executeCommand("workbench.action.openSettings", "linkage.path");
}
