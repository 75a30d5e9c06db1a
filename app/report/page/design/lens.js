// A magnifier: beside a target, that target, what is reached of it and the curve between, at a scale
// at which the error is seen.

import { element, set, svg } from "../dom.js";
import { degreesShort, number } from "../format.js";
import { RADIANS } from "../sampling.js";
import { arrowPath, pathThrough, pathWithGaps, round } from "../shapes.js";
import { SCALE_ROOM, View } from "../view.js";
import { say } from "../words.js";
import { turnInto } from "./model.js";

// The part of the lens that an error takes, and the steps by which its scale is changed.
const ERROR_SHARE = 0.32;
const LENS_STEP = 2;

// Errors and angles, in degrees, below which the drawing cannot show them.
const NO_ERROR = 1e-11;
const NO_TURN = 1e-4;

export class Lens {
  constructor(frame) {
    Object.assign(this, { frame, name: "lens", words: "lens.title", key: "m", index: 0, extra: 1 });
    this.picture = svg("svg", { role: "img" });
    this.caption = element("p", { role: "status", "aria-live": "polite" });
    const button = (text, words, act) => {
      const made = element("button", { type: "button", "aria-label": say(words), title: say(words) }, text);
      made.addEventListener("click", act);
      return made;
    };
    this.root = element("div", { class: "lens", role: "group", tabindex: "0", hidden: "", "aria-label": say("lens.label") }, this.picture, this.caption,
      element("div", { class: "lens-buttons" }, button("‹", "lens.previous", () => this.step(-1)), button("›", "lens.next", () => this.step(1)),
        button("−", "lens.weaker", () => this.magnify(1 / LENS_STEP)), button("+", "lens.stronger", () => this.magnify(LENS_STEP))));
    this.sign = svg("g", { class: "lens-sign" });
    frame.append(this.root);
    this.root.addEventListener("keydown", (event) => this.#answer(event));
    frame.addEventListener("pointermove", (event) => { if (event.pointerType === "mouse" && !event.buttons) this.#near(event, 16); });
    frame.addEventListener("pointerdown", (event) => this.#near(event, 30));
  }

  // `scene.aims`: targets with what is reached of them, `{ name, target, reached, deg, reachedDeg,
  // curve(count, halfWidth) }`; `scene.wanted`: a closed curve, in part or empty.
  available(scene) { return Boolean(scene.aims?.length); }

  build(scene) {
    if (this.scene !== scene) Object.assign(this, { scene, index: this.#worst(scene.aims), extra: 1 });
    this.index = Math.min(this.index, scene.aims.length - 1);
    this.#draw();
  }

  clear() { this.sign.remove(); }
  move() {}
  legend() { return []; }

  #worst(aims) { return aims.reduce((worst, aim, i) => (Lens.error(aim) > Lens.error(aims[worst]) ? i : worst), 0); }
  static error({ target, reached }) { return Math.hypot(reached[0] - target[0], reached[1] - target[1]); }

  step(by) {
    this.index = (this.index + by + this.scene.aims.length) % this.scene.aims.length;
    this.extra = 1;
    this.#draw();
  }

  magnify(by) {
    this.extra = Math.min(1e4, Math.max(1e-4, this.extra * by));
    this.#draw();
  }

  #answer(event) {
    const act = { ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1), ArrowUp: () => this.magnify(LENS_STEP), ArrowDown: () => this.magnify(1 / LENS_STEP) }[event.key];
    if (!act || event.altKey || event.ctrlKey || event.metaKey) return;
    act();
    event.preventDefault();
    event.stopPropagation();
  }

  // Goes to the target within `reach` pixels of the pointer.
  #near(event, reach) {
    if (this.root.hidden || !this.scene?.view || event.target.closest(".lens")) return;
    const area = this.frame.getBoundingClientRect();
    const away = this.scene.aims.map(({ target }) => {
      const [x, y] = this.scene.view.screen(target);
      return Math.hypot(x - (event.clientX - area.left), y - (event.clientY - area.top));
    });
    const nearest = away.indexOf(Math.min(...away));
    if (away[nearest] > reach || nearest === this.index) return;
    Object.assign(this, { index: nearest, extra: 1 });
    this.#draw();
  }

  // Where the error takes a fair part of the lens; of none, twenty times as near as the picture.
  #scale(error, size) {
    const { scale, width } = this.scene.view;
    const fit = error > (NO_ERROR * width) / scale ? Math.max(2 * scale, (ERROR_SHARE * size) / error) : 20 * scale;
    return this.extra * fit;
  }

  #draw() {
    const { scene } = this;
    const aim = scene.aims[this.index];
    const { width, height } = scene.view;
    const size = Math.round(Math.min(260, Math.max(130, 0.42 * Math.min(width, height))));
    const error = Lens.error(aim);
    const scale = this.#scale(error, size);
    const half = size / 2 / scale;
    const middle = [0, 1].map((k) => (aim.target[k] + aim.reached[k]) / 2);
    const view = new View({ x0: middle[0] - half, x1: middle[0] + half, y0: middle[1] - half, y1: middle[1] + half }, size, size + SCALE_ROOM, 0);
    set(this.picture, { viewBox: `0 0 ${size} ${size}`, width: size, height: size });
    this.picture.replaceChildren(...this.#parts(view, aim, half), this.#bar(view, size));
    const turned = aim.deg === undefined ? 0 : turnInto(aim.reachedDeg - aim.deg, [-180, 180]);
    this.caption.textContent = say("lens.caption", { name: aim.name, error: number(error, 3), scale: number(scale / scene.view.scale, 3) })
      + (Math.abs(turned) > NO_TURN ? say("lens.turned", { angle: degreesShort(turned, 3) }) : "");
    this.picture.setAttribute("aria-label", this.caption.textContent);
    this.#place(size, aim.target);
  }

  #parts(view, aim, half) {
    const [from, to] = [aim.target, aim.reached].map((p) => view.screen(p));
    const near = (p) => Math.abs(p[0] - view.centre[0]) < 40 * half && Math.abs(p[1] - view.centre[1]) < 40 * half;
    const wanted = this.scene.wanted?.length ? [svg("path", { class: "outline", d: pathWithGaps([...this.scene.wanted, this.scene.wanted[0]].map((p) => near(p) && view.screen(p))) })] : [];
    const curve = aim.curve?.(64, 1.5 * half) ?? [];
    const axes = (p, deg, kind) => (deg === undefined ? [] : [svg("path", { class: `pose-axis ${kind}`, d: arrowPath(p, [46 * Math.cos(deg * RADIANS), -46 * Math.sin(deg * RADIANS)]) })]);
    return [...wanted, svg("path", { class: "path", d: pathWithGaps(curve.map((p) => p && near(p) && view.screen(p))) }),
      svg("path", { class: "error", d: arrowPath(from, [to[0] - from[0], to[1] - from[1]]) }), ...axes(from, aim.deg, "wanted-axis"), ...axes(to, aim.reachedDeg, "reached-axis"),
      svg("circle", { class: "target", cx: round(from[0]), cy: round(from[1]), r: 7 }), svg("circle", { class: "target-dot", cx: round(from[0]), cy: round(from[1]), r: 1.8 }),
      svg("circle", { class: "coupler-point", cx: round(to[0]), cy: round(to[1]), r: 5 })];
  }

  #bar(view, size) {
    const { length, pixels } = view.scaleBar();
    return svg("g", {}, svg("path", { class: "scale-line", d: `M10 ${size - 14}v4h${round(pixels)}v-4` }),
      svg("text", { class: "scale-text", x: 12, y: size - 18 }, say("picture.scale", { n: length, length: number(length) })));
  }

