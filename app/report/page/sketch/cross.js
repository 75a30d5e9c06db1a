// The cross of a sheet: arrows move it, Enter and the space bar do what a hand does there.

import { set, svg } from "../dom.js";
import { round } from "../shapes.js";

const STEP_PIXELS = 8;
export const ARROWS_TO = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

// A place that an arrow has moved by some pixels.
export const stepped = (place, step, far, { scale }) => place.map((x, k) => x + ((far ? 5 : 1) * STEP_PIXELS * step[k]) / scale);

export class Cross {
  // `area`: what has the focus; `view()`; put(place) where Enter is pressed, seen(place) wherever the cross comes.
  constructor(area, view, put, seen = () => {}) {
    Object.assign(this, { view, put, seen, at: null });
    this.root = svg("path", { class: "sketch-cross", d: "M-9 0H9M0 -9V9", hidden: "" });
    area.addEventListener("keydown", (event) => this.#key(event));
    area.addEventListener("blur", () => this.hide());
  }

  hide() { this.root.toggleAttribute("hidden", true); }

  #key(event) {
    const step = ARROWS_TO[event.key], puts = ["Enter", " "].includes(event.key);
    if ((!step && !puts) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.at ??= this.view().plane(this.view().middle);
    if (puts) this.put(this.at);
    else this.at = stepped(this.at, step, event.shiftKey, this.view());
    const [x, y] = this.view().screen(this.at);
    set(this.root, { transform: `translate(${round(x)} ${round(y)})` });
    this.root.toggleAttribute("hidden", false);
    this.seen(this.at);
  }
}
