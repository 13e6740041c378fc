// The script of the panel: shows the newest page, and keeps its position, its speed and its scroll.

import { carryOver } from "./carry.ts";

/** Messages of the extension. */
export type Message = { readonly page: string } | { readonly mistakes: string };

interface Host {
  postMessage(message: unknown): void;
}

declare function acquireVsCodeApi(): Host;

const pages = document.getElementById("pages") as HTMLElement;
const mistakes = document.getElementById("mistakes") as HTMLElement;

function showMistakes(text: string): void {
  mistakes.textContent = text;
  mistakes.hidden = text === "";
}

/** True if the editor has dark colours. */
function isDark(): boolean {
  const { classList } = document.body;
  return classList.contains("vscode-dark") || (classList.contains("vscode-high-contrast") && !classList.contains("vscode-high-contrast-light"));
}

/** Loads a page next to the shown one, and replaces that when it is ready: nothing flickers. */
function showPage(html: string): void {
  pages.querySelector("iframe[data-coming]")?.remove();
  const frame = document.createElement("iframe");
  frame.title = "Living page";
  frame.dataset["coming"] = "";
  // The script of the panel reads the position in the page.
  frame.sandbox.add("allow-scripts", "allow-same-origin", "allow-downloads", "allow-modals");
  frame.srcdoc = html;
  frame.addEventListener("load", () => {
    const shown = pages.querySelector<HTMLIFrameElement>("iframe:not([data-coming])");
    carryOver(shown?.contentWindow ?? null, frame.contentWindow, isDark());
    delete frame.dataset["coming"];
    shown?.remove();
  });
  pages.append(frame);
}

addEventListener("message", ({ data, source }: MessageEvent<Message>) => {
  // Pages have nothing to say here.
  if ([...pages.querySelectorAll("iframe")].some((frame) => frame.contentWindow === source)) return;
  if ("page" in data) {
    showPage(data.page);
    showMistakes("");
  } else {
    showMistakes(data.mistakes);
  }
});

acquireVsCodeApi().postMessage("ready");
