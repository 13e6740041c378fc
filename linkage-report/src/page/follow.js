// The report is rewritten while its page is open: the page looks for the newest version and shows
// that, and the mistakes that keep a newer one from being written. A script is all that a page may
// load that was opened as a file.

const ASK_EVERY = 500;

function follow(own) {
  // Another page stands at the place of a copy, or none. Pages without a report have no copies.
  if (typeof isSavedCopy !== "undefined" && isSavedCopy) return;
  const banner = document.createElement("pre");
  Object.assign(banner, { id: "mistakes", className: "warning", hidden: true });
  banner.setAttribute("role", "alert");
  banner.style.cssText = "position: sticky; top: 0; z-index: 9; max-height: 50vh; overflow: auto; white-space: pre-wrap";
  document.body.prepend(banner);
  window.linkageVersion = (newest, mistakes = "") => {
    if (newest !== own) location.reload();
    if (banner.textContent !== mistakes) banner.textContent = mistakes;
    banner.hidden = mistakes === "";
  };
  const ask = () => {
    const script = document.createElement("script");
    script.src = `version.js?${Date.now()}`;
    script.onload = () => script.remove();
    script.onerror = script.onload;
    document.head.append(script);
  };
  setInterval(ask, ASK_EVERY);
}
