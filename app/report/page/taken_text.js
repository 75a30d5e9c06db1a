// Texts that a page gives away: buttons that copy or save them, or take them to the studio that serves the page.

import { saveText } from "./controls.js";
import { element } from "./dom.js";
import { isServed, takeToStudio } from "./studio/drawn.js";
import { say } from "./words.js";

export class TakenText {
  // `rows`: [words, text(), name of the file to save or null of what is copied] of each button; `label`: of the text shown. `problem()` is the
  // text that a studio solves, in a button of its name where one serves the page.
  constructor(holder, rows, label, problem) {
    this.text = element("textarea", { readonly: "", rows: 9, spellcheck: "false", "aria-label": label, id: "taken", hidden: "" });
    this.said = element("p", { class: "muted", role: "status" });
    this.buttons = [...rows.map(([words, text, name]) => this.#button(words, () => { if (name) saveText(name, "toml", "application/toml", text()); else this.#copy(text()); })),
      ...(isServed ? [this.#button("take.problem_to_studio", () => takeToStudio(problem()))] : [])];
    holder.append(element("div", { class: "sketch-buttons" }, ...this.buttons), this.said, this.text);
  }

  #button(words, act) {
    const button = element("button", { type: "button", class: "chip", "data-take": words.split(".")[1] }, say(words));
    button.addEventListener("click", act);
    return button;
  }

  // What can be taken now: `has(name)` of the button named so.
  follow(has) {
    for (const button of this.buttons) button.disabled = !has(button.dataset.take);
    this.said.textContent = "";
    this.text.hidden = true;
  }

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
