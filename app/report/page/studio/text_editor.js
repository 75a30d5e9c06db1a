// A text with the numbers of its lines, and with faults beside them.

import { byId, element } from "../dom.js";
import { sentence } from "../format.js";
import { say, sentenceOf } from "../words.js";

export class TextEditor {
  constructor(onChange) {
    Object.assign(this, { area: byId("text"), faults: [], original: "", plain: "", crlf: false });
    this.area.addEventListener("input", () => { this.#number(); onChange(); });
    this.area.addEventListener("scroll", () => this.#follow());
    new ResizeObserver(() => this.#follow()).observe(this.area);
  }

  // As it stands in the file: a field has lines that end in \n alone.
  get text() {
    const { value } = this.area;
    if (value === this.plain) return this.original;
    return this.crlf ? value.replaceAll("\n", "\r\n") : value;
  }

  set text(text) {
    this.area.value = text;
    Object.assign(this, { original: text, plain: this.area.value, crlf: 2 * text.split("\r\n").length > text.split("\n").length + 1 });
    this.area.setSelectionRange(0, 0);
    this.area.scrollTo(0, 0);
    this.show([]);
  }

  // Shows `faults` ({line, column, message}) at their lines and in a list.
  show(faults) {
    this.faults = faults;
    this.#number();
    byId("faults").replaceChildren(...faults.map((fault) => this.#row(fault)));
  }

  #row({ line, column, message }) {
    const said = sentence(sentenceOf(message));
    const button = element("button", { type: "button", class: "link" }, say("studio.place", { line, column }));
    button.addEventListener("click", () => this.#goTo(line, column));
    return element("li", {}, button, " ", element("span", said === sentence(message) ? { lang: "en" } : {}, said));
  }

  #goTo(line, column) {
    const lines = this.area.value.split("\n");
    // Columns count code points.
    const before = lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0);
    const at = before + [...(lines[line - 1] ?? "")].slice(0, column - 1).join("").length;
    this.area.focus();
    this.area.setSelectionRange(at, at);
    this.area.scrollTop = Math.max(0, (line - 4) * this.#lineHeight());
  }

  #lineHeight() { return parseFloat(getComputedStyle(this.area).lineHeight); }

  // Lines as they are, unseen, each with what is wrong behind its end: so a message stands where the line ends, whatever
  // its letters.
  #number() {
    const lines = this.area.value.split("\n");
    const byLine = new Map();
    for (const fault of this.faults) byLine.set(fault.line, [...(byLine.get(fault.line) ?? []), fault]);
    byId("lines").replaceChildren(...lines.map((_, i) => element("span", byLine.has(i + 1) ? { class: "faulty" } : {}, `${i + 1}\n`)));
    byId("marks").replaceChildren(...lines.flatMap((text, i) => {
      const faults = byLine.get(i + 1);
      if (!faults) return [`${text}\n`];
      const said = faults.map(({ message }) => sentenceOf(message)).join(say("list.semicolon"));
      return [element("span", { class: "faulty" }, text, element("em", {}, `  ${said}`)), "\n"];
    }));
    this.#follow();
  }

  #follow() {
    byId("lines").style.transform = `translateY(${-this.area.scrollTop}px)`;
    byId("marks").style.transform = `translate(${-this.area.scrollLeft}px, ${-this.area.scrollTop}px)`;
  }
}
