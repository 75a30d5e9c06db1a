// What is taken along of a sketch: its problem, a design, and the address that holds both.

import { byId } from "../dom.js";
import { tableWithoutRounding } from "../rounding.js";
import { TakenText } from "../taken_text.js";
import { problemToml } from "../toml.js";
import { say } from "../words.js";
import { modeOf } from "./modes.js";
import { kindOf, problemOf, short } from "./question.js";

const FILE_STARTS = 500;
const FILE_DESIGNS = 3;

// The mechanism of an analysis; the point on a slider-crank's rod is a table of its own.
function partsOf(mechanism) {
  if (mechanism.type !== "slider-crank") return { mechanism: tableWithoutRounding(mechanism) };
  const { coupler_point: at, ...dimensions } = tableWithoutRounding(mechanism);
  return { mechanism: dimensions, point: [{ name: "P", on: "coupler", at }] };
}

// The analysis of a candidate over its whole motion.
const analysisOf = ({ entry: { mechanism }, range: [from, to] }) => ({ kind: "analysis", ...partsOf(mechanism),
  drive: { start_deg: short(from), end_deg: short(to), steps: 360 } });

export class Takings {
  // `present()`: the state of the sketch and the candidate chosen, perhaps none.
  constructor(present) {
    this.present = present;
    const problem = () => this.problem, design = () => this.design;
    this.taken = new TakenText(byId("takings"), [["sketch.copy_problem", problem, null], ["sketch.save_problem", problem, "sketch"],
      ["sketch.copy_design", design, null], ["sketch.save_design", design, "sketch-design"], ["sketch.copy_link", () => location.href, null]], say("sketch.file"), problem);
  }

  get title() { return say(modeOf(this.present().state).title); }

  // A file has one kind of mechanism: that of the design.
  get problem() {
    const { state, candidate } = this.present();
    return problemToml({ title: this.title, ...problemOf(kindOf(state, candidate?.entry), { starts: FILE_STARTS, designs: FILE_DESIGNS }) });
  }

  get design() { return problemToml({ title: this.title, ...analysisOf(this.present().candidate) }); }

  // What can be taken now.
  follow(hasPoints, hasDesign) { this.taken.follow((name) => (name.includes("design") ? hasDesign : hasPoints)); }
}
