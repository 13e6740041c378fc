// The page of a text that need not be saved: the command reads a copy of it.

import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";

import { run } from "../command.ts";

/** A text whose page is wanted. */
export interface Wanted {
  /** The file of the text: its name is in messages. */
  readonly file: string;
  readonly text: string;
  /** The mechanism, if there are several. */
  readonly mechanism: string | undefined;
  /** The command. */
  readonly command: string;
}

/** A page, or the mistakes because of which there is none. */
export type Result = { readonly page: string } | { readonly mistakes: string };

/** Pages of one text, in a folder that is removed at the end. */
export class LivingPage {
  readonly #folder: Promise<string>;

  constructor() {
    this.#folder = mkdtemp(join(tmpdir(), "linkage-"));
  }

  /** Returns the page of a text; `undefined` if the run was stopped. Throws if the command cannot be started. */
  async write(wanted: Wanted, stop: AbortSignal): Promise<Result | undefined> {
    const folder = await this.#folder;
    const name = basename(wanted.file);
    await writeFile(join(folder, name), wanted.text);
    const choice = wanted.mechanism === undefined ? [] : ["--mechanism", wanted.mechanism];
    const ended = await run(wanted.command, ["page", name, "-o", "page", ...choice], folder, stop);
    if (stop.aborted) return undefined;
    if (ended.status !== 0) return { mistakes: ended.errors.trim() || "The command ended without a page." };
    return { page: await readFile(join(folder, "page", "index.html"), "utf8") };
  }

  /** Removes the folder. */
  async remove(): Promise<void> {
    await rm(await this.#folder, { recursive: true, force: true });
  }
}
