// The card beside the picture while a design is edited: its dimensions to type, what they make of it
// against what it was, and the file to take away.

import { markOf } from "../checks.js";
import { saveText } from "../controls.js";
import { element } from "../dom.js";
import { sentence } from "../format.js";
import { say } from "../words.js";

export class EditPanel {
  // `on`: field(field, value), undo(), redo(), reset(), toml() → text, title() → text.
  constructor(fields, on) {
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
      this.status, this.text, tableOf("edit-values-table", ["edit.quantity", "edit.before", "edit.now"], this.values),
      element("p", { class: "muted" }, say("edit.hint")), ...this.#grids(),
      tableOf("edit-checks-table", ["edit.check", "edit.bound", "edit.now"], this.checks));
  }

  // The fields of the mechanism, and those of other tables folded.
  #grids() {
    const grid = (group) => element("div", { class: "edit-fields" }, ...this.inputs.filter(({ field }) => field.group === group).map(({ label }) => label));
    const groups = [...new Set(this.fields.map((field) => field.group))].filter((group) => group !== undefined);
    return [grid(undefined), ...groups.map((group) => element("details", {}, element("summary", {}, sentence(group)), grid(group)))];
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
    return { field, input, label };
  }

  // `rows` as of editRows; `checks`: [name, bound, now, met], met null where it is not known.
  show(state, history, rows, checks) {
    for (const { field, input } of this.inputs) {
      if (document.activeElement !== input || input.valueAsNumber !== field.get(state)) input.value = field.get(state);
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

function tableOf(id, heads, body) {
  return element("table", { id, class: "checks" }, element("thead", {}, element("tr", {}, ...heads.map((key, i) => element("th", { scope: "col", class: i ? "number" : "" }, say(key))))), body);
}
