// The card beside the picture while a design is edited: its dimensions to type, what they make of it
// against what it was, and the file to take away.

import { markOf } from "../checks.js";
import { saveText } from "../controls.js";
import { element } from "../dom.js";
import { sentence } from "../format.js";
import { say } from "../words.js";

export class EditPanel {
  // `on`: field(field, value), slide(field, value) where fields have a range, undo(), redo(), reset(), toml() → text, title() → text.
  // `hint` is given where the fields are all that is changed: then they come first.
  constructor(fields, on, hint) {
    Object.assign(this, { fields, on });
    this.buttons = Object.fromEntries(["undo", "redo", "reset"].map((name) => [name, this.#button(name, () => on[name]())]));
    this.inputs = fields.map((field) => this.#input(field));
    this.status = element("p", { class: "edit-status", role: "status" });
    this.values = element("tbody", { id: "edit-values" });
    this.checks = element("tbody", { id: "edit-checks" });
    this.text = element("textarea", { id: "edit-toml", rows: 12, readonly: "", spellcheck: "false", "aria-label": say("edit.file"), hidden: "" });
    const copy = this.#button("copy", () => this.#copy());
    const save = this.#button("save", () => this.#save());
    this.root = element("section", { class: "card edit", id: "edit", "aria-labelledby": "edit-title" },
      element("div", { class: "card-head" }, element("h2", { id: "edit-title" }, say("edit.title")), element("div", { class: "segments" }, ...Object.values(this.buttons), copy, save)),
      this.status, this.text, ...(hint ? [...this.#numbers(hint), this.#values()] : [this.#values(), ...this.#numbers(say("edit.hint"))]),
      tableOf("edit-checks-table", ["edit.check", "edit.bound", "edit.now"], this.checks));
  }

  #values() { return tableOf("edit-values-table", ["edit.quantity", "edit.before", "edit.now"], this.values); }

  // The fields of the mechanism, and those of other tables folded.
  #numbers(hint) {
    const grid = (group) => element("div", { class: "edit-fields" }, ...this.inputs.filter(({ field }) => field.group === group).map(({ label }) => label));
    const groups = [...new Set(this.fields.map((field) => field.group))].filter((group) => group !== undefined);
    const isOpen = (group) => this.fields.some((field) => field.group === group && field.open);
    return [element("p", { class: "muted" }, hint), grid(undefined), ...groups.map((group) => element("details", isOpen(group) ? { open: "" } : {}, element("summary", {}, sentence(group)), grid(group)))];
  }

  #button(name, act) {
    const button = element("button", { type: "button", "data-edit": name, title: say(`edit.${name}.title`) }, say(`edit.${name}`));
    button.addEventListener("click", act);
    return button;
  }

  #input(field) {
    const input = element("input", { type: "number", step: "any", "data-field": field.key });
    const label = element("label", {}, element("span", {}, field.label ?? say(`edit.field.${field.key}`)), input);
    input.addEventListener("change", () => this.on.field(field, input.valueAsNumber));
    return { field, input, label, slider: field.range ? this.#slider(field, label) : null };
  }

  // A slider below the number, where it has a range to be moved in.
  #slider(field, label) {
    const [min, max] = field.range;
    const slider = element("input", { type: "range", min, max, step: field.step ?? "any", tabindex: -1, "aria-hidden": "true", "data-slider": field.key });
    slider.addEventListener("input", () => this.on.slide(field, roundedTo(slider.valueAsNumber, max - min)));
    slider.addEventListener("change", () => this.on.field(field, roundedTo(slider.valueAsNumber, max - min)));
    label.append(slider);
    return slider;
  }

  // `rows` as of editRows; `checks`: [name, bound, now, met], met null where it is not known.
  show(state, history, rows, checks) {
    for (const { field, input, slider } of this.inputs) {
      const value = field.get(state);
      if (document.activeElement !== input || input.valueAsNumber !== value) input.value = value ?? "";
      if (slider && document.activeElement !== slider) slider.value = value ?? "";
    }
    this.buttons.undo.disabled = !history.canUndo;
    this.buttons.redo.disabled = !history.canRedo;
    this.buttons.reset.disabled = !history.changed;
    const cell = ({ text, value }) => element("td", { class: "number", "data-value": JSON.stringify(value) }, text);
    this.values.replaceChildren(...rows.map(({ key, label, before, now }) => element("tr", { class: before.text === now.text ? "" : "changed", "data-row": key },
      element("td", {}, label ?? say(`edit.${key}`)), cell(before), cell(now))));
    this.checks.parentElement.hidden = checks.length === 0;
    this.checks.replaceChildren(...checks.map(([name, bound, now, met]) => element("tr", { class: met === false ? "missed" : "" },
      element("td", {}, name), element("td", { class: "number" }, bound), element("td", { class: "number" }, now, ...(met === null ? [] : [" ", markOf(met ? "" : say("edit.missed"))])))));
    if (!this.text.hidden) this.text.value = this.on.toml();
  }

  say(text) {
    this.status.textContent = text;
    this.status.hidden = text === "";
  }

  #showFile() {
    this.text.hidden = false;
    this.text.value = this.on.toml();
  }

  // Pages opened from disk may not have the clipboard: then the text is selected, to be copied by hand.
  async #copy() {
    this.#showFile();
    try {
      await navigator.clipboard.writeText(this.text.value);
      this.say(say("edit.copied"));
    } catch {
      this.text.focus();
      this.text.select();
      this.say(say("edit.selected"));
    }
  }

  #save() {
    this.#showFile();
    saveText(this.on.title(), "toml", "application/toml", this.text.value);
  }
}

// A thousandth of the range is as finely as a hand moves a slider.
function roundedTo(value, range) {
  const places = Math.max(0, 3 - Math.floor(Math.log10(range)));
  return Number(value.toFixed(Math.min(places, 100)));
}

function tableOf(id, heads, body) {
  return element("table", { id, class: "checks" }, element("thead", {}, element("tr", {}, ...heads.map((key, i) => element("th", { scope: "col", class: i ? "number" : "" }, say(key))))), body);
}
