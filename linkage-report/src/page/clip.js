// The moving drawing as pixels: a film that the browser records while it runs, and a GIF.

// Pictures of a second, and the most of a GIF.
const CLIP = { film: 25, gif: 12.5, most: 120 };

// Seconds of a cycle, there and back where it is not a whole turn.
function clipSeconds() {
  return player.period * (input.periodic ? 1 : 2);
}

// The row at a share of the cycle.
function clipRow(share) {
  const part = input.periodic ? share : 1 - Math.abs(1 - 2 * share);
  return nearestRow(input.values[0] + part * span());
}

// A canvas, and a function that draws a row on it: a row where the mechanism is not whole leaves it as it is.
function clipCanvas() {
  const first = wholeRows(filmRows())[0] ?? position.row;
  placeAll(first);
  const pairs = [];
  const page = drawingPage(pairs);
  const canvas = element("canvas", { width: page.getAttribute("width"), height: page.getAttribute("height") });
  const paint = canvas.getContext("2d", { willReadFrequently: true });
  const sheetAt = (row) => {
    placeAll(row);
    const isWhole = byId("impossible").hidden;
    // In the plane nothing but places changes; in space the order of what is drawn does, too.
    if (!isSpatial()) for (const [node, copy] of pairs) for (const name of [...MOVING, "transform"]) set(copy, { [name]: node.getAttribute(name) });
    const sheet = isSpatial() ? drawingPage() : page;
    placeAll(position.row);
    return isWhole || row === first ? sheet : null;
  };
  const show = async (row) => {
    const sheet = sheetAt(row);
    if (sheet !== null) paint.drawImage(await imageOf(sheet), 0, 0);
  };
  placeAll(position.row);
  return { canvas, paint, show, first };
}

// The most pictures until the browser records, milliseconds without data after which it has recorded all, and the most quarters of these: Firefox
// goes on with a still picture.
const FILM_WAITS = 100;
const FILM_REST = 1500;
const FILM_RESTS = 20;

// The kind of film that the browser records; none if it does not.
const FILM_KIND = ["webm", "mp4"].find((kind) => globalThis.MediaRecorder?.isTypeSupported(`video/${kind}`));

// As long as a cycle takes.
async function recordedFilm() {
  const { canvas, show, first } = clipCanvas();
  await show(first);
  const parts = [];
  const wait = (milliseconds) => new Promise((done) => { setTimeout(done, milliseconds); });
  // A canvas gives its pictures with those of the screen.
  const shown = () => new Promise((done) => { requestAnimationFrame(done); });
  const stream = canvas.captureStream(CLIP.film);
  const recorder = new MediaRecorder(stream, { mimeType: `video/${FILM_KIND}`, videoBitsPerSecond: 4e6 });
  let last = 0;
  recorder.addEventListener("dataavailable", ({ data }) => {
    parts.push(data);
    if (data.size > 0) last = performance.now();
  });
  const stopped = new Promise((done) => { recorder.addEventListener("stop", done); });
  recorder.start(1);
  // Pictures are lost until the browser is ready to record, which its first data show.
  for (let k = 0; k < FILM_WAITS && parts.every(({ size }) => size === 0); k += 1) {
    await show(first);
    await shown();
  }
  const begin = performance.now();
  const seconds = clipSeconds();
  for (let now = 0; now < seconds; now = (performance.now() - begin) / 1000) {
    await show(clipRow(now / seconds));
    const next = Math.ceil(((performance.now() - begin) * CLIP.film) / 1000) / CLIP.film;
    await wait(begin + 1000 * next - performance.now());
    await shown();
  }
  // The last pictures are still on their way.
  last = performance.now();
  for (let k = 0; k < FILM_RESTS && performance.now() - last < FILM_REST; k += 1) await wait(FILM_REST / 4);
  recorder.stop();
  await stopped;
  return new Blob(parts, { type: `video/${FILM_KIND}` });
}

async function gifFilm() {
  const { canvas: { width, height }, paint, show } = clipCanvas();
  const count = Math.max(1, Math.min(CLIP.most, Math.round(CLIP.gif * clipSeconds())));
  const pixelsAt = async (share) => {
    await show(clipRow(share));
    return new Uint32Array(paint.getImageData(0, 0, width, height).data.buffer);
  };
  const samples = [await pixelsAt(0), await pixelsAt(1 / 3), await pixelsAt(2 / 3)];
  const gif = startGif(width, height, samples);
  for (let k = 0; k < count; k += 1) gif.add(await pixelsAt(k / count), Math.round((100 * clipSeconds()) / count));
  return gif.end();
}
