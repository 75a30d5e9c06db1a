// What the kernel measures of the mechanism: its facts, and curves over the drive of a part that is chosen.

import { showFacts } from "../analysis/facts.js";
import { analysisSheets, partColours } from "../analysis/sheets.js";
import { partName, Table } from "../analysis/table.js";
import { Curves } from "../curves.js";
import { byId, element } from "../dom.js";
import { sentence } from "../format.js";
import { say, term } from "../words.js";

export class Results {
  // `goTo(drive)` by a plot; `tintOf(link)`: its colour in the picture.
  constructor({ goTo, tintOf }) {
    Object.assign(this, { tintOf, part: null, motion: null });
    this.curves = new Curves(byId("plots"), goTo);
    byId("curve-part").addEventListener("change", (event) => { this.part = event.target.value; if (this.motion) this.#draw(); });
  }

  // What is shown is of a state before.
  wait() {
    this.motion = null;
    this.#dim(true);
  }

  #dim(waits) {
    for (const id of ["facts", "curves"]) {
      byId(id).classList.toggle("waits", waits);
      byId(id).setAttribute("aria-busy", String(waits));
    }
  }

  // Of a whole motion; null: of none.
  show(motion, state) {
    this.motion = motion;
    this.#dim(false);
    for (const id of ["facts", "curves"]) byId(id).hidden = !motion;
    if (!motion) return;
    const { data: { facts, drive, table, vectors, normals, loads, landmarks }, mechanism } = motion;
    showFacts(facts, drive, mechanism);
    Object.assign(this, { drive, landmarks: landmarks.filter((one) => one.drive !== null), table: new Table(table, vectors, normals, loads ?? []) });
    this.#offer(state);
    this.#draw();
  }

  // The parts with columns; at first a point that is followed, else the link that is driven last.
  #offer(state) {
    const { parts } = this.table, points = state.joints.filter(({ of }) => of.length === 1).map(({ name }) => name);
    const output = this.motion.mechanism.bodies[this.motion.mechanism.output]?.name;
    if (!parts.includes(this.part)) this.part = [...points, output, ...parts].find((part) => parts.includes(part));
    byId("curve-part").replaceChildren(...parts.map((part) => element("option", { value: part, ...(part === this.part ? { selected: "" } : {}) }, partName(part))));
  }

  #draw() {
    const { mechanism } = this.motion, name = sentence(term(this.drive.name));
    const axis = say(this.drive.kind === "slider" ? "drive.way_axis" : "drive.angle_axis", { name });
    const colours = partColours(this.table, { mechanism, tint: (i) => this.tintOf(mechanism.bodies[i].name) });
    if (!mechanism.bodies.some(({ name }) => name === this.part)) colours.set(this.part, "--curve");
    this.curves.build(analysisSheets(this.table, mechanism, new Set([this.part]), this.landmarks, axis, colours));
  }

  redraw() { this.curves.redraw(); }

  move(drive) { if (this.motion) this.curves.move(drive); }
}
