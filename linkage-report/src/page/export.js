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

// A copy that looks the same anywhere, or null for a node that is not seen.
function standing(node) {
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
  copy.append(...[...node.childNodes].map(standing).filter((child) => child !== null));
  return copy;
}

// A picture with its ground.
function picturePage(width, height, ground, ...children) {
  const size = { width, height, viewBox: `0 0 ${width} ${height}` };
  const { fontFamily } = getComputedStyle(document.body);
  const paper = shape("rect", { width, height, fill: hexadecimal(componentsOf(ground).slice(0, 3)) });
  return shape("svg", { ...size, "font-family": fontFamily }, shape("title", {}, report.title), paper, ...children);
}

function textOf(view) {
  return new XMLSerializer().serializeToString(view);
}

function drawingPage() {
  const figure = getComputedStyle(byId("figure"));
  const layers = [...byId("drawing").childNodes].map(standing).filter((layer) => layer !== null);
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

async function pixelsOf(view) {
  const [width, height] = ["width", "height"].map((side) => Number(view.getAttribute(side)));
  const address = URL.createObjectURL(new Blob([textOf(view)], { type: "image/svg+xml" }));
  const image = new Image();
  image.src = address;
  await image.decode();
  const canvas = element("canvas", { width: DENSITY * width, height: DENSITY * height });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(address);
  return new Promise((done) => { canvas.toBlob(done, "image/png"); });
}

function pictureButtons() {
  const pages = [...(picture ? [["mechanism", drawingPage]] : []), ...(cycle.view ? [["cyclogram", cyclogramPage]] : []), ["plots", plotsPage]];
  const pictures = pages.flatMap(([name, make]) => [
    downloadButton(`${name}.svg`, () => new Blob([textOf(make())], { type: "image/svg+xml" })),
    downloadButton(`${name}.png`, () => pixelsOf(make())),
  ]);
  return [...pictures, ...(picture ? [downloadButton("mechanism.dxf", () => new Blob([dxfText()], { type: "image/vnd.dxf" }))] : [])];
}
