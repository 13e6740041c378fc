// Colours of templates, word for word, as `tests/snapshots` has them. `UPDATE=1` writes them again.

import assert from "node:assert/strict";
import { readFile, readdir, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

import oniguruma from "vscode-oniguruma";
import textmate, { type IGrammar } from "vscode-textmate";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "..");
const TEMPLATES = join(ROOT, "../../linkage-cli/src/templates");
const SNAPSHOTS = join(ROOT, "tests/snapshots");

/** A few lines of the grammar of Rust: enough for what is around the macro. */
const RUST = { scopeName: "source.rust", patterns: [{ match: "//.*$", name: "comment.line.rust" }, { match: "\\b(struct|let)\\b", name: "keyword.rust" }], repository: {} };

async function json(path: string): Promise<Record<string, unknown>> {
  return JSON.parse(await readFile(join(ROOT, path), "utf8"));
}

async function grammar(scope: string): Promise<IGrammar> {
  const wasm = await readFile(createRequire(import.meta.url).resolve("vscode-oniguruma/release/onig.wasm"));
  await oniguruma.loadWASM(new Uint8Array(wasm).buffer);
  const files: Record<string, string> = { "source.linkage": "syntaxes/linkage.tmLanguage.json", "linkage.macro.rust": "syntaxes/macro.tmLanguage.json" };
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({ createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns), createOnigString: (text) => new oniguruma.OnigString(text) }),
    loadGrammar: async (name) => {
      const file = files[name];
      const raw = file === undefined ? RUST : await json(file);
      return textmate.parseRawGrammar(JSON.stringify(raw), "grammar.json");
    },
    getInjections: (name) => (name === "source.rust" ? ["linkage.macro.rust"] : undefined),
  });
  const loaded = await registry.loadGrammar(scope);
  assert.ok(loaded);
  return loaded;
}

/** Returns the words of a text, each with its innermost scope. */
function coloured(loaded: IGrammar, text: string): [string, string][] {
  const words: [string, string][] = [];
  let state = textmate.INITIAL;
  for (const line of text.split("\n")) {
    const { tokens, ruleStack } = loaded.tokenizeLine(line, state);
    state = ruleStack;
    for (const { startIndex, endIndex, scopes } of tokens) {
      const word = line.slice(startIndex, endIndex).trim();
      if (word !== "") words.push([word, (scopes.at(-1) ?? "").replace(/\.linkage$/, "")]);
    }
  }
  return words;
}

const linkage = await grammar("source.linkage");

function scopesOf(text: string, word: string): string[] {
  return coloured(linkage, text).filter(([own]) => own === word).map(([, scope]) => scope);
}

for (const name of await readdir(TEMPLATES)) {
  test(`colours of ${name}`, async () => {
    const words = coloured(linkage, await readFile(join(TEMPLATES, name), "utf8"));
    const found = words.map(([word, scope]) => `${word}\t${scope}\n`).join("");
    const path = join(SNAPSHOTS, name.replace(/\.mech$/, ".txt"));
    if (process.env["UPDATE"] !== undefined) await writeFile(path, found);
    assert.equal(found, await readFile(path, "utf8"));
    // Only braces and names of the language are without a scope that colours know.
    const bare = words.filter(([word, scope]) => scope === "source" && !/^[()[\]]+$/.test(word));
    assert.deepEqual(bare, []);
  });
}

test("words of the language are names where no word can be", () => {
  assert.deepEqual(scopesOf("struct A {\n param link = 1mm;\n link link: a, b length link, mass mass at link;\n}", "link"), [
    "variable.other.definition", "keyword.other.item", "variable.other.definition", "variable.other", "variable.other",
  ]);
  assert.deepEqual(scopesOf("struct A { let a = mass * length; }", "mass"), ["variable.other"]);
  assert.deepEqual(scopesOf("body a = pin on frame at p, mass mass at q;", "mass"), ["keyword.control.clause", "variable.other"]);
});

// Otherwise VS Code completes nothing while a word is typed.
test("names are words of the editor", async () => {
  const { wordPattern } = (await json("language-configuration.json")) as { wordPattern: { pattern: string; flags: string } };
  const word = new RegExp(wordPattern.pattern, `${wordPattern.flags}g`);
  assert.deepEqual("let Länge_2 = a.b;".match(word), ["let", "Länge_2", "a", "b"]);
});

test("numbers have their units", () => {
  const text = "damper 0.1N*s/m on way; let a = 9.8m/s^2 * t + 30deg..360deg + 5 mm;";
  const units = coloured(linkage, text).filter(([, scope]) => scope === "support.type.unit").map(([word]) => word);
  assert.deepEqual(units, ["N", "s", "m", "m", "s", "deg", "deg", "mm"]);
});

test("the macro has its colours in Rust", async () => {
  const rust = await grammar("source.rust");
  const text = "struct S;\nlinkage::mechanism! {\n struct A { unit mm; } // {\n impl A { fn f(phi) -> F { psi } }\n}\nlet x = 5mm;\n// mechanism! {\nlet y = 5mm;";
  const words = coloured(rust, text);
  const scope = (word: string) => words.filter(([own]) => own === word).map(([, found]) => found);
  assert.deepEqual(scope("unit"), ["keyword.other.item"]);
  assert.deepEqual(scope("fn"), ["keyword.declaration.function"]);
  assert.deepEqual(scope("let"), ["keyword.rust", "keyword.rust"]);
  assert.ok(!words.some(([word]) => word === "5"), "the text after the macro has no colours of the language");
});
