// The rows that pass as a table, sorted by a column and in pages.

import { byId, element } from "../dom.js";
import { language, say } from "../words.js";
import { Pager } from "./atlas.js";

const PAGE = 40;

export class RowTable {
  // `actions.select(row)`
  constructor(study, actions) {
    Object.assign(this, { study, actions, sortedBy: null, sense: 1, page: 0 });
    this.pager = new Pager(byId("rows"), (page) => { this.page = page; this.draw(); });
    this.#head();
  }

  #head() {
    const header = (text, column, parts = [text]) => {
      const button = element("button", { type: "button", class: "link" }, ...parts);
      button.addEventListener("click", () => this.sort(column));
      const th = element("th", column && !column.words ? { class: "number" } : {}, button);
      return { th, column };
    };
    this.headers = [header(say("designs.design"), null), ...this.study.columns.map((column) => header(column.name, column, [column.label]))];
    document.querySelector("#rows thead").replaceChildren(element("tr", {}, ...this.headers.map(({ th }) => th)));
  }

  sort(column) {
    this.sense = this.sortedBy === column ? -this.sense : column?.wanted === "greatest" ? -1 : 1;
    this.sortedBy = column;
    this.filtered();
  }

  // After the filters or the order have changed: rows without a value last.
  filtered() {
    const values = this.sortedBy?.values ?? this.study.ids;
    const known = (row) => !Number.isNaN(values[row]);
    // The best first, as long as no column is chosen.
    const first = (row) => (this.sortedBy === null && this.sense > 0 && this.study.best.has(row) ? 0 : 1);
    this.rows = [...this.study.filters.rows].sort((a, b) => first(a) - first(b) || known(b) - known(a) || this.sense * (values[a] - values[b]) || a - b);
    for (const { th, column } of this.headers) {
      if (column === this.sortedBy) th.setAttribute("aria-sort", this.sense > 0 ? "ascending" : "descending");
      else th.removeAttribute("aria-sort");
    }
    this.page = 0;
    this.draw();
  }

  draw() {
    const pages = Math.ceil(this.rows.length / PAGE);
    this.pager.show(this.page, pages);
    byId("rows-rows").replaceChildren(...this.rows.slice(this.page * PAGE, (this.page + 1) * PAGE).map((row) => this.#row(row)));
    this.select();
  }

  #row(row) {
    const { ids, best, columns } = this.study;
    const open = element("button", { type: "button", class: "link", "aria-label": say("row.open", { n: ids[row] }) }, ids[row].toLocaleString(language));
    const star = best.has(row) ? [element("span", { class: "mark yes", title: say("row.best") }, " ★")] : [];
    const tr = element("tr", { "data-row": row }, element("td", {}, open, ...star),
      ...columns.map((column) => element("td", column.words ? {} : { class: "number" }, column.text(row))));
    tr.addEventListener("click", () => this.actions.select(row));
    return tr;
  }

  select() {
    for (const tr of byId("rows-rows").children) tr.classList.toggle("selected", Number(tr.dataset.row) === this.study.selected);
  }

  get csv() {
    const cell = (text) => (/[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    const { columns, ids } = this.study;
    const lines = [["id", ...columns.map((c) => cell(c.name))], ...this.rows.map((row) => [ids[row], ...columns.map((c) => cell(c.written(row)))])];
    return `${lines.map((line) => line.join(",")).join("\n")}\n`;
  }
}
