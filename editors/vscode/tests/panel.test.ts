// The document of the panel in Chromium, with its policy: pages replace each other and keep their state.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

import { framed, panelDocument } from "../src/page/frame.ts";
import { LivingPage } from "../src/page/living.ts";

const execute = promisify(execFile);
const DIST = dirname(fileURLToPath(import.meta.url));
const NONCE = "nonceofthispanel";

/** A page with the elements that the panel uses. */
const PAGE = `<!doctype html><html><head><meta charset="utf-8"><title>COUNT</title></head><body style="height: 9000px">
<button id="theme"></button><button id="play"></button><input id="position" type="range" min="0" max="ROWS">
<select id="speed"><option value="8">8</option><option value="16">16</option></select>
<script>
const play = document.getElementById("play"), position = document.getElementById("position");
const set = (playing) => play.toggleAttribute("data-playing", playing);
play.onclick = () => set(!play.hasAttribute("data-playing"));
position.oninput = () => set(false);
document.getElementById("theme").onclick = () => { document.documentElement.dataset.theme = "dark"; };
position.value = 0;
set(true);
</script></body></html>`;

/** Stands for the editor: sends pages, acts as a reader, and writes what is shown then. */
const EDITOR = `
const results = [];
const posted = new Promise((resolve) => { window.acquireVsCodeApi = () => ({ postMessage: resolve }); });
document.addEventListener("securitypolicyviolation", (event) => results.push("refused " + event.violatedDirective));
const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const frames = () => [...document.querySelectorAll("iframe")];
const part = (id) => frames()[0].contentDocument.getElementById(id);
const note = () => {
  const { contentDocument, contentWindow } = frames()[0];
  const { theme } = contentDocument.documentElement.dataset;
  results.push([frames().length, contentDocument.title, part("position").value, part("play").hasAttribute("data-playing") ? "plays" : "stands", part("speed").value, theme, contentWindow.scrollY].join(" "));
};
(async () => {
  results.push(await posted);
  const [first, second, third] = PAGES;
  document.body.className = "vscode-dark";
  postMessage({ page: first }, "*");
  await wait(900);
  note();
  part("position").value = Math.round(part("position").max / 4);
  part("position").dispatchEvent(new Event("input"));
  part("speed").value = "16";
  frames()[0].contentWindow.scrollTo(0, 50);
  postMessage({ mistakes: "error: <b>one</b>" }, "*");
  await wait(100);
  results.push(document.getElementById("mistakes").hidden + " " + document.getElementById("mistakes").textContent);
  postMessage({ page: second }, "*");
  await wait(900);
  note();
  results.push(String(document.getElementById("mistakes").hidden));
  part("play").click();
  postMessage({ page: third }, "*");
  await wait(900);
  results.push(part("play").hasAttribute("data-playing") ? "plays" : "stands");
  const refused = document.createElement("script");
  refused.textContent = "results.push('a script without the nonce ran')";
  document.body.append(refused);
  await wait(50);
  document.body.replaceChildren(Object.assign(document.createElement("pre"), { id: "results", textContent: JSON.stringify(results) }));
})();
`;

async function browser(): Promise<string | undefined> {
  for (const name of [process.env["CHROMIUM"] ?? "chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"]) {
    const found = await execute(name, ["--version"]).then(() => true, () => false);
    if (found) return name;
  }
  return undefined;
}

/** Returns what the editor noted about two pages. */
async function shown(chromium: string, pages: readonly string[]): Promise<string[]> {
  const folder = await mkdtemp(join(tmpdir(), "linkage-test-"));
  const shell = await readFile(join(DIST, "shell.js"), "utf8");
  const list = JSON.stringify(pages.map((page) => framed(page, NONCE))).replaceAll("<", "\\u003c");
  const editor = `<script nonce="${NONCE}">const PAGES = ${list};${EDITOR}</script>`;
  const text = panelDocument(NONCE, shell).replace('<pre id="mistakes"', () => `${editor}<pre id="mistakes"`);
  await writeFile(join(folder, "panel.html"), text);
  const options = ["--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=20000", "--dump-dom", `file://${folder}/panel.html`];
  const { stdout } = await execute(chromium, [`--user-data-dir=${folder}/profile`, ...options], { maxBuffer: 2 ** 26, timeout: 60_000 });
  await rm(folder, { recursive: true, force: true });
  const results = stdout.match(/<pre id="results">(.*)<\/pre>/s)?.[1] ?? "[]";
  return JSON.parse(results.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&amp;", "&"));
}

const chromium = await browser();

test("pages replace each other and keep position, play, speed, scroll and theme", { skip: chromium === undefined }, async () => {
  const page = (title: string, rows: number) => PAGE.replace("COUNT", title).replace("ROWS", String(rows));
  const results = await shown(chromium ?? "", [page("one", 100), page("two", 200), page("three", 200)]);
  assert.deepEqual(results, [
    "ready",
    "1 one 0 plays 8 dark 0",
    "false error: <b>one</b>",
    "1 two 50 stands 16 dark 50",
    "true",
    "plays",
    "refused script-src-elem",
  ]);
});

const command = process.env["LINKAGE_COMMAND"];

test("pages of the command run with the policy of the panel", { skip: chromium === undefined || command === undefined }, async () => {
  const living = new LivingPage();
  const text = await readFile(join(DIST, "../../../linkage-cli/src/templates/slider.mech"), "utf8");
  const write = async (changed: string) => {
    const result = await living.write({ file: "slider.mech", text: changed, mechanism: undefined, command: command ?? "" }, new AbortController().signal);
    assert.ok(result !== undefined && "page" in result);
    return result.page;
  };
  const results = await shown(chromium ?? "", [await write(text), await write(text.replace("40mm", "41mm")), await write(text)]);
  await living.remove();
  assert.equal(results[3]?.replace(/ \S+$/, ""), "1 SliderCrank 90 stands 16 dark");
  assert.deepEqual(results.filter((result) => result.startsWith("refused")), ["refused script-src-elem"]);
});
