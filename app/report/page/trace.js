// The way that points leave behind while they move.

import { set, svg } from "./dom.js";
import { MOST_MARKS } from "./extras.js";
import { Picture } from "./picture.js";
import { legendItem, pathWithGaps } from "./shapes.js";
import { say } from "./words.js";

const TRACE_LENGTH = 720;

export class Trace {
  constructor() {
    Object.assign(this, { name: "trace", words: "extras.trace", key: "t", ways: [], root: svg("g", { class: "trace" }) });
  }

  available(scene) { return scene.marksAt !== Picture.prototype.marksAt; }

  build(scene) {
    if (this.scene !== scene) Object.assign(this, { scene, ways: [] });
    this.root.replaceChildren();
    this.parts = null;
    this.#draw(scene);
  }

  move(scene, drive) {
    const places = scene.marksAt(drive).slice(0, MOST_MARKS);
    if (this.ways.length !== places.length) this.ways = places.map(() => []);
    const [near, far] = [0.3 / scene.view.scale, 0.25 * Math.min(scene.view.width, scene.view.height) / scene.view.scale];
    places.forEach((p, i) => {
      const way = this.ways[i];
      const last = way.at(-1);
      const step = last ? Math.hypot(p[0] - last[0], p[1] - last[1]) : Infinity;
      if (step < near) return;
      // A jump is no way.
      if (last && step > far) way.push(null);
      way.push(p);
      if (way.length > TRACE_LENGTH) way.splice(0, way.length - TRACE_LENGTH);
    });
    this.#draw(scene);
  }

  // Newer parts lie over the whole and are stronger.
  #draw({ view }) {
    if (this.parts?.length !== 2 * this.ways.length) {
      this.parts = this.ways.flatMap(() => [svg("path", { class: "old" }), svg("path", { class: "new" })]);
      this.root.replaceChildren(...this.parts);
    }
    this.ways.forEach((way, i) => {
      const points = way.map((p) => p && view.screen(p));
      set(this.parts[2 * i], { d: pathWithGaps(points) });
      set(this.parts[2 * i + 1], { d: pathWithGaps(points.slice(-TRACE_LENGTH / 8)) });
    });
  }

  legend() { return [legendItem("trace", "line", say("extras.trace"))]; }
}
