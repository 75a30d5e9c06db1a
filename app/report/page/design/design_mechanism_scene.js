// The picture of a design that is no four-bar.

import { sentence } from "../format.js";
import { jointsOf } from "../joints.js";
import { MechanismScene, NO_TABLE } from "../mechanism_scene.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { legendItem } from "../shapes.js";
import { say, term } from "../words.js";
import { aimsOf } from "./aims.js";
import { backdropOf, GuidedAxes, targetsOf } from "./backdrop.js";

export class DesignMechanismScene extends MechanismScene {
  constructor(frame, design, onDrag) {
    super(frame, design.mechanism, onDrag, NO_TABLE, design.angular ? 1 / RADIANS : 1);
    this.#take(design);
  }

  #take(design) {
    this.design = design;
    this.jointsAt = jointsOf(design.mechanism, design.entry.mechanism);
  }

  // The design, or one that is edited in its place.
  build(design, options) {
    this.#take(design);
    this.adopt(design.mechanism);
    this.box = design.boxes[options.framing];
    super.build();
    this.layers.backdrop.append(...backdropOf(this.view, design, options));
    this.axes = new GuidedAxes(this.view, design.guided);
    this.layers.targets.append(...targetsOf(this.view, design, options), this.axes.part);
  }

  move(drive) {
    super.move(drive);
    this.axes?.move(this.mechanism.places(drive)[this.design.guided?.body ?? 0]);
  }

  get aims() { return aimsOf(this.design); }
  get wanted() { return this.design.outline; }

  legend() {
    return this.mechanism.bodies.slice(1).map((body, i) => legendItem(this.tint(i + 1).slice(2), "line", sentence(term(body.name))));
  }
}

// In the place of a design whose links cannot be assembled.
export class EmptyScene extends Picture {
  constructor(frame) { super(frame, say("picture.none")); }
  build() { this.clear(null, say("picture.links_not_assembled")); }
  move() {}
  legend() { return []; }
}
