// The report is rewritten while its page is open: the page looks for the newest version and shows
// that. A script is all that a page may load that was opened as a file.

const ASK_EVERY = 500;

function follow(own) {
  // Another page stands at the place of a copy, or none.
  if (isSavedCopy) return;
  window.linkageVersion = (newest) => {
    if (newest !== own) location.reload();
  };
  setInterval(() => {
    const script = document.createElement("script");
    script.src = `version.js?${Date.now()}`;
    script.onload = () => script.remove();
    script.onerror = script.onload;
    document.head.append(script);
  }, ASK_EVERY);
}