  // In the corner where it hides least, and joined with the target.
  #place(size, target) {
    const { width, height } = this.scene.view;
    const [x, y] = this.scene.view.screen(target);
    const room = 8;
    // The buttons of the picture stand in the upper right corner, its scale in the lower left one.
    const corners = [[room, width - size < 190 ? 50 : room], [width - size - room - 2, height - this.root.offsetHeight - room], [width - size - room - 2, 44], [room, height - this.root.offsetHeight - 34]];
    const crowd = [...this.scene.crowd, target].map((p) => this.scene.view.screen(p));
    const hidden = ([left, top]) => crowd.filter(([u, v]) => u > left - 14 && u < left + size + 14 && v > top - 14 && v < top + this.root.offsetHeight + 14).length;
    const covers = ([left, top]) => (Math.abs(left + size / 2 - x) < size / 2 + 14 && Math.abs(top + size / 2 - y) < size / 2 + 40 ? crowd.length : 0);
    const [left, top] = corners.map((corner) => [corner, hidden(corner) + covers(corner)]).reduce((best, one) => (one[1] < best[1] ? one : best))[0];
    this.root.style.width = `${size + 4}px`;
    this.root.style.left = `${round(left)}px`;
    this.root.style.top = `${round(top)}px`;
    const end = [left + size / 2, top + size / 2];
    const long = Math.hypot(end[0] - x, end[1] - y) || 1;
    const edge = [0, 1].map((k) => [x, y][k] + (12 * (end[k] - [x, y][k])) / long);
    this.sign.replaceChildren(svg("circle", { cx: round(x), cy: round(y), r: 12 }), svg("path", { d: pathThrough([edge, end]) }));
    if (this.sign.parentNode !== this.scene.front) this.scene.front.append(this.sign);
  }
}
