// The elements as they were before the script made others. A browser saves a page as it is shown, and such a copy begins with these again.

const isSavedCopy = byId("fresh") !== null;

if (isSavedCopy) {
  for (const part of byId("fresh").content.children) document.querySelector(`body > ${part.localName}`).replaceWith(part.cloneNode(true));
  document.body.removeAttribute("class");
} else {
  const fresh = element("template", { id: "fresh" });
  fresh.content.append(...[...document.querySelectorAll("body > header, body > main")].map((part) => part.cloneNode(true)));
  document.body.prepend(fresh);
}

// The page as it is, for those who read it elsewhere.
function pageCopy() {
  return `<!doctype html>\n${document.documentElement.outerHTML}`;
}
