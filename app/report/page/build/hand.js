// The sheet on which a hand builds: presses, drags and clicks; and the same by keys.

import { set, svg } from "../dom.js";
import { round } from "../shapes.js";
import { say } from "../words.js";
import { ARROWS_TO, Cross } from "../sketch/cross.js";
import { arrange } from "../sketch/grips.js";

const STILL_PIXELS = 5;
const REACH = { mouse: 11, pen: 13, touch: 20 };   // pixels

export class Hand {
  // `on`, of places in the plane and a reach there: press, move(place, reach, pixels since the last), lift(place, reach, moved), hover(place,
  // reach, by keys), put(place, reach) by keys, cancel(), leave(), carry(event) of a key, whether it has used it; of joints by name: key(name, event), whether it has used the key, and focus(name). `view()` is that of the picture.
  constructor(frame, view, on) {
    Object.assign(this, { view, on, handles: [], names: [], pointer: null });
    this.area = svg("rect", { class: "draw-handle", width: "100%", height: "100%", tabindex: 0, role: "button", id: "sheet", "aria-label": say("build.sheet") });
    this.area.addEventListener("keydown", (event) => this.#carry(event));
    this.area.addEventListener("blur", () => on.leave());
    this.cross = new Cross(this.area, view, (place) => on.put(place, this.#reach("mouse")), (place) => on.hover(place, this.#reach("mouse"), true));
    this.line = svg("path", { class: "build-preview" });
    this.ring = svg("circle", { class: "build-ring", r: 11, hidden: "" });
    this.holder = svg("g");
    this.root = svg("svg", { class: "sketch-surface", role: "group", "aria-label": say("build.sheet") }, this.area, this.line, this.ring, this.cross.root, this.holder);
    frame.append(this.root);
    this.area.addEventListener("pointerdown", (event) => this.#press(event));
    this.area.addEventListener("pointermove", (event) => this.#move(event));
    this.area.addEventListener("pointerup", (event) => this.#lift(event));
    this.area.addEventListener("pointercancel", () => { this.pointer = null; on.cancel(); });
  }

  #pixels(event) {
    const box = this.root.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #reach(pointer) { return (REACH[pointer] ?? REACH.mouse) / this.view().scale; }

  #press(event) {
    if (event.button !== 0 || this.pointer !== null) return;
    this.area.setPointerCapture(event.pointerId);
    this.area.focus({ preventScroll: true });
    this.cross.hide();
    Object.assign(this, { pointer: event.pointerId, start: this.#pixels(event), last: this.#pixels(event), moved: false });
    this.on.press(this.view().plane(this.start), this.#reach(event.pointerType));
  }

  // Unless the cross is out, arrows move what is selected.
  #carry(event) {
    if (!this.cross.root.hasAttribute("hidden") || event.ctrlKey || event.altKey || event.metaKey || !this.on.carry(event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  #move(event) {
    const at = this.#pixels(event), reach = this.#reach(event.pointerType);
    if (this.pointer === null) { this.on.hover(this.view().plane(at), reach); return; }
    if (event.pointerId !== this.pointer) return;
    this.moved ||= Math.hypot(at[0] - this.start[0], at[1] - this.start[1]) > STILL_PIXELS;
    if (this.moved) this.on.move(this.view().plane(at), reach, at.map((x, k) => x - this.last[k]));
    this.last = at;
  }

  #lift(event) {
    if (event.pointerId !== this.pointer) return;
    this.pointer = null;
    this.on.lift(this.view().plane(this.#pixels(event)), this.#reach(event.pointerType), this.moved);
  }

  // A line from a place to a spot, with a ring where it meets something; null: none. `placeOf(spot)`: of a joint.
  preview(from, to, placeOf) {
    const place = from && (to.at ?? placeOf(to) ?? from);
    const [p, q] = from ? [from, place].map((one) => this.view().screen(one)) : [];
    set(this.line, { d: p ? `M${p.map(round).join(" ")}L${q.map(round).join(" ")}` : "" });
    this.ring.toggleAttribute("hidden", !(p && (to.joint !== undefined || to.link !== undefined)));
    if (p) set(this.ring, { cx: round(q[0]), cy: round(q[1]) });
  }

  #handle(i) {
    const handle = svg("circle", { class: "build-handle", r: 12, tabindex: 0, role: "button" });
    handle.addEventListener("focus", () => this.on.focus(this.names[i]));
    handle.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !this.on.key(this.names[i], event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    return handle;
  }

  // A handle for the keyboard at each of `joints`, {name, at} where it is seen.
  show(joints) {
    const { width, height } = this.view();
    set(this.root, { viewBox: `0 0 ${width} ${height}` });
    this.names = joints.map(({ name }) => name);
    arrange(this.handles, this.holder, joints.map(({ at }) => this.view().screen(at)), (i) => this.#handle(i),
      (i) => ({ "data-joint": this.names[i], "aria-label": say("build.joint", { name: this.names[i] }) }));
  }

  focus(name) { (this.handles[this.names.indexOf(name)] ?? this.area).focus({ preventScroll: true }); }
}

// The way that an arrow goes, in steps; undefined of another key.
export const stepOf = ({ key, shiftKey }) => ARROWS_TO[key]?.map((x) => (shiftKey ? 5 : 1) * x);
