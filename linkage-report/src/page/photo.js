// A photograph behind the drawing, to scale for tracing. It is in the page only: no file that the page saves has it.

// The share of the drawing that a photograph has at first.
const PHOTO_SHARE = 0.8;

// `corner` is its upper left corner in the mechanism's place, `scale` the length of a pixel, `marks` the ends of a known distance. `press` has what the
// next presses on the drawing mean.
const photo = { image: null, size: [1, 1], corner: [0, 0], scale: 1, marks: [], press: null, held: null };

function startPhoto() {
  if (isSpatial()) return;
  const file = element("input", { type: "file", accept: "image/*", hidden: true });
  const button = element("button", { type: "button", id: "photo", title: "A photograph behind the drawing, to scale" }, "Photograph");
  button.addEventListener("click", () => file.click());
  file.addEventListener("change", () => file.files.length > 0 && takePhoto(file.files[0]));
  byId("hint").append(" ", button, file);
  byId("hint").after(photoLine());
  const view = byId("drawing");
  // Before whatever else a press means.
  view.addEventListener("pointerdown", photoPressed, { capture: true });
  view.addEventListener("pointermove", photoMoved, { capture: true });
  view.addEventListener("pointerup", () => (photo.held = null));
  camera.listeners.push(drawPhoto);
}

function photoLine() {
  const opacity = element("input", { type: "range", min: 0, max: 1, step: "any", value: 0.5, "aria-label": "Opacity of the photograph" });
  opacity.addEventListener("input", () => set(photo.image, { opacity: opacity.value }));
  const length = element("input", { type: "text", id: "photo-length", size: 8, autocomplete: "off", disabled: true, "aria-label": `Distance of the two points in ${picture.unit}` });
  length.addEventListener("change", () => scalePhoto(Number(length.value.replace(",", "."))));
  const press = (kind) => () => pressPhoto(photo.press === kind ? null : kind);
  return element("p", { id: "photo-line", hidden: true }, opacity,
    pushButton("photo-scale", "Scale", "Two clicks on points of known distance", () => { photo.marks = []; drawPhoto(); press("scale")(); }),
    length, ` ${picture.unit} `, pushButton("photo-move", "Move", "Drag the photograph", press("move")), pushButton("photo-remove", "Remove", "Without the photograph", removePhoto),
    element("span", { id: "photo-says", role: "status" }));
}

function pressPhoto(kind) {
  photo.press = kind;
  for (const own of ["scale", "move"]) set(byId(`photo-${own}`), { "aria-pressed": String(kind === own) });
  const words = { scale: `Click two points whose distance you know: ${2 - photo.marks.length} to go.`, move: "Drag it to its place." };
  byId("photo-says").textContent = words[kind] ?? "";
}

async function takePhoto(file) {
  removePhoto();
  const address = URL.createObjectURL(file);
  const image = new Image();
  image.src = address;
  try {
    await image.decode();
  } catch {
    byId("photo-line").hidden = false;
    byId("photo-says").textContent = `${file.name} is no picture that the browser shows.`;
    return;
  }
  const { naturalWidth: width, naturalHeight: height } = image;
  const shown = PHOTO_SHARE * Math.min(camera.width / width, camera.height / height);
  Object.assign(photo, { size: [width, height], scale: shown / cameraScale() });
  photo.corner = placeUnder([(camera.width - shown * width) / 2, (camera.height - shown * height) / 2]);
  photo.image = shape("image", { href: address, opacity: 0.5, preserveAspectRatio: "none" });
  byId("photo-line").hidden = false;
  byId("photo-line").querySelector("input").value = 0.5;
  drawPhoto();
  pressPhoto("scale");
}

function removePhoto() {
  if (photo.image !== null) URL.revokeObjectURL(photo.image.getAttribute("href"));
  Object.assign(photo, { image: null, marks: [] });
  byId("photo-line").hidden = true;
  byId("photo-length").disabled = true;
  pressPhoto(null);
  drawPhoto();
}

function drawPhoto() {
  if (photo.image === null) return drawing.layers.photo.replaceChildren();
  const [x, y] = project(photo.corner);
  const [width, height] = photo.size.map((side) => side * photo.scale * cameraScale());
  set(photo.image, { x, y, width, height });
  const marks = photo.marks.map((mark) => {
    const [u, v] = project(mark).map(pixel);
    return shape("path", { class: "mark", d: `M${u - 8} ${v}h16M${u} ${v - 8}v16` });
  });
  drawing.layers.photo.replaceChildren(photo.image, ...marks);
}

function photoPressed(event) {
  if (photo.press === null || event.button !== 0) return;
  event.stopPropagation();
  const place = placeUnder(onDrawing(event));
  if (photo.press === "move") {
    photo.held = place;
    byId("drawing").setPointerCapture(event.pointerId);
    return;
  }
  photo.marks.push(place);
  const isMeasured = photo.marks.length === 2;
  pressPhoto(isMeasured ? null : "scale");
  drawPhoto();
  const length = byId("photo-length");
  length.disabled = !isMeasured;
  if (!isMeasured) return;
  length.value = rounded(distance(...photo.marks), 4);
  byId("photo-says").textContent = "Type their distance.";
  // After the browser has taken the press.
  setTimeout(() => length.select());
}

function photoMoved(event) {
  if (photo.held === null) return;
  event.stopPropagation();
  const place = placeUnder(onDrawing(event));
  shiftPhoto((own) => own.map((x, k) => x + place[k] - photo.held[k]));
  photo.held = place;
}

function shiftPhoto(move) {
  photo.corner = move(photo.corner);
  photo.marks = photo.marks.map(move);
  drawPhoto();
}

// The first point stays.
function scalePhoto(length) {
  const [fixed, other] = photo.marks;
  const factor = length / distance(fixed, other);
  if (!(factor > 0 && Number.isFinite(factor))) {
    byId("photo-says").textContent = "The distance is a positive number.";
    return;
  }
  photo.scale *= factor;
  shiftPhoto((own) => own.map((x, k) => fixed[k] + factor * (x - fixed[k])));
  byId("photo-says").textContent = "";
}
