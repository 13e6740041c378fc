// Bundles the extension, the script of its page and, with `--tests`, the tests.

import { readFile, readdir, writeFile } from "node:fs/promises";
import { join } from "node:path";

import { build } from "esbuild";

const shared = { bundle: true, logLevel: "warning", legalComments: "none", target: "es2022" };

/** Returns the folders of packages that a bundle has files of. */
function packages({ inputs }) {
  const folders = Object.keys(inputs).flatMap((path) => path.match(/^.*node_modules\/(?:@[^/]+\/)?[^/]+/) ?? []);
  return [...new Set(folders)].sort();
}

/** Returns name, version and licence of a package. Fails if it has no text of a licence. */
async function licence(folder) {
  const { name, version, license } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  const file = (await readdir(folder)).find((entry) => /^licen[cs]e/i.test(entry));
  if (file === undefined) throw new Error(`${name} ${version} has no file with its licence`);
  return `${name} ${version} (${license})\n\n${(await readFile(join(folder, file), "utf8")).trim()}\n`;
}

const { metafile } = await build({
  ...shared,
  entryPoints: ["src/extension.ts"],
  outfile: "dist/extension.js",
  platform: "node",
  format: "cjs",
  external: ["vscode"],
  minify: true,
  metafile: true,
});
const licences = await Promise.all(packages(metafile).map(licence));
await writeFile("dist/licences.txt", licences.join(`\n${"-".repeat(80)}\n\n`));

await build({ ...shared, entryPoints: ["src/page/shell.ts"], outfile: "dist/shell.js", format: "iife", minify: true });

if (process.argv.includes("--tests")) {
  await build({ ...shared, entryPoints: ["tests/all.ts"], outfile: "dist/tests.mjs", platform: "node", format: "esm", packages: "external" });
}
