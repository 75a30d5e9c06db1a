// What is taken along of a result: files as `cognate export` writes them, of which a picture is shown first.

import { saveFile } from "../controls.js";
import { byId, element } from "../dom.js";
import { say } from "../words.js";
import { ask } from "./server.js";
import { addressWithToken } from "./token.js";

const PICTURE_AFTER = 300;   // ms without a change

// What is asked for in which part of the form; whatever else the program knows stands in the last.
const GROUPS = [
  ["drawing", ["position", "chord-tolerance", "dxf-version", "steps"]],
  ["parts", ["parts", "hole", "width", "thickness", "clearance", "gap", "kerf", "sheet", "labels", "bill", "spacers", "bearing", "screw", "washer", "boss", "block"]],
  ["wheels", []]];
const ELSEWHERE = ["format", "design"];
const EXAMPLES = { "dxf-version": "r12", sheet: "600x400", labels: "stroke", bearing: "608", screw: "M5", washer: "1x10", block: "20x12", curve: "cutter" };

// Formats of which a picture shows what is drawn, and the options that such a picture has none of.
const PICTURED = ["dxf", "svg", "step", "stl"];
const NOT_PICTURED = ["dxf-version", "boss", "bill"];

export class Taking {
  // `choices`: formats, options and flags by the program; `stem()` of the file.
  constructor(choices, stem) {
    Object.assign(this, { choices, stem, fields: new Map(), asked: 0 });
    this.format = element("select", { id: "take-format" }, ...choices.formats.map((word) => element("option", {}, word)));
    this.design = element("select", { id: "take-design" });
    byId("taking-first").append(this.#labelled("take.design", this.design), this.#labelled("take.format", this.format), this.#button("take.save", () => this.save()), this.#button("take.report", () => this.saveReport()));
    byId("taking-options").append(...this.#groups());
    byId("taking").addEventListener("input", () => this.#changed());
    byId("taking").addEventListener("toggle", () => this.#changed());
    this.follow({ designs: 0, report: 0 });
  }

  #labelled(words, field) { return element("label", {}, element("span", {}, say(words)), " ", field); }

  #button(words, act) {
    const button = element("button", { type: "button", class: "chip", "data-take": words.split(".")[1] }, say(words));
    button.addEventListener("click", act);
    return button;
  }

  #field(name) {
    const isFlag = this.choices.flags.includes(name);
    const field = element("input", { type: isFlag ? "checkbox" : "text", "data-option": name, title: `--${name}`, ...(isFlag ? {} : { placeholder: EXAMPLES[name] ?? "", spellcheck: "false", autocomplete: "off" }) });
    this.fields.set(name, field);
    return this.#labelled(`take.${name}`, field);
  }

  #groups() {
    const all = [...this.choices.options, ...this.choices.flags].filter((name) => !ELSEWHERE.includes(name)), placed = GROUPS.flatMap(([, names]) => names);
    return GROUPS.map(([group, names], i) => {
      const own = i === GROUPS.length - 1 ? all.filter((name) => !placed.includes(name)) : names.filter((name) => all.includes(name));
      return element("fieldset", {}, element("legend", {}, say(`take.of_${group}`)), ...own.map((name) => this.#field(name)));
    });
  }

  // The options as the form has them.
  #options() {
    const given = [...this.fields].map(([name, field]) => [name, field.type === "checkbox" ? field.checked : field.value.trim()]);
    return { format: this.format.value, design: Number(this.design.value), ...Object.fromEntries(given.filter(([, value]) => value)) };
  }

  // What there is to take of the result of a run.
  follow({ designs, report }) {
    byId("taking").hidden = report === 0;
    if (report === this.report) return;
    this.report = report;
    const chosen = Math.min(Number(this.design.value) || 1, designs);
    this.design.replaceChildren(...Array.from({ length: designs }, (_, i) => element("option", { value: i + 1 }, i + 1)));
    this.design.value = chosen;
    for (const button of byId("taking").querySelectorAll("[data-take=save]")) button.disabled = designs === 0;
    this.#changed();
  }

  #changed() {
    this.asked += 1;
    clearTimeout(this.timer);
    byId("taking-said").replaceChildren();
    if (byId("taking").open && this.design.value) this.timer = setTimeout(() => this.#picture(), PICTURE_AFTER);
  }

  // The answer to `options`, or null where it has faults, which are said, or the form has changed meanwhile.
  async #answer(options) {
    const own = ++this.asked, { status, body } = await ask("/export", options);
    if (own !== this.asked) return null;
    if (status === 200 && body.files) return body;
    this.#say((body.faults ?? [status === 0 ? say("studio.gone") : body.error]).map((text) => ["bad", text]));
    return null;
  }

  #say(rows) { byId("taking-said").replaceChildren(...rows.map(([kind, text]) => element("li", { class: kind, lang: "en" }, text))); }

  async #picture() {
    const options = this.#options(), drawn = PICTURED.includes(options.format);
    if (!drawn) { this.#show(null); return; }
    const solid = options.format === "step" || options.format === "stl";
    const made = await this.#answer({ ...Object.fromEntries(Object.entries(options).filter(([name]) => !NOT_PICTURED.includes(name))), format: "svg", ...(solid ? { parts: true } : {}) });
    this.#show(made?.files.find(({ name }) => name.endsWith(".svg")) ?? null);
    if (made) this.#say(made.notes.map((text) => ["note", text]));
  }

  #show(file) {
    byId("taking-picture").hidden = !file;
    if (file) byId("taking-picture").src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(file.text)}`;
  }

  async save() {
    clearTimeout(this.timer);
    const made = await this.#answer(this.#options());
    if (!made) return;
    for (const { name, text } of made.files) saveFile(name, "application/octet-stream", text);
    this.#say([...made.notes.map((text) => ["note", text]), ["done", made.files.map(({ name }) => name).join(", ")]]);
  }

  // The page as the program serves it, which needs no program any more.
  async saveReport() {
    const page = await fetch(addressWithToken("/report"));
    if (page.ok) saveFile(`${this.stem()}.report.html`, "text/html", await page.text());
  }
}
