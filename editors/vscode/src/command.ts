// Runs of the command `linkage`.

import { execFile } from "node:child_process";
import { isAbsolute, join } from "node:path";

/** The end of a run: its status, or `null` if it was stopped, and both outputs. */
export interface Run {
  readonly status: number | null;
  readonly output: string;
  readonly errors: string;
}

/** The reason why a command cannot be used. */
export interface CommandFault {
  readonly kind: "absent" | "not executable" | "without server";
  readonly command: string;
}

/** A command that could not be started. */
export class CommandError extends Error {
  readonly fault: CommandFault;

  constructor(fault: CommandFault) {
    super(faultMessage(fault));
    this.fault = fault;
  }
}

/**
 * Returns the command of a setting: a name for PATH as it is, a file below the home folder for `~/`, and another file
 * with a relative path below the folder of the workspace.
 */
export function commandOf(setting: string, home: string, workspace: string | undefined): string {
  const path = setting.trim();
  if (path === "") return "linkage";
  if (/^~[\\/]/.test(path)) return join(home, path.slice(2));
  const isFile = /[\\/]/.test(path);
  return isFile && !isAbsolute(path) && workspace !== undefined ? join(workspace, path) : path;
}

/** Bytes that a run may print. */
const MOST_OUTPUT = 64 * 1024 * 1024;

/** Runs a command in a folder to its end, or until it is stopped. Throws `CommandError` if it cannot be started. */
export function run(command: string, args: readonly string[], folder: string, stop?: AbortSignal): Promise<Run> {
  return new Promise((resolve, reject) => {
    const options = { cwd: folder, maxBuffer: MOST_OUTPUT, windowsHide: true, ...(stop ? { signal: stop } : {}) };
    execFile(command, [...args], options, (error, output, errors) => {
      const code = error?.code;
      if (code === "ENOENT") reject(new CommandError({ kind: "absent", command }));
      else if (code === "EACCES") reject(new CommandError({ kind: "not executable", command }));
      else resolve({ status: error === null ? 0 : typeof code === "number" ? code : null, output, errors });
    });
  });
}

/** Returns the reason why a command has no language server, or `undefined` if it has one. */
export async function serverFault(command: string, folder: string): Promise<CommandFault | undefined> {
  try {
    const help = await run(command, ["lsp", "--help"], folder);
    return help.status === 0 ? undefined : { kind: "without server", command };
  } catch (error) {
    if (error instanceof CommandError) return error.fault;
    throw error;
  }
}

/** Returns the message about a fault: the fact, then the advice. */
export function faultMessage({ kind, command }: CommandFault): string {
  const advice = "Install it with `cargo install --path linkage-cli` in the repository of linkage, or set `linkage.path` to its file.";
  switch (kind) {
    case "absent":
      return `The command \`${command}\` was not found. ${advice}`;
    case "not executable":
      return `The file \`${command}\` is no program that can be run. ${advice}`;
    case "without server":
      return `The command \`${command}\` has no language server. Install a newer version of linkage, or set \`linkage.path\` to it.`;
  }
}
