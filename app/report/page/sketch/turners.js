// Handles at the tips of poses, by which they are turned.

import { svg } from "../dom.js";
import { say } from "../words.js";
import { arrange, grip } from "./grips.js";
import { along, directionOf, FIRST_AXIS, inTurn } from "./posed.js";

const STEPS = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 };
const FAR = 10;

export class Turners {
  // `on.turn(i, degrees)`, `on.drop()` after the last of them, `on.remove(i)`; `placeOf(event)` in the plane,
  // `screenOf(place)`.
  constructor(on, placeOf, screenOf) {
    Object.assign(this, { on, placeOf, screenOf, handles: [], root: svg("g") });
  }

  #handle(i) {
    return grip({ r: 9, role: "slider", "aria-valuemin": 0, "aria-valuemax": 359, "data-turn": i, "aria-label": say("sketch.turn", { name: i + 1 }) },
      { move: (event) => this.on.turn(i, directionOf(this.places[i], this.placeOf(event))), drop: () => this.on.drop(), key: (event) => this.#key(event, i) });
  }

  #key(event, i) {
    if (event.key === "Delete") this.on.remove(i);
    const step = STEPS[event.key];
    if (step) {
      this.on.turn(i, inTurn(this.angles[i] + step * (event.shiftKey ? FAR : 1)));
      this.on.drop();
    }
    return event.key === "Delete" || step !== undefined;
  }

  // Of poses at `places` with `angles`.
  show(places, angles) {
    Object.assign(this, { places, angles });
    arrange(this.handles, this.root, angles.map((degrees, i) => along(this.screenOf(places[i]), degrees, FIRST_AXIS)), (i) => this.#handle(i),
      (i) => ({ "aria-valuenow": angles[i], "aria-valuetext": say("motion.degrees", { value: angles[i] }) }));
  }
}
