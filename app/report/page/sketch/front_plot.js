// The plot of a front: error over minimum transmission angle, its points to look at and to take.

import { byId, set, svg } from "../dom.js";
import { number } from "../format.js";
import { pathThrough, round } from "../shapes.js";
import { say } from "../words.js";
import { angleScale, errorScale } from "./front_scales.js";

const HEIGHT = 210;
const FRAME = { left: 58, right: 12, top: 10, bottom: 40 };
const SAME_ANGLE = 0.05, SAME_ERROR = 5e-3;   // degrees, and a share: the marks of two would lie on one another
const ARROWS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, Home: -Infinity, End: Infinity };

export class FrontPlot {
  // `on.point(point)`: the one looked at, null where none is or the design chosen; `on.take(point)`; `textOf(point)` says its values.
  constructor(on, textOf) {
    Object.assign(this, { on, textOf, holder: byId("front-plot"), front: { points: [] }, hinted: null, drawn: [], circles: [] });
    [this.back, this.marks] = [svg("g"), svg("g")];
    this.picture = svg("svg", { role: "group", "aria-labelledby": "front-title" }, this.back, this.marks);
    this.holder.addEventListener("pointermove", (event) => this.#hint(this.#nearest(event)));
    this.holder.addEventListener("pointerleave", () => this.#hint(this.#focused));
    this.holder.addEventListener("click", (event) => this.#take(this.#nearest(event)));
    this.holder.addEventListener("focusin", () => { this.#reachable(this.#focused); this.#hint(this.#focused); });
    this.holder.addEventListener("focusout", () => this.#hint(null));
    this.holder.addEventListener("keydown", (event) => this.#key(event));
    new ResizeObserver(() => this.#draw()).observe(this.holder);
  }

  // `points`; the design `chosen` and `least`, the present bound; both may be none; the text `axis` of the errors.
  show(front) {
    this.front = front;
    this.#draw();
  }

  get #focused() { return this.drawn[this.circles.indexOf(document.activeElement)] ?? null; }

  // Focus and hint stay where the hand is.
  #draw() {
    // Its width, which costs a layout of the page, is asked for where there is something to draw.
    const { points } = this.front, width = points.length && this.holder.clientWidth, { hinted } = this, focused = this.#focused;
    if (width) this.#build(points, width); else this.#empty();
    if (focused && !this.#focused) this.#focus(points.find(({ level }) => level >= focused.level) ?? points.at(-1));
    this.#reachable(this.#focused ?? this.#chosenOrFirst);
    this.#hint(points.find(({ level }) => level === hinted?.level) ?? this.#focused);
  }

  #empty() {
    Object.assign(this, { drawn: [], circles: [] });
    this.marks.replaceChildren();
    this.picture.remove();
  }

  #build(points, width) {
    const { chosen, least } = this.front, [bottom, right] = [HEIGHT - FRAME.bottom, width - FRAME.right];
    const all = chosen && !points.some((point) => this.#isChosen(point)) ? [...points, chosen] : points;
    const x = angleScale([FRAME.left, right]), y = errorScale(all.map(({ error }) => error), [bottom, FRAME.top]);
    this.places = all.map(({ angle, error }) => [x.to(angle), y.to(error)].map(round));
    this.#arrange(points);
    const bound = least > 0 ? [svg("path", { class: "front-bound", d: `M${round(x.to(least))} ${FRAME.top}V${bottom}` })] : [];
    const line = svg("path", { class: "front-line", d: pathThrough(this.places.slice(0, points.length)) });
    const apart = this.places.slice(points.length).map(([cx, cy]) => svg("circle", { class: "front-apart", cx, cy, r: 5 }));
    this.back.replaceChildren(...this.#axes(x, y, bottom, right), ...bound, line, ...apart);
    set(this.picture, { viewBox: `0 0 ${width} ${HEIGHT}`, width, height: HEIGHT });
    if (!this.picture.isConnected) this.holder.append(this.picture);
  }

  // A circle stays the same, with the focus, as long as there is a point of its level.
  #arrange(points) {
    const before = new Map(this.drawn.map(({ level }, i) => [level, this.circles[i]]));
    const circles = points.map(({ level }) => before.get(level) ?? svg("circle", { class: "front-point", role: "button", tabindex: -1 }));
    for (const circle of this.circles) if (!circles.includes(circle)) circle.remove();
    circles.forEach((circle, i) => { if (this.marks.children[i] !== circle) this.marks.insertBefore(circle, this.marks.children[i] ?? null); });
    Object.assign(this, { drawn: points, circles });
    points.forEach((point, i) => this.#mark(circles[i], point, this.places[i]));
  }

  #axes(x, y, bottom, right) {
    const text = (name, at, anchor, value) => svg("text", { class: name, "text-anchor": anchor, ...at }, value);
    const grid = (d) => svg("path", { class: "grid", d });
    const across = x.ticks.flatMap((v) => [grid(`M${round(x.to(v))} ${FRAME.top}V${bottom}`), text("tick", { x: round(x.to(v)), y: bottom + 15 }, "middle", `${v}°`)]);
    const upwards = y.ticks.flatMap((v) => [grid(`M${FRAME.left} ${round(y.to(v))}H${right}`), text("tick", { x: FRAME.left - 6, y: round(y.to(v)) + 4 }, "end", number(v, 4))]);
    return [...across, ...upwards, text("axis", { x: (FRAME.left + right) / 2, y: HEIGHT - 6 }, "middle", say("sketch.transmission")),
      text("axis", { transform: `translate(12 ${(bottom + FRAME.top) / 2}) rotate(-90)` }, "middle", say(this.front.axis))];
  }

  #mark(circle, point, [cx, cy]) {
    const isChosen = this.#isChosen(point);
    const facts = { "data-level": point.level, "data-angle": point.angle, "data-error": point.error };
    set(circle, { cx, cy, r: isChosen ? 6.5 : 5, "aria-pressed": String(isChosen), "aria-label": this.textOf(point), ...facts });
  }

  // Searches find a design more than once, with other last digits.
  #isChosen({ angle, error }) {
    const { chosen } = this.front;
    return Boolean(chosen) && Math.abs(angle - chosen.angle) < SAME_ANGLE && Math.abs(error - chosen.error) <= SAME_ERROR * error;
  }

  get #chosenOrFirst() { return this.drawn.find((point) => this.#isChosen(point)) ?? this.drawn[0]; }

  #focus(point) { this.circles[this.drawn.indexOf(point)]?.focus({ preventScroll: true }); }

  // One of the points is in the order of the Tab key; arrows go on from it.
  #reachable(point) { this.circles.forEach((circle, i) => set(circle, { tabindex: this.drawn[i] === point ? 0 : -1 })); }

  #nearest(event) {
    const box = this.holder.getBoundingClientRect();
    const far = this.drawn.map((_, i) => Math.hypot(this.places[i][0] - event.clientX + box.left, this.places[i][1] - event.clientY + box.top));
    return this.drawn[far.indexOf(Math.min(...far))] ?? null;
  }

  #hint(point) {
    this.circles.forEach((circle, i) => circle.classList.toggle("hinted", this.drawn[i] === point));
    this.hinted = point;
    this.on.point(point && !this.#isChosen(point) ? point : null);
  }

  #take(point) {
    if (!point) return;
    this.on.take(point);
    this.#focus(this.#chosenOrFirst);
  }

  #key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || !this.#focused) return;
    const step = ARROWS[event.key], at = this.circles.indexOf(document.activeElement), last = this.circles.length - 1;
    if (step) this.circles[Math.min(last, Math.max(0, at + step))].focus();
    else if (["Enter", " "].includes(event.key)) this.#take(this.#focused);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
