// Numbers of tables: some digits to read, all of them to copy.

function showNumber(node, value, sign = "") {
  const [few, all] = [sign + short(value), sign + digits(value)];
  node.textContent = few;
  return set(node, { "data-exact": all, title: few === all ? null : all });
}

function startCopying() {
  listen(document, "copy", copyExactly);
}

function copyExactly(event) {
  const selection = getSelection();
  if (selection.rangeCount === 0 || selection.isCollapsed) return;
  const range = selection.getRangeAt(0);
  const copied = exactOf(selection, range);
  if (copied === null) return;
  event.clipboardData.setData("text/plain", copied.text);
  event.clipboardData.setData("text/html", copied.html);
  event.preventDefault();
}

// The selection with all digits; null if no whole number is in it.
function exactOf(selection, range) {
  const home = range.commonAncestorContainer;
  const single = home.nodeType === Node.TEXT_NODE ? home.parentElement.closest("[data-exact]") : null;
  if (single) {
    const all = single.dataset.exact;
    return selection.toString().trim() === single.textContent ? { text: all, html: all } : null;
  }
  const part = element("div", { class: "copied" }, range.cloneContents());
  const numbers = part.querySelectorAll("[data-exact]");
  if (numbers.length === 0) return null;
  for (const number of numbers) number.textContent = number.dataset.exact;
  // Only nodes that are laid out know their lines and columns.
  document.body.append(part);
  const copied = { text: part.innerText, html: part.innerHTML };
  part.remove();
  return copied;
}
