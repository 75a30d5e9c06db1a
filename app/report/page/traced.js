// Points of bodies that were clicked at: the path that each draws, and where it is on its body.

import { element, set, svg } from "./dom.js";
import { number } from "./format.js";
import { Mechanism } from "./mechanism.js";
import { legendItem, pathWithGaps, round } from "./shapes.js";
import { say } from "./words.js";

// A press that moves less than this many pixels is a click.
const STILL = 4;

const TRACED_COLOURS = ["--link-c", "--link-d", "--velocity", "--crank", "--accent"];

export class TracedPoints {
  // `notes`: the list that shows the points; `onChange` is called when there is another one.
  constructor(frame, notes, onChange) {
    Object.assign(this, { frame, notes, onChange, name: "points", words: "traced", silent: true, root: svg("g", { class: "traced" }), points: [], lines: [] });
    frame.addEventListener("pointerdown", (event) => { this.pressed = [event.clientX, event.clientY]; }, true);
    frame.addEventListener("click", (event) => this.#click(event));
  }

  // `scene.bodyOf(element)`: the number of the body drawn by it; `scene.placeOf(body, drive)`: [x, y, cos, sin].
  available(scene) { return Boolean(scene.view) && this.points.length > 0; }

  #click(event) {
    if (!this.scene?.view || !this.scene.bodyOf || event.target.closest("button, .lens") || Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) > STILL) return;
    const body = document.elementsFromPoint(event.clientX, event.clientY).map((part) => this.scene.bodyOf(part)).find((found) => found !== undefined);
    const place = body === undefined ? null : this.scene.placeOf(body, this.drive);
    if (!place) return;
    const area = this.frame.getBoundingClientRect();
    const [x, y] = this.scene.view.plane([event.clientX - area.left, event.clientY - area.top]);
    const [u, v] = [x - place[0], y - place[1]];
    this.points.push({ body, at: [place[2] * u + place[3] * v, place[2] * v - place[3] * u] });
    this.onChange();
  }

  // The picture and where it stands, also while there is no point.
  see(scene, drive) { Object.assign(this, { scene, drive }); }

  build(scene) {
    for (const line of this.lines) line.remove();
    this.parts = this.points.map(({ body, at }, i) => {
      const style = `--tint:var(${TRACED_COLOURS[i % TRACED_COLOURS.length]})`;
      const path = scene.drives.map((drive) => Mechanism.point(scene.placeOf(body, drive), at));
      const parts = [svg("path", { class: "traced-path", style, d: pathWithGaps(path.map((p) => p && scene.view.screen(p))) }), svg("circle", { class: "traced-point", style, r: 4.5 })];
      return parts;
    });
    this.root.replaceChildren(...this.parts.flat());
    this.lines = this.points.map((point) => this.#line(point, scene));
    this.notes.append(...this.lines);
  }

  #line(point, scene) {
    const away = element("button", { type: "button", class: "link" }, say("traced.remove"));
    away.addEventListener("click", () => { this.points = this.points.filter((one) => one !== point); this.onChange(); });
    return element("li", {}, say("traced.at", { body: scene.nameOf(point.body), u: number(point.at[0], 5), v: number(point.at[1], 5) }), " ", away);
  }

  clear() { for (const line of this.lines) line.remove(); }

  move(scene, drive) {
    this.points.forEach(({ body, at }, i) => {
      const p = Mechanism.point(scene.placeOf(body, drive), at);
      this.parts[i][1].toggleAttribute("hidden", !p);
      if (!p) return;
      const [x, y] = scene.view.screen(p);
      set(this.parts[i][1], { cx: round(x), cy: round(y) });
    });
  }

  legend() { return this.points.map((_, i) => legendItem(TRACED_COLOURS[i % TRACED_COLOURS.length].slice(2), "line", say("traced.legend", { n: i + 1 }))); }
}
