// Builds the folder of the playground: `node build.mjs PARTS.json MODULE.wasm FOLDER`.

import { createHash } from "node:crypto";
import { mkdir, readdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const [parts, module, folder] = process.argv.slice(2);

async function bundled(entry, define = {}) {
  const { outputFiles, metafile } = await build({
    entryPoints: [join(here, "src", entry)], bundle: true, minify: true, write: false, metafile: true, charset: "utf8",
    format: "iife", target: ["es2023"], legalComments: "none", define, absWorkingDir: here,
  });
  return { text: outputFiles[0].text, inputs: Object.keys(metafile.inputs) };
}

// No text in a script ends its element.
function embedded(script) {
  return script.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
}

function hash(text) {
  return `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
}

// Licences of all packages in a bundle.
async function licences(inputs) {
  const packages = new Set(inputs.flatMap((input) => input.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1] ?? []));
  const texts = [...packages].sort().map(async (name) => {
    const root = join(here, "node_modules", name);
    const { version, license } = JSON.parse(await readFile(join(root, "package.json"), "utf8"));
    const file = (await readdir(root)).find((entry) => /^licen[cs]e/i.test(entry));
    const text = file === undefined ? "" : await readFile(join(root, file), "utf8");
    return `${name} ${version} (${license})\n\n${text.trim()}\n`;
  });
  return (await Promise.all(texts)).join(`\n${"-".repeat(80)}\n\n`);
}

const view = JSON.parse(await readFile(parts, "utf8"));
const read = (name) => readFile(join(here, "src", name), "utf8");
const frame = { style: view.style + (await read("frame.css")), body: view.body, script: embedded(view.script) };
const worker = await bundled("worker.js");
const main = await bundled("main.js", { FRAME: JSON.stringify(frame), WORKER: JSON.stringify(worker.text) });
const script = embedded(main.text);
const style = await read("style.css");
const wasm = gzipSync(await readFile(module), { level: 9 }).toString("base64");

// What is opened from disk can start a worker from a text of its own only: `worker-src blob:`.
const policy = [
  "default-src 'none'", `script-src ${hash(script)} ${hash(frame.script)} 'wasm-unsafe-eval'`, `style-src ${hash(style)} ${hash(frame.style)}`,
  "img-src data: blob:", "connect-src blob:", "worker-src blob:", "base-uri 'none'", "form-action 'none'",
].join("; ");

await mkdir(folder, { recursive: true });
const html = `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>linkage playground</title>
<style>${style}</style>
</head>
<body>
${await read("page.html")}
<script type="text/plain" id="module">${wasm}</script>
<script>${script}</script>
</body>
</html>
`;
await writeFile(join(folder, "index.html"), html);
await writeFile(join(folder, "LICENCES.txt"), await licences([...main.inputs, ...worker.inputs]));
const compressed = gzipSync(html, { level: 9 }).length;
console.log(`${join(folder, "index.html")}: ${(html.length / 1e6).toFixed(2)} MB, ${(compressed / 1e6).toFixed(2)} MB compressed`);
