// How a picture is brought nearer, moved, and shown large: by buttons, keys, the wheel with Ctrl, and
// fingers.

import { element, svg } from "./dom.js";
import { shortcut } from "./keys.js";
import { say } from "./words.js";

const NEARER = 1.4;
const ZOOMS = [0.2, 1e5];
const ZOOM_ICONS = { nearer: "M5 12H19M12 5V19", farther: "M5 12H19", all: "M4 9V4H9M15 4H20V9M20 15V20H15M9 20H4V15", large: "M14 4H20V10M10 20H4V14M20 4L13 11M4 20L11 13" };

export class Zoom {
  // `scene()` is the picture in the frame now, `redraw` builds it anew; `letters`: whether those of the keyboard move the view.
  constructor(stage, frame, scene, redraw, letters = true) {
    Object.assign(this, { stage, frame, scene, redraw, fingers: new Map() });
    this.#offer(letters ? "zoom.large" : "zoom.large_plain");
    frame.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    frame.addEventListener("pointerdown", (event) => this.#press(event));
    frame.addEventListener("pointermove", (event) => this.#drag(event));
    for (const end of ["pointerup", "pointercancel"]) frame.addEventListener(end, (event) => this.fingers.delete(event.pointerId));
    shortcut(["+", "="], "+", "zoom.nearer", () => this.by(NEARER));
    shortcut(["-", "−"], "−", "zoom.farther", () => this.by(1 / NEARER));
    shortcut(["0"], "0", "zoom.all", () => this.all());
    if (letters) this.#listenToLetters();
    shortcut(["Escape"], "Esc", "zoom.small", () => (this.isLarge ? this.large(false) : false));
  }

  #listenToLetters() {
    const pan = (x, y) => () => this.pan(0.12 * x * this.frame.clientWidth, 0.12 * y * this.frame.clientHeight);
    for (const [key, x, y, words] of [["w", 0, 1, "zoom.up"], ["a", 1, 0, "zoom.left"], ["s", 0, -1, "zoom.down"], ["d", -1, 0, "zoom.right"]]) shortcut([key], key, words, pan(x, y));
    shortcut(["f"], "f", "zoom.large", () => this.large());
  }

  #offer(large) {
    const button = (name, act, attributes = {}, words = `zoom.${name}`) => {
      const made = element("button", { type: "button", "aria-label": say(words), title: say(words), "data-zoom": name, ...attributes },
        svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: ZOOM_ICONS[name] })));
      made.addEventListener("click", act);
      return made;
    };
    this.largeButton = button("large", () => this.large(), { "aria-pressed": "false" }, large);
    this.frame.append(element("div", { class: "picture-tools", role: "group", "aria-label": say("zoom.title") }, button("nearer", () => this.by(NEARER)),
      button("farther", () => this.by(1 / NEARER)), button("all", () => this.all()), this.largeButton));
  }

  get isLarge() { return this.stage.classList.contains("large"); }

  // The stage alone in the window, or in its place again.
  large(on = !this.isLarge) {
    this.stage.classList.toggle("large", on);
    this.largeButton.setAttribute("aria-pressed", String(on));
    document.documentElement.classList.toggle("one-large", on);
    for (let part = this.stage; part !== document.body; part = part.parentElement) {
      for (const other of part.parentElement.children) if (other !== part && other.tagName !== "DIALOG" && other.id !== "live") other.inert = on;
    }
  }

  // A place of the window in pixels of the picture.
  #at(event) {
    const area = this.frame.getBoundingClientRect();
    return [event.clientX - area.left, event.clientY - area.top];
  }

  // Nearer by `factor`; the point at `at` stays where it is.
  by(factor, at = this.scene()?.view?.middle) {
    const scene = this.scene();
    if (!scene?.view) return;
    const { view, camera } = scene;
    // A picture that was widened for what it shows may be farther than that, and does not leap.
    const wanted = Math.min(ZOOMS[1], Math.max(Math.min(ZOOMS[0], camera.factor), camera.factor * factor));
    const real = wanted / camera.factor;
    const held = view.plane(at);
    camera.shift = camera.shift.map((v, k) => v + (held[k] - view.centre[k]) * (1 - 1 / real));
    camera.factor = wanted;
    this.#show();
  }

  // By pixels to the right and downwards.
  pan(x, y) {
    const scene = this.scene();
    if (!scene?.view) return;
    const { view: { scale }, camera } = scene;
    camera.shift = [camera.shift[0] - x / scale, camera.shift[1] + y / scale];
    this.#show();
  }

  all() {
    Object.assign(this.scene().camera, { factor: 1, shift: [0, 0], widened: false });
    this.#show();
  }

  // Once in a frame, however fast the wheel turns.
  #show() {
    this.scene().view?.look(this.scene().camera);
    this.frame.classList.toggle("moved", this.scene().camera.factor !== 1);
    if (!this.waiting) requestAnimationFrame(() => { this.waiting = false; this.redraw(); });
    this.waiting = true;
  }

  #wheel(event) {
    if (!event.ctrlKey && !this.isLarge) return;
    event.preventDefault();
    this.by(Math.exp(-0.0022 * Math.max(-240, Math.min(240, event.deltaY * (event.deltaMode ? 30 : 1)))), this.#at(event));
  }

  #press(event) {
    if (event.button !== 0 || event.target.closest("[class*=handle], button, .lens")) return;
    this.fingers.set(event.pointerId, this.#at(event));
    if (event.pointerType === "mouse") this.frame.setPointerCapture(event.pointerId);
  }

  // One finger moves the picture as long as it is not whole, two bring it nearer.
  #drag(event) {
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const now = this.#at(event);
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
    this.fingers.set(event.pointerId, now);
    if (!other) {
      if (event.pointerType === "mouse" || this.scene()?.camera.factor !== 1) this.pan(now[0] - before[0], now[1] - before[1]);
      return;
    }
    const apart = (p) => Math.max(8, Math.hypot(p[0] - other[0], p[1] - other[1]));
    this.by(apart(now) / apart(before), [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
  }
}
