// The card of the bill of material: plates, pins and spacers as an export of the parts lists them.

import { element } from "../dom.js";
import { number } from "../format.js";
import { LENGTH_UNIT, say, sentenceOf } from "../words.js";
import { bodyRow, nameColumns, partNames } from "./rows.js";

// Each with the class of its column: a phone has no room for all.
const BILL_LENGTHS = { length: "number", width: "number wide", thickness: "number wide", outside: "number", bore: "number wide", stroke: "number wide" };

// "2", of several the range: "1–3".
function layersText(layers = []) {
  const [low, high] = [layers[0], layers.at(-1)];
  return low === undefined ? "–" : low === high ? String(low) : `${low}–${high}`;
}

const lengthHead = (name) => (LENGTH_UNIT ? `${say(`bill.${name}`)} [${LENGTH_UNIT}]` : say(`bill.${name}`));

export class BillCard {
  // `after`: the card before this one.
  constructor(after) {
    this.count = element("span", { class: "muted" });
    this.rows = element("tbody", { id: "bill-rows" });
    this.frame = element("div", { class: "table-frame" }, element("table", { "aria-labelledby": "bill-title" }, element("thead"), this.rows));
    this.notes = element("ul", { class: "muted", id: "bill-notes" });
    this.root = element("section", { class: "card", id: "bill", "aria-labelledby": "bill-title", hidden: "" },
      element("div", { class: "card-head" }, element("h2", { id: "bill-title" }, say("bill.title")), this.count), this.frame, element("p", { class: "muted" }, say("bill.hint")), this.notes);
    after.after(this.root);
  }

  // `bill` of the page's data, or nothing.
  show(bill) {
    this.root.hidden = !bill;
    if (!bill) return;
    const lengths = Object.keys(BILL_LENGTHS).filter((name) => bill.rows.some((row) => row[name] !== undefined));
    this.count.textContent = say("bill.layers_in_all", { n: bill.layers });
    nameColumns(this.frame, [[say("bill.item")], [say("bill.name")], [say("bill.quantity"), "number"], [say("bill.layers"), "number"], ...lengths.map((name) => [lengthHead(name), BILL_LENGTHS[name]])]);
    this.rows.replaceChildren(...bill.rows.map((row) => bodyRow(say(`bill.${row.item}`), partNames([row.name]), { number: String(row.quantity), kind: "number" }, { number: layersText(row.layers), kind: "number" },
      ...lengths.map((name) => ({ number: row[name] === undefined ? "–" : number(row[name], 6), kind: BILL_LENGTHS[name] })))));
    this.notes.hidden = !bill.notes?.length;
    this.notes.replaceChildren(...(bill.notes ?? []).map((note) => element("li", {}, sentenceOf(note))));
  }
}
