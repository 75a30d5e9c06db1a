// The boxes that a hand draws on the sheet: where the fixed pivots stand, and where no joint comes.

import { byId } from "../dom.js";
import { say } from "../words.js";
import { rounded } from "./stroke.js";

const BOX_WORDS = {
  region: { put: "sketch.region", away: "sketch.region_away", draw: "sketch.draw_region" },
  obstacle: { put: "sketch.obstacle", away: "sketch.obstacle_away", draw: "sketch.draw_obstacle" },
};

// Over a whole turn of the crank something holds only where it turns fully.
const TURNING = ["crank-rocker", "double-crank"];
export const turnsFully = ({ class: asked }) => TURNING.includes(asked);

// What another class changes of a state.
export const withClass = (asked) => ({ class: asked, ...(TURNING.includes(asked) ? {} : { obstacle: null }) });

// What a box of two opposite corners changes of a state; null of one without an area where that is needed.
function withBox(name, state, p, q) {
  const [low, high] = [Math.min, Math.max].map((pick) => rounded([0, 1].map((k) => pick(p[k], q[k]))));
  if (name === "region") return { region: [low, high] };
  if (low[0] === high[0] || low[1] === high[1]) return null;
  return { obstacle: [low, high], class: turnsFully(state) ? state.class : TURNING[0] };
}

export class Boxes {
  // `on`: state(), change(parts), announce(text), resume() where there is no box; `surface`: where they are drawn.
  constructor(surface, on) {
    Object.assign(this, { surface, on });
    for (const name of Object.keys(BOX_WORDS)) byId(name).addEventListener("click", () => this.toggle(name));
  }

  // Lets the next stroke be such a box, or takes the box away.
  toggle(name) {
    if (this.on.state()[name]) { this.on.change({ [name]: null }); return; }
    this.surface.boxes = this.surface.boxes === name ? null : name;
    this.show();
    this.on.announce(this.surface.boxes ? say(BOX_WORDS[name].draw) : "");
  }

  // A box was drawn.
  put(p, q) {
    const parts = withBox(this.surface.boxes, this.on.state(), p, q);
    this.surface.boxes = null;
    if (parts) this.on.change(parts); else this.on.resume();
  }

  // Functions have no such limits, slider-cranks and lines only that of the pivots.
  show() {
    const { ranges, slides, straight } = this.on.state();
    if (ranges || ((slides || straight) && this.surface.boxes === "obstacle")) this.surface.boxes = null;
    for (const [name, { put, away }] of Object.entries(BOX_WORDS)) {
      byId(name).textContent = say(this.on.state()[name] ? away : put);
      byId(name).setAttribute("aria-pressed", String(this.surface.boxes === name));
    }
  }
}
