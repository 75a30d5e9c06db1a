// The sheet on which a hand builds: presses, drags and clicks; and the same by keys.

import { set, svg } from "../dom.js";
import { round } from "../shapes.js";
import { say } from "../words.js";
import { ARROWS_TO, Cross } from "../sketch/cross.js";
import { arrange } from "../sketch/grips.js";

const STILL_PIXELS = 5;
const REACH = { mouse: 11, pen: 13, touch: 20 };   // pixels

// Handles for the keyboard at parts of one kind, "joint" or "load", each with its name in `attribute`.
class PartHandles {
  constructor(kind, on, attribute) { Object.assign(this, { kind, on, attribute, handles: [], names: [], root: svg("g") }); }

  #handle(i) {
    const handle = svg("circle", { class: "build-handle", r: 12, tabindex: 0, role: "button" }), part = () => ({ [this.kind]: this.names[i] });
    handle.addEventListener("focus", () => this.on.focus(part()));
    handle.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !this.on.key(part(), event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    return handle;
  }

  // `parts`: {name, at, label}, `at` in pixels.
  show(parts) {
    this.names = parts.map(({ name }) => name);
    arrange(this.handles, this.root, parts.map(({ at }) => at), (i) => this.#handle(i), (i) => ({ [this.attribute]: this.names[i], "aria-label": parts[i].label }));
  }

  of(name) { return this.handles[this.names.indexOf(name)]; }
}

export class Hand {
  // `on`, of places in the plane and a reach there: press, move(place, reach, pixels since the last), lift(place, reach, moved), hover(place,
  // reach, by keys), put(place, reach) by keys, cancel(), abandon() of what a finger began before a
  // second one came, pinch(factor, at, way) of the two in pixels of the picture, leave(), carry(event) of a key, whether it has used it; of parts {joint} or {load}: key(part, event), whether it has used the key, and focus(part). `view()` is that of the picture.
  constructor(frame, view, on) {
    Object.assign(this, { view, on, joints: new PartHandles("joint", on, "data-joint"), loads: new PartHandles("load", on, "data-load-handle"), pointer: null, fingers: new Map(), isPinched: false });
    this.area = svg("rect", { class: "draw-handle", width: "100%", height: "100%", tabindex: 0, role: "button", id: "sheet", "aria-label": say("build.sheet") });
    this.area.addEventListener("keydown", (event) => this.#carry(event));
    this.area.addEventListener("blur", () => on.leave());
    this.cross = new Cross(this.area, view, (place) => on.put(place, this.#reach("mouse")), (place) => on.hover(place, this.#reach("mouse"), true));
    this.line = svg("path", { class: "build-preview" });
    this.ring = svg("circle", { class: "build-ring", r: 11, hidden: "" });
    this.root = svg("svg", { class: "sketch-surface", role: "group", "aria-label": say("build.sheet") }, this.area, this.line, this.ring, this.cross.root, this.joints.root, this.loads.root);
    frame.append(this.root);
    this.area.addEventListener("pointerdown", (event) => this.#press(event));
    this.area.addEventListener("pointermove", (event) => this.#move(event));
    this.area.addEventListener("pointerup", (event) => this.#lift(event));
    this.area.addEventListener("pointercancel", (event) => { this.pointer = null; this.#raise(event); on.cancel(); });
  }

  #pixels(event) {
    const box = this.root.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #reach(pointer) { return (REACH[pointer] ?? REACH.mouse) / this.view().scale; }

  #press(event) {
    if (event.button !== 0) return;
    if (event.pointerType === "touch") this.fingers.set(event.pointerId, this.#pixels(event));
    if (this.fingers.size > 1) this.#beginPinch();
    if (this.pointer !== null || this.isPinched) return;
    this.area.setPointerCapture(event.pointerId);
    this.area.focus({ preventScroll: true });
    this.cross.hide();
    Object.assign(this, { pointer: event.pointerId, start: this.#pixels(event), last: this.#pixels(event), moved: false });
    this.on.press(this.view().plane(this.start), this.#reach(event.pointerType));
  }

  // A second finger moves the view instead of what the first one began.
  #beginPinch() {
    if (this.pointer !== null) this.on.abandon();
    Object.assign(this, { pointer: null, isPinched: true });
  }

  // Until all fingers are raised.
  #raise({ pointerId }) {
    this.fingers.delete(pointerId);
    if (this.fingers.size === 0) this.isPinched = false;
  }

  #pinch({ pointerId }, now) {
    const before = this.fingers.get(pointerId), other = [...this.fingers].find(([id]) => id !== pointerId)?.[1];
    this.fingers.set(pointerId, now);
    if (!other) return;
    const apart = (p) => Math.max(8, Math.hypot(p[0] - other[0], p[1] - other[1]));
    this.on.pinch(apart(now) / apart(before), now.map((x, k) => (x + other[k]) / 2), now.map((x, k) => (x - before[k]) / 2));
  }

  // Unless the cross is out, arrows move what is selected.
  #carry(event) {
    if (!this.cross.root.hasAttribute("hidden") || event.ctrlKey || event.altKey || event.metaKey || !this.on.carry(event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  #move(event) {
    const at = this.#pixels(event), reach = this.#reach(event.pointerType);
    if (this.isPinched) { if (this.fingers.has(event.pointerId)) this.#pinch(event, at); return; }
    if (this.fingers.has(event.pointerId)) this.fingers.set(event.pointerId, at);
    if (this.pointer === null) { this.on.hover(this.view().plane(at), reach); return; }
    if (event.pointerId !== this.pointer) return;
    this.moved ||= Math.hypot(at[0] - this.start[0], at[1] - this.start[1]) > STILL_PIXELS;
    if (this.moved) this.on.move(this.view().plane(at), reach, at.map((x, k) => x - this.last[k]));
    this.last = at;
  }

  #lift(event) {
    this.#raise(event);
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

  // A handle for the keyboard at each of `joints` and `loads`, {name, at, label} where it is seen.
  show(joints, loads) {
    const { width, height } = this.view(), placed = (parts) => parts.map((part) => ({ ...part, at: this.view().screen(part.at) }));
    set(this.root, { viewBox: `0 0 ${width} ${height}` });
    this.joints.show(placed(joints));
    this.loads.show(placed(loads));
  }

  // Of a joint; the sheet where there is none of the name.
  focus(name) { (this.joints.of(name) ?? this.area).focus({ preventScroll: true }); }
}

// The way that an arrow goes, in steps; undefined of another key.
export const stepOf = ({ key, shiftKey }) => ARROWS_TO[key]?.map((x) => (shiftKey ? 5 : 1) * x);
