// Files of the reader: opened, and saved as downloads.

// The bytes of a mark at the beginning of some files in UTF-8.
const MARK = [0xef, 0xbb, 0xbf];

// A file with its text; null instead of the text if it is none in UTF-8. The form is that in which it is saved again.
export function openFile() {
  return new Promise((done) => {
    const field = Object.assign(document.createElement("input"), { type: "file", accept: ".mech,.rs,.txt,text/plain" });
    field.addEventListener("change", async () => {
      const [file] = field.files;
      done({ name: file.name, ...read(new Uint8Array(await file.arrayBuffer())) });
    });
    field.click();
  });
}

// The text of some bytes without their mark, and their form: the mark, and the ends of lines.
export function read(bytes) {
  const hasMark = MARK.every((byte, k) => bytes[k] === byte);
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    const count = (pattern) => text.match(pattern)?.length ?? 0;
    // A file with several ends of lines gets the most frequent one.
    const ends = [["\r\n", count(/\r\n/g)], ["\n", count(/(?<!\r)\n/g)], ["\r", count(/\r(?!\n)/g)]];
    const [end, most] = ends.reduce((best, other) => (other[1] > best[1] ? other : best));
    return { text, form: { hasMark, end: most === 0 ? "\n" : end }, isMixed: ends.filter(([, found]) => found > 0).length > 1 };
  } catch {
    return { text: null };
  }
}

// A text in the form of its file.
export function written(text, { hasMark, end }) {
  return (hasMark ? "\ufeff" : "") + text.replaceAll("\n", end);
}

export function saveFile(name, text) {
  const types = { svg: "image/svg+xml", csv: "text/csv", html: "text/html" };
  const type = types[name.split(".").at(-1)] ?? "text/plain";
  const address = URL.createObjectURL(new Blob([text], { type }));
  Object.assign(document.createElement("a"), { href: address, download: name }).click();
  // After the browser has taken it.
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}
