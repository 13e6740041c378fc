// Elements of the page and of drawings, made and changed in one line each.

const SVG = "http://www.w3.org/2000/svg";

function byId(id) {
  return document.getElementById(id);
}

// Attributes; those that are null or false go away.
function set(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === false) node.removeAttribute(name);
    else if (name === "style") node.style.cssText = value;
    else setAttributeTo(node, name, value === true ? "" : String(value));
  }
  return node;
}

// Ends when a host shows another report in place of this one.
const life = new AbortController();

// Listens to the window, the document, or the system.
function listen(target, name, listener) {
  target.addEventListener(name, listener, { signal: life.signal });
}

function observeSize(node, listener) {
  const observer = new ResizeObserver(listener);
  observer.observe(node);
  life.signal.addEventListener("abort", () => observer.disconnect());
}

// An equal value would make the browser arrange everything again.
function setAttributeTo(node, name, text) {
  if (node.getAttribute(name) !== text) node.setAttribute(name, text);
}

function element(name, attributes, ...children) {
  const node = set(document.createElement(name), attributes ?? {});
  node.append(...children);
  return node;
}

function shape(name, attributes, ...children) {
  const node = set(document.createElementNS(SVG, name), attributes ?? {});
  node.append(...children);
  return node;
}

// The words of a node, which has nothing else, and its children. Equal content stays untouched.
function write(node, text) {
  if (node.firstChild === null) node.append(text);
  else if (node.firstChild.data !== text) node.firstChild.data = text;
  return node;
}

function hold(node, children) {
  const same = node.childNodes.length === children.length && children.every((child, k) => child === node.childNodes[k]);
  if (!same) node.replaceChildren(...children);
}

// Attributes of drawings: no more digits than a screen shows.
function pixel(value) {
  return Math.round(value * 100) / 100;
}

// The same as words, many of them: whole numbers are printed several times as fast as others.
const HUNDREDTHS = Array.from({ length: 100 }, (_, n) => String(n / 100).slice(1));
// The range of bits of whole numbers.
const MOST_WHOLE = 2 ** 31;

function pixelText(value) {
  const all = Math.round(value * 100);
  if (!(all >= 0 && all < MOST_WHOLE)) return String(all / 100);
  const whole = (all / 100) | 0;
  return whole + HUNDREDTHS[all - 100 * whole];
}

// `d` of a line through screen points; a null begins anew.
function lineThrough(places) {
  let d = "";
  let pen = "M";
  for (const place of places) {
    if (place === null) {
      pen = "M";
      continue;
    }
    d += pen + pixel(place[0]) + " " + pixel(place[1]);
    pen = "L";
  }
  return d;
}

// A button with the words of its hint.
function pushButton(id, word, title, click) {
  const button = element("button", { type: "button", id, title }, word);
  button.addEventListener("click", click);
  return button;
}

// A part of the page that opens and closes, with a heading.
function fold(title, open, ...children) {
  return element("details", { open }, element("summary", {}, title), ...children);
}
