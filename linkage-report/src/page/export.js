// The drawing and the plots as pictures that need no page: styles become attributes, as every program reads them.

const STYLES = ["stroke-width", "stroke-dasharray", "stroke-linejoin", "stroke-linecap", "font-size", "font-weight", "text-anchor", "paint-order"];
const COLOURS = ["fill", "stroke"];
const SHAPES = new Set(["path", "circle", "rect", "text", "line", "polyline", "polygon", "tspan"]);
// Nodes that only the page needs.
const OF_THE_PAGE = /^(class|style|tabindex|role|aria-.*|data-[xyz])$/;

// Pixels of a picture for one of the page.
const DENSITY = 2;

const paint = element("canvas", { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });

// Red, green, blue and opacity, 0 to 255, of whatever a browser calls a colour.
function componentsOf(colour) {
  paint.clearRect(0, 0, 1, 1);
  paint.fillStyle = colour;
  paint.fillRect(0, 0, 1, 1);
  return [...paint.getImageData(0, 0, 1, 1).data];
}

function hexadecimal(components) {
  return `#${components.map((component) => Math.round(component).toString(16).padStart(2, "0")).join("")}`;
}

// Filters are for browsers: other programs would leave the darker outlines of links as bright as their bodies.
function brightnessOf(style) {
  return Number(/brightness\(([\d.]+)\)/.exec(style.filter)?.[1] ?? 1);
}

function setColour(node, name, style) {
  const colour = style.getPropertyValue(name);
  const [opacity, ...rest] = colour === "none" ? [0] : componentsOf(colour).reverse();
  if (opacity === 0) return set(node, { [name]: "none" });
  const shown = hexadecimal(rest.reverse().map((component) => component * brightnessOf(style)));
  return set(node, { [name]: shown, [`${name}-opacity`]: opacity < 255 ? rounded(opacity / 255, 3) : null });
}

function setStyles(node, style) {
  for (const name of COLOURS) setColour(node, name, style);
  for (const name of STYLES) {
    const value = style.getPropertyValue(name);
    if (value && value !== "none" && value !== "normal") node.setAttribute(name, value);
  }
}

// A copy that looks the same anywhere, or null for a node that is not seen. `pairs` takes the shapes with their copies.
function standing(node, pairs = []) {
  if (node.nodeType === Node.TEXT_NODE) return document.createTextNode(node.data);
  const style = getComputedStyle(node);
  if (style.display === "none" && !node.closest("clipPath, title")) return null;
  const copy = document.createElementNS(SVG, node.localName);
  for (const { name, value } of node.attributes) if (!OF_THE_PAGE.test(name)) copy.setAttribute(name, value);
  if (style.opacity !== "1") copy.setAttribute("opacity", style.opacity);
  if (SHAPES.has(node.localName) && !node.closest("clipPath")) {
    setStyles(copy, style);
    const seen = style.visibility === "visible" && COLOURS.some((name) => copy.getAttribute(name) !== "none");
    if (!seen) return null;
  }
  pairs.push([node, copy]);
  copy.append(...[...node.childNodes].map((child) => standing(child, pairs)).filter((child) => child !== null));
  return copy;
}

// A line of letters below a picture: its height, and the width of a letter.
const NOTE = { line: 18, letter: 7 };

// A picture with its ground. What the page says of changes is below it.
function picturePage(width, height, ground, ...children) {
  const lines = noteLines(Math.floor((width - 24) / NOTE.letter));
  const tall = height + NOTE.line * lines.length + (lines.length > 0 ? 8 : 0);
  const size = { width, height: tall, viewBox: `0 0 ${width} ${tall}` };
  const { fontFamily, color } = getComputedStyle(document.body);
  const [paper, ink] = [ground, color].map((own) => hexadecimal(componentsOf(own).slice(0, 3)));
  const notes = lines.map((line, k) => shape("text", { x: 12, y: height + NOTE.line * (k + 1) - 4, fill: ink, "font-size": 13 }, line));
  return shape("svg", { ...size, "font-family": fontFamily }, shape("title", {}, report.title), shape("rect", { width, height: tall, fill: paper }), ...children, ...notes);
}

