// Where a hand draws: strokes, clicks, points that are dragged; and the same by keys.

import { set, svg } from "../dom.js";
import { pathThrough } from "../shapes.js";
import { say } from "../words.js";
import { ARROWS_TO, Cross, stepped } from "./cross.js";
import { arrange, grip } from "./grips.js";
import { Turners } from "./turners.js";

const CLICK = 6;      // pixels within which a stroke is a click

export class Surface {
  // `on`, of places in the plane: begin() of a stroke, resume() where it came to nothing, stroke(points), box(corner, corner)
  // in place of that while `boxes` is set, click(point), drag(i, point), turn(i, degrees), drop() after a drag or a turn,
  // remove(i); `view()` is that of the picture.
  constructor(frame, view, on) {
    Object.assign(this, { view, on, corner: null, boxes: null, handles: [] });
    this.area = svg("rect", { class: "draw-handle", width: "100%", height: "100%", tabindex: 0, role: "button", id: "sheet", "aria-label": say("sketch.sheet") });
    this.ink = svg("path", { class: "sketch-ink" });
    this.cross = new Cross(this.area, view, (place) => this.#put(place));
    this.holder = svg("g");
    this.turners = new Turners(on, (event) => this.view().plane(this.#pixels(event)), (place) => this.view().screen(place));
    this.root = svg("svg", { class: "sketch-surface", role: "group", "aria-label": say("sketch.sheet") }, this.area, this.ink, this.cross.root, this.turners.root, this.holder);
    frame.append(this.root);
    this.area.addEventListener("pointerdown", (event) => this.#press(event));
    this.area.addEventListener("pointermove", (event) => this.#move(event));
    this.area.addEventListener("pointerup", () => this.#lift());
    this.area.addEventListener("pointercancel", () => { this.#stop(); this.on.resume(); });
  }

  #pixels(event) {
    const box = this.root.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #press(event) {
    if (event.button !== 0 || this.stroke) return;
    this.area.setPointerCapture(event.pointerId);
    this.pointer = event.pointerId;
    this.stroke = [this.#pixels(event)];
    this.on.begin();
  }

  #move(event) {
    if (!this.stroke || event.pointerId !== this.pointer) return;
    const events = event.getCoalescedEvents?.() ?? [];
    this.stroke.push(...(events.length ? events : [event]).map((one) => this.#pixels(one)));
    set(this.ink, { d: this.#inkPath(this.stroke[0], this.stroke.at(-1)) });
  }

  #inkPath(from, to) {
    if (this.boxes) return `${pathThrough([from, [to[0], from[1]], to, [from[0], to[1]]])}Z`;
    return pathThrough(this.ruled ? [from, to] : this.stroke);
  }

  #stop() {
    this.stroke = null;
    set(this.ink, { d: "" });
  }

  #lift() {
    const { stroke } = this;
    if (!stroke) return;
    this.#stop();
    const reach = Math.max(...stroke.map((p) => Math.hypot(p[0] - stroke[0][0], p[1] - stroke[0][1])));
    const points = stroke.map((p) => this.view().plane(p));
    if (this.boxes) { if (reach < CLICK) this.on.resume(); else this.on.box(points[0], points.at(-1)); return; }
    if (reach < CLICK) this.on.click(points[0]); else this.on.stroke(points);
  }

  // By keys the corners of a box are put one after another.
  #put(place) {
    if (!this.boxes) { this.on.click(place); return; }
    const { corner } = this;
    this.corner = corner ? null : place;
    if (corner) this.on.box(corner, place);
  }

  #handle(i) {
    const drop = (moved) => { if (moved) this.on.drop(); else this.on.click(this.places[i], i); };
    return grip({ r: 12, role: "button", "data-target": i }, { move: (event) => this.on.drag(i, this.view().plane(this.#pixels(event))), drop, key: (event) => this.#handleKey(event, i) });
  }

  #handleKey(event, i) {
    const step = ARROWS_TO[event.key];
    if (event.key === "Delete") this.on.remove(i);
    if (step) {
      this.on.drag(i, stepped(this.places[i], step, event.shiftKey, this.view()));
      this.on.drop();
    }
    return event.key === "Delete" || step !== undefined;
  }

  // The handles at the targets of the sketch; `angles`: those of its poses, where it has such; `label(i)` says what each is;
  // `straight`: strokes are.
  show(points, angles, label, straight) {
    const { width, height } = this.view();
    set(this.root, { viewBox: `0 0 ${width} ${height}` });
    Object.assign(this, { places: points, ruled: straight || angles !== null });
    this.turners.show(points, angles ?? []);
    arrange(this.handles, this.holder, points.map((point) => this.view().screen(point)), (i) => this.#handle(i),
      (i) => ({ "aria-label": label(i) }));
  }
}
