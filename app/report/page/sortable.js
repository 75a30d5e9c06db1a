// Tables sorted by any of their columns: up, down, and as they were.

import { element } from "./dom.js";
import { SUPERSCRIPTS } from "./format.js";
import { language } from "./words.js";

const collator = new Intl.Collator(language, { numeric: true });
const SUPERSCRIPT_DIGITS = Object.fromEntries(Object.entries(SUPERSCRIPTS).map(([digit, sign]) => [sign, digit]));

// The first number of a cell as the page writes them ("−4.02×10⁻⁴", "1,834", "101–142°"), else its
// words; null of an empty one.
function sortValue(text) {
  const bare = text.trim();
  if (bare === "" || bare === "–") return null;
  const [, sign, digits, power] = /^(?:[^\d−∞-]*\s)?([−-]?)(\d[\d,]*\.?\d*|∞)(?:×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?/.exec(bare) ?? [];
  if (digits === undefined) return bare;
  const size = digits === "∞" ? Infinity : Number(digits.replaceAll(",", "")) * 10 ** Number([...(power ?? "0")].map((c) => SUPERSCRIPT_DIGITS[c] ?? c).join(""));
  return sign ? -size : size;
}

// Numbers by size before words; cells without a value come last whichever way is sorted.
function inOrder(p, q, sense) {
  if (p === null || q === null) return (p === null) - (q === null);
  if (typeof p === "number" && typeof q === "number") return sense * (p - q);
  if (typeof p !== typeof q) return typeof p === "number" ? -1 : 1;
  return sense * collator.compare(p, q);
}

class Sortable {
  // `byBody`: a row of the table is a tbody of its own.
  constructor(table, { byBody = false } = {}) {
    Object.assign(this, { table, byBody, column: null, sense: 1 });
    this.watch = new MutationObserver(() => this.#renewed());
    this.#renewed();
  }

  get holder() { return this.byBody ? this.table : this.table.tBodies[0]; }
  get #rows() { return this.byBody ? [...this.table.tBodies] : [...this.holder.rows]; }

  // The page has written the head or the rows anew.
  #renewed() {
    this.watch.disconnect();
    const rows = this.#rows;
    if (!this.order || rows.length !== this.order.length || rows.some((row) => !this.order.includes(row))) this.order = rows;
    [...this.table.tHead.rows[0]?.cells ?? []].forEach((th, i) => this.#offer(th, i));
    this.#sort();
  }

  #offer(th, index) {
    if (th.querySelector("button") || !th.textContent) return;
    const button = element("button", { type: "button", class: "sort" }, ...th.childNodes);
    button.addEventListener("click", () => this.choose(index));
    th.append(button);
  }

  choose(index) {
    if (this.column !== index) [this.column, this.sense] = [index, 1];
    else if (this.sense === 1) this.sense = -1;
    else this.column = null;
    this.watch.disconnect();
    this.#sort();
  }

  #valueOf(row) {
    const cell = (this.byBody ? row.rows[0] : row).cells[this.column];
    if (cell?.dataset.sort) return Number(cell.dataset.sort);
    return cell ? sortValue(cell.textContent) : null;
  }

  #sort() {
    [...this.table.tHead.rows[0]?.cells ?? []].forEach((th, i) => {
      if (i === this.column) th.setAttribute("aria-sort", this.sense > 0 ? "ascending" : "descending");
      else th.removeAttribute("aria-sort");
    });
    const values = new Map(this.column === null ? [] : this.order.map((row) => [row, this.#valueOf(row)]));
    const sorted = this.column === null ? this.order : [...this.order].sort((p, q) => inOrder(values.get(p), values.get(q), this.sense));
    if (sorted.some((row, i) => row !== this.#rows[i])) this.holder.append(...sorted);
    for (const part of [this.table.tHead, this.holder]) this.watch.observe(part, { childList: true });
  }
}

// Every table of the page that is not paged.
export function makeSortable() {
  for (const table of document.querySelectorAll("table")) {
    if (table.tHead && !table.closest("#rows, #columns") && !table.classList.contains("of-plot")) new Sortable(table, { byBody: table.classList.contains("designs") });
  }
}
