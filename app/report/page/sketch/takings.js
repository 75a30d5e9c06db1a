// What is taken along of a sketch: its problem, a design, and the address that holds both.

import { saveText } from "../controls.js";
import { byId, element } from "../dom.js";
import { tableWithoutRounding } from "../rounding.js";
import { problemToml } from "../toml.js";
import { say } from "../words.js";
import { modeOf } from "./modes.js";
import { problemOf, short } from "./question.js";

const FILE_STARTS = 500;
const FILE_DESIGNS = 3;

// The analysis of a candidate over its whole motion.
const analysisOf = ({ entry: { mechanism }, range: [from, to] }) => ({ kind: "analysis", mechanism: tableWithoutRounding(mechanism),
  drive: { start_deg: short(from), end_deg: short(to), steps: 360 } });

export class Takings {
  // `present()`: the state of the sketch and the candidate chosen, perhaps none.
  constructor(present) {
    this.present = present;
    this.text = element("textarea", { readonly: "", rows: 9, spellcheck: "false", "aria-label": say("sketch.file"), id: "taken", hidden: "" });
    this.said = element("p", { class: "muted", role: "status" });
    const problem = () => this.problem, design = () => this.design, link = () => location.href;
    this.buttons = [["sketch.copy_problem", problem, (text) => this.#copy(text)], ["sketch.save_problem", problem, (text) => this.#save("sketch", text)],
      ["sketch.copy_design", design, (text) => this.#copy(text)], ["sketch.save_design", design, (text) => this.#save("sketch-design", text)], ["sketch.copy_link", link, (text) => this.#copy(text)]]
      .map(([name, text, act]) => {
        const button = element("button", { type: "button", class: "chip", "data-take": name.split(".")[1] }, say(name));
        button.addEventListener("click", () => act(text()));
        return { button, text };
      });
    byId("takings").append(element("div", { class: "sketch-buttons" }, ...this.buttons.map(({ button }) => button)), this.said, this.text);
  }

  get title() { return say(modeOf(this.present().state).title); }
  get problem() { return problemToml({ title: this.title, ...problemOf(this.present().state, { starts: FILE_STARTS, designs: FILE_DESIGNS }) }); }
  get design() { return problemToml({ title: this.title, ...analysisOf(this.present().candidate) }); }

  // What can be taken now.
  follow(hasPoints, hasDesign) {
    for (const { button } of this.buttons) button.disabled = button.dataset.take.includes("design") ? !hasDesign : !hasPoints;
    this.said.textContent = "";
    this.text.hidden = true;
  }

  #save(name, text) { saveText(name, "toml", "application/toml", text); }

  // Pages opened from disk may not have the clipboard: then the text is selected, to be copied by hand.
  async #copy(text) {
    this.text.hidden = false;
    this.text.value = text;
    try {
      await navigator.clipboard.writeText(text);
      this.said.textContent = say("edit.copied");
    } catch {
      this.text.focus();
      this.text.select();
      this.said.textContent = say("edit.selected");
    }
  }
}
