// Which rows pass: of each column a range of its values, or a set of its words.

import { byId, element } from "../dom.js";
import { number } from "../format.js";
import { say } from "../words.js";

export class Filters {
  constructor(columns, count) {
    Object.assign(this, { columns, count, chosen: new Map(), passes: new Uint8Array(count).fill(1) });
    this.rows = d3Range(count);
  }

  get any() { return this.chosen.size > 0; }

  // `range`: [from, to], or null for all values. Words are the numbers of their levels.
  choose(column, range) {
    if (range === null || (range[0] <= column.least && range[1] >= column.greatest && !column.missing)) this.chosen.delete(column);
    else this.chosen.set(column, range);
    this.#apply();
  }

  clear() { this.chosen.clear(); this.#apply(); }

  #apply() {
    const ranges = [...this.chosen];
    this.rows = [];
    for (let row = 0; row < this.count; ++row) {
      const passes = ranges.every(([{ values }, [from, to]]) => values[row] >= from && values[row] <= to);
      this.passes[row] = passes ? 1 : 0;
      if (passes) this.rows.push(row);
    }
  }
}

export const d3Range = (count) => Array.from({ length: count }, (_, i) => i);

// The table of columns: whether each is drawn, and the ends of its filter for the keyboard.
export class ColumnTable {
  // `actions.filter(column, range)`, `actions.show(column, shown)`
  constructor(columns, actions) {
    this.rows = columns.map((column) => ({ column, ...this.#row(column, actions) }));
    byId("columns-rows").replaceChildren(...this.rows.map(({ row }) => row));
  }

  #row(column, actions) {
    const shown = element("input", { type: "checkbox", "aria-label": say("filters.show", { name: column.name }) });
    shown.addEventListener("change", () => actions.show(column, shown.checked));
    const ends = column.words ? this.#words(column) : this.#numbers(column);
    const range = () => ends.map((end, i) => (end.value === "" ? [-Infinity, Infinity][i] : Number(end.value)));
    for (const end of ends) end.addEventListener("change", () => actions.filter(column, ends.every((e) => e.value === "") ? null : range()));
    const clear = element("button", { type: "button", class: "link", "aria-label": say("filters.clear_of", { name: column.name }) }, say("filters.clear"));
    clear.addEventListener("click", () => actions.filter(column, null));
    const wanted = column.wanted ? element("span", { class: "wanted" }, ` ${say(column.wanted === "least" ? "filters.least" : "filters.greatest")}`) : "";
    const cells = [[element("span", { title: column.name }, column.label), wanted], [shown], [ends[0]], [ends[1]], [clear]];
    return { row: element("tr", {}, ...cells.map((parts) => element("td", {}, ...parts))), shown, ends, clear };
  }

  #numbers(column) {
    return ["least", "greatest"].map((end) => element("input", { type: "number", step: "any", placeholder: number(column[end], 4), "aria-label": say(`filters.${end}_of`, { name: column.name }) }));
  }

  #words(column) {
    return ["first", "last"].map((end) => element("select", { "aria-label": say(`filters.${end}_of`, { name: column.name }) },
      element("option", { value: "" }, say("filters.any")), ...column.words.map((_, i) => element("option", { value: i }, column.show(i)))));
  }

  update(filters, isShown) {
    for (const { column, shown, ends, clear } of this.rows) {
      const range = filters.chosen.get(column);
      shown.checked = isShown(column);
      clear.hidden = !range;
      ends.forEach((end, i) => { if (end !== document.activeElement || !range) end.value = range && Number.isFinite(range[i]) ? Number(range[i].toPrecision(6)) : ""; });
    }
  }
}
