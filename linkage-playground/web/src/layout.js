// Tabs on a phone, the border between text and mechanism, light and dark.

import { byId } from "./dom.js";

const NARROWEST = 20;
const WIDEST = 75;

const TABS = ["text", "view"];

export function startTabs() {
  for (const [name, other] of [["text", "view"], ["view", "text"]]) {
    const tab = byId(`${name}-tab`);
    tab.addEventListener("click", () => showTab(name));
    tab.addEventListener("keydown", ({ key }) => {
      if (key !== "ArrowLeft" && key !== "ArrowRight") return;
      showTab(other);
      byId(`${other}-tab`).focus();
    });
  }
  const narrow = matchMedia("(max-width: 760px)");
  narrow.addEventListener("change", () => nameParts(narrow.matches));
  nameParts(narrow.matches);
  showTab("text");
}

// Both parts are regions with names; on a phone they are panels of their tabs.
function nameParts(areTabs) {
  for (const name of TABS) {
    if (areTabs) byId(name).setAttribute("role", "tabpanel");
    else byId(name).removeAttribute("role");
  }
}

export function showTab(name) {
  document.querySelector("main").dataset.tab = name;
  for (const other of TABS) {
    const tab = byId(`${other}-tab`);
    tab.setAttribute("aria-selected", String(other === name));
    tab.tabIndex = other === name ? 0 : -1;
  }
}

export function startBorder() {
  const border = byId("border");
  const main = document.querySelector("main");
  let share = 42;
  const put = (next) => {
    share = Math.min(WIDEST, Math.max(NARROWEST, next));
    main.style.setProperty("--text", `${share}%`);
    border.setAttribute("aria-valuenow", String(Math.round(share)));
  };
  border.setAttribute("aria-valuemin", String(NARROWEST));
  border.setAttribute("aria-valuemax", String(WIDEST));
  border.addEventListener("pointerdown", (event) => border.setPointerCapture(event.pointerId));
  border.addEventListener("pointermove", (event) => event.buttons & 1 && put((100 * event.clientX) / main.clientWidth));
  border.addEventListener("keydown", ({ key }) => put(share + ({ ArrowLeft: -2, ArrowRight: 2 }[key] ?? 0)));
  put(share);
}

export function startTheme(changed) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const root = document.documentElement;
  const isDark = () => (root.dataset.theme ? root.dataset.theme === "dark" : dark.matches);
  const name = () => (byId("theme").textContent = isDark() ? "Light" : "Dark");
  byId("theme").addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    name();
    changed(root.dataset.theme);
  });
  dark.addEventListener("change", name);
  name();
}
