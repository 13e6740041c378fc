// The packaged extension in VS Code itself: messages, values, changes, and the living page.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

import { Editor, browser } from "./editor.mjs";

const TEMPLATES = join(dirname(fileURLToPath(import.meta.url)), "../../../linkage-cli/src/templates");
const COMMAND = process.env.LINKAGE_COMMAND;

const SLIDER = await readFile(join(TEMPLATES, "slider.mech"), "utf8");
const WRONG = SLIDER.replace("polar(crank, phi)", "polar(cank, phi)");

/** The reason why nothing can be tested. */
const skip = COMMAND === undefined ? "LINKAGE_COMMAND names no command" : browser() === undefined && "no Chromium";

/** Returns the number of the first line with a text, counted from 1. */
const lineOf = (text) => SLIDER.split("\n").findIndex((line) => line.includes(text)) + 1;

test("VS Code shows messages, values, changes and the living page", { skip }, async (context) => {
  const editor = await Editor.open({ "slider.mech": SLIDER, "wrong.mech": WRONG }, COMMAND);
  context.after(() => editor.close());
  const { page } = editor;
  await editor.trust();
  await editor.show("slider.mech");

  await context.test("hints have the solutions", async () => {
    const line = page.locator(".view-line", { hasText: "153.7mm" }).first();
    assert.match(await line.innerText(), /unknown\s+slide\s+=\s+150mm/);
  });
  await context.test("hover has the value of a name", async () => {
    await editor.word("pin").hover();
    const hover = page.locator(".monaco-hover:visible", { hasText: "at the reference" }).first();
    assert.match(await hover.innerText(), /34\.64102mm, 20mm/);
  });
  await context.test("the page follows the text", async () => {
    await page.getByRole("button", { name: /Open Living Page Beside/ }).first().click();
    const frame = await editor.frameWith("A crank drives a slider");
    assert.ok(await frame.evaluate(() => document.querySelectorAll("svg").length) > 1);
    await page.locator(".tab", { hasText: /^slider.mech/ }).click();
    await editor.goTo(lineOf("/// A crank drives"));
    await page.keyboard.type(" It is short.");
    await editor.frameWith("It is short.");
  });
  await context.test("a mistake has a message and a change", async () => {
    await editor.show("wrong.mech");
    await page.locator(".squiggly-error").first().waitFor();
    await editor.word("cank").click();
    await page.keyboard.press("Control+.");
    await page.locator(".action-widget", { hasText: "write `crank`" }).waitFor();
    await page.keyboard.press("Enter");
    await page.locator(".squiggly-error").first().waitFor({ state: "detached" });
  });
  await context.test("names are completed while they are typed", async () => {
    await editor.goTo(lineOf("let slider"));
    await page.keyboard.type(" let half = ro", { delay: 50 });
    await page.locator(".suggest-widget .monaco-list-row", { hasText: "rod" }).first().waitFor();
  });
});