// The note, broken between words.
function noteLines(most) {
  const lines = [];
  // A picture may have two designs.
  const text = [saved.note(), kept.words].filter((own) => own !== "").join("; ");
  for (const word of text.split(" ").filter((own) => own !== "")) {
    if (lines.length > 0 && lines.at(-1).length + word.length < most) lines.push(`${lines.pop()} ${word}`);
    else lines.push(word);
  }
  return lines;
}

function textOf(view) {
  return new XMLSerializer().serializeToString(view);
}

function drawingPage(pairs = []) {
  const figure = getComputedStyle(byId("figure"));
  const layers = [...byId("drawing").childNodes].filter((layer) => layer !== drawing.layers.photo).map((layer) => standing(layer, pairs)).filter((layer) => layer !== null);
  return picturePage(Math.round(camera.width), Math.round(camera.height), figure.backgroundColor, ...layers);
}

// The panels below each other, each with its legend.
function plotsPage() {
  const body = getComputedStyle(document.body);
  const ink = hexadecimal(componentsOf(body.color).slice(0, 3));
  const children = [];
  let top = 0;
  for (const panel of plots.panels) {
    const view = standing(panel.view);
    for (const mark of view.querySelectorAll("[data-cursor]")) mark.remove();
    children.push(shape("g", { transform: `translate(0 ${top})` }, ...view.childNodes));
    top += PANEL.height + 8;
    for (const { column, colour, dash } of panel.curves) {
      const probe = byId("panels").appendChild(shape("path", { stroke: colour }));
      const stroke = hexadecimal(componentsOf(getComputedStyle(probe).stroke).slice(0, 3));
      probe.remove();
      children.push(
        shape("path", { d: `M${panelLeft.width} ${top}h26`, fill: "none", stroke, "stroke-width": 2.4, "stroke-dasharray": dash }),
        shape("text", { x: panelLeft.width + 36, y: top + 4, fill: ink, "font-size": 13 }, titled(column.name, panel.unit)),
      );
      top += 18;
    }
    top += 8;
  }
  return picturePage(plots.width, top, body.backgroundColor, ...children);
}

async function imageOf(view) {
  const address = URL.createObjectURL(new Blob([textOf(view)], { type: "image/svg+xml" }));
  const image = new Image();
  image.src = address;
  await image.decode();
  URL.revokeObjectURL(address);
  return image;
}

async function pixelsOf(view) {
  const [width, height] = ["width", "height"].map((side) => Number(view.getAttribute(side)));
  const canvas = element("canvas", { width: DENSITY * width, height: DENSITY * height });
  canvas.getContext("2d").drawImage(await imageOf(view), 0, 0, canvas.width, canvas.height);
  return new Promise((done) => { canvas.toBlob(done, "image/png"); });
}

function pictureButtons() {
  const pages = [...(picture ? [["mechanism", drawingPage]] : []), ...(cycle.view ? [["cyclogram", cyclogramPage]] : []), ["plots", plotsPage]];
  const vector = (name, make) => downloadButton(`${name}.svg`, () => new Blob([textOf(make())], { type: "image/svg+xml" }));
  // In space the order of what is drawn changes with the position.
  const films = picture && !isSpatial() && rowCount > 1 ? [vector("moving", filmPage)] : [];
  if (picture && rowCount > 1) films.push(...(FILM_KIND ? [downloadButton(`moving.${FILM_KIND}`, recordedFilm)] : []), downloadButton("moving.gif", gifFilm));
  return [...pages.flatMap(([name, make]) => [vector(name, make), downloadButton(`${name}.png`, () => pixelsOf(make()))]), ...films,
    ...(picture ? [downloadButton("mechanism.dxf", () => new Blob([dxfNow()], { type: "image/vnd.dxf" }))] : [])];
}
