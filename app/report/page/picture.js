// The frame of a moving drawing: its view of the plane, its scale, and what can be dragged.

import { set, svg } from "./dom.js";
import { number } from "./format.js";
import { round } from "./shapes.js";
import { boxOf, diagonal, View } from "./view.js";
import { say } from "./words.js";

export class Picture {
  // `onDrag` is called with the drive coordinate that a handle is dragged to.
  constructor(frame, label, onDrag) {
    this.frame = frame;
    this.root = svg("svg", { role: "img", "aria-label": label });
    // What lies over the drawing and outlives it when it is drawn anew.
    this.front = svg("svg", { class: "front", "aria-hidden": "true" });
    frame.append(this.root, this.front);
    this.onDrag = onDrag;
    this.camera = { factor: 1, shift: [0, 0] };
  }

  // Looks from as far as shows `points` too. Returns whether anything changed.
  include(points) {
    const { view } = this;
    const [left, top] = view.plane([view.middle[0] - view.width / 2 + view.margin, view.margin]);
    const [right, bottom] = view.plane([view.width - view.margin, 2 * view.middle[1] - view.margin]);
    const own = boxOf([[left, bottom], [right, top]]);
    const box = boxOf([[left, bottom], [right, top], ...points]);
    if (diagonal(box) <= 1.0001 * diagonal(own)) return false;
    const fitting = new View(box, view.width, view.height, view.margin);
    Object.assign(this.camera, { factor: fitting.scale / view.whole.scale, shift: fitting.centre.map((v, k) => v - view.whole.centre[k]), widened: true });
    return true;
  }

  // The points of the plane whose ways are followed, where the drive is at `drive`.
  marksAt() { return []; }

  // An empty picture of the part `box` of the plane, perhaps with a margin of so many pixels; without one it says why there is none.
  clear(box, why, margin) {
    const [width, height] = [this.frame.clientWidth || 600, this.frame.clientHeight || 420];
    this.root.replaceChildren();
    for (const part of [this.root, this.front]) set(part, { viewBox: `0 0 ${width} ${height}` });
    this.view = box ? new View(box, width, height, margin) : null;
    this.view?.look(this.camera);
    if (!box) this.root.append(svg("text", { x: width / 2, y: height / 2, class: "joint-name" }, why));
  }

  remove() { for (const part of [this.root, this.front]) part.remove(); }

  scaleBar() {
    const { length, pixels } = this.view.scaleBar();
    const [x, y] = [14, this.view.height - 14];
    return svg("g", {}, svg("path", { class: "scale-line", d: `M${x} ${y - 4}v4h${round(pixels)}v-4` }),
      svg("text", { class: "scale-text", x: x + 2, y: y - 8 }, say("picture.scale", { n: length, length: number(length) })));
  }

  // `driveFor` turns a point of the plane into the drive coordinate, or null.
  listen(handle, driveFor) {
    const drag = (event) => {
      const area = this.root.getBoundingClientRect();
      const scale = this.view.width / area.width;
      const at = [(event.clientX - area.left) * scale, (event.clientY - area.top) * scale];
      const drive = driveFor(this.view.plane(at));
      if (drive !== null) this.onDrag(drive);
    };
    set(handle, { style: "touch-action: none" });
    handle.addEventListener("pointerdown", (event) => { event.preventDefault(); handle.setPointerCapture(event.pointerId); drag(event); });
    handle.addEventListener("pointermove", (event) => { if (handle.hasPointerCapture(event.pointerId)) drag(event); });
  }
}
