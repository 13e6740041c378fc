// Files of the reader: opened, and saved as downloads.

export function openFile() {
  return new Promise((done) => {
    const field = Object.assign(document.createElement("input"), { type: "file", accept: ".mech,.rs,.txt,text/plain" });
    field.addEventListener("change", async () => {
      const [file] = field.files;
      done({ name: file.name, text: await file.text() });
    });
    field.click();
  });
}

export function saveFile(name, text) {
  const types = { svg: "image/svg+xml", csv: "text/csv", html: "text/html" };
  const type = types[name.split(".").at(-1)] ?? "text/plain";
  const address = URL.createObjectURL(new Blob([text], { type }));
  Object.assign(document.createElement("a"), { href: address, download: name }).click();
  // After the browser has taken it.
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}
