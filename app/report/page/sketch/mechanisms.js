// Which mechanisms are searched for: four-bars, slider-cranks, or both.

import { byId } from "../dom.js";
import { modeOf } from "./modes.js";

// By the button of each, in the order of the keys, what it says of a state: whether slider-cranks are searched for, and whether both are.
const BUTTONS = { "by-four-bar": { slides: false, both: false }, "by-slider": { slides: true, both: false }, "by-both": { slides: true, both: true } };
const NAMES = Object.keys(BUTTONS);

const nameOf = ({ slides, both }) => NAMES.find((name) => BUTTONS[name].slides === slides && BUTTONS[name].both === both);

export class Mechanisms {
  // `on`: state(), change(parts).
  constructor(on) {
    this.on = on;
    for (const name of NAMES) byId(name).addEventListener("click", () => this.#choose(name));
  }

  show() {
    const state = this.on.state();
    document.body.toggleAttribute("data-sliding", state.slides);
    for (const name of NAMES) byId(name).setAttribute("aria-pressed", String(name === nameOf(state)));
  }

  next() { this.#choose(NAMES[(NAMES.indexOf(nameOf(this.on.state())) + 1) % NAMES.length]); }

  // Limits that four-bars alone have go where slider-cranks are searched for.
  #choose(name) {
    const state = this.on.state(), chosen = BUTTONS[name];
    if (name === nameOf(state) || !modeOf(state).canSlide) return;
    this.on.change(chosen.slides ? { ...chosen, class: "any", obstacle: null } : chosen);
  }
}
