// Joints that are dragged in the drawing, at the reference position: the text gets their new coordinates.

import { drawnJoints, moved, references } from "./joints.js";

export class Shaping {
  #view;
  #follow;
  #done;
  #refused;
  #held = null;
  isOn = false;

  // `follow` takes a text and its edits while a joint is dragged, `done` is called at the end, `refused` takes the reason why a point stays.
  constructor(view, { follow, done, refused }) {
    this.#view = view;
    this.#follow = follow;
    this.#done = done;
    this.#refused = refused;
  }

  // The frame's document keeps its listeners while reports change in it.
  start() {
    const { document } = this.#view;
    const options = { capture: true };
    document.addEventListener("pointerdown", (event) => this.#press(event), options);
    document.addEventListener("pointermove", (event) => this.#move(event), options);
    for (const end of ["pointerup", "pointercancel"]) document.addEventListener(end, (event) => this.#release(event), options);
    document.addEventListener("click", (event) => this.isOn && event.target.closest?.(".point") && event.stopPropagation(), options);
    document.addEventListener("keydown", (event) => this.#key(event), options);
  }

  get isHeld() {
    return this.#held !== null;
  }

  // The reason why no joint can be dragged, with advice; null if there is one.
  refusal() {
    const { handle } = this.#view;
    if (handle === null) return "There is no mechanism to change yet.";
    if (!handle.isPlane) return "Joints in space cannot be dragged on a screen: change their coordinates in the text.";
    if (drawnJoints(handle.source).size > 0) return null;
    return "This text has no `joint name = (x, y)`: its points come from dimensions. Pull a pivot or a bar of the drawing: its dimension in the text changes.";
  }

  turn(on) {
    this.isOn = on;
    this.mark();
  }

  // Marks the joints that can be dragged, and goes to where they are drawn.
  mark() {
    const { document, handle } = this.#view;
    document.body.classList.toggle("shaping", this.isOn);
    if (!this.isOn || handle === null) return;
    handle.goToReference();
    const joints = drawnJoints(handle.source);
    for (const point of document.querySelectorAll(".point")) point.classList.toggle("drawn", joints.has(point.dataset.point));
  }

  #grasp(name) {
    const { handle } = this.#view;
    if (!this.isOn || !handle?.isPlane) return null;
    const joint = drawnJoints(handle.source).get(name);
    return joint === undefined ? null : { joint, source: handle.source, unit: handle.unit, pixel: handle.pixel() };
  }

  #whyNot(name) {
    const joints = [...drawnJoints(this.#view.handle?.source ?? "").keys()];
    return `${name} is not drawn as a joint with two numbers. Joints that can be dragged: ${joints.join(", ")}.`;
  }

  #press(event) {
    const point = event.target.closest?.(".point");
    const held = event.button === 0 && point ? this.#grasp(point.dataset.point) : null;
    if (held === null) return this.isOn && point && this.#refused(this.#whyNot(point.dataset.point));
    event.preventDefault();
    event.stopPropagation();
    const from = this.#view.handle.placeUnder(event);
    this.#held = { ...held, from, pointer: event.pointerId, moved: false };
  }

  #move(event) {
    const held = this.#held;
    if (held === null || event.pointerId !== held.pointer) return;
    event.preventDefault();
    event.stopPropagation();
    const to = this.#view.handle?.placeUnder(event);
    if (to === undefined) return;
    held.moved = true;
    this.#put(held, to.map((x, k) => x - held.from[k]));
  }

  #put({ joint, source, unit, pixel }, way) {
    const edits = moved(joint, way, unit, pixel);
    if (edits !== null) this.#follow(source, [...edits, ...references(source, edits, unit)]);
  }

  #release(event) {
    const held = this.#held;
    if (held === null || event.pointerId !== held.pointer) return;
    event.stopPropagation();
    this.#held = null;
    this.#done();
  }

  // Arrow keys move the joint that has the focus, by some pixels.
  #key(event) {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const name = event.target.closest?.(".point")?.dataset.point;
    const held = way && name ? this.#grasp(name) : null;
    if (held === null || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const step = held.pixel * (event.shiftKey ? 10 : 2);
    this.#put(held, way.map((x) => x * step));
    this.#done();
  }
}
