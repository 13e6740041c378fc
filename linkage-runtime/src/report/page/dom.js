// Elements of the page and of drawings, made and changed in one line each.

const SVG = "http://www.w3.org/2000/svg";

function byId(id) {
  return document.getElementById(id);
}

// Attributes; those that are null or false go away.
function set(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === false) node.removeAttribute(name);
    else node.setAttribute(name, value === true ? "" : value);
  }
  return node;
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

// Attributes of drawings: no more digits than a screen shows.
function pixel(value) {
  return Math.round(value * 100) / 100;
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

// A part of the page that opens and closes, with a heading.
function fold(title, open, ...children) {
  return element("details", { open }, element("summary", {}, title), ...children);
}
