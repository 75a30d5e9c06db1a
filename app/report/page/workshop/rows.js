// Rows of the tables of a workshop.

import { headRow } from "../checks.js";
import { element } from "../dom.js";
import { keyword, say, term } from "../words.js";

// A cell is a text, an element, or a number as a text with the class of its column: { number: "12", kind: "number" }.
export const bodyRow = (...cells) => element("tr", {}, ...cells.map((cell) => (cell.number === undefined ? element("td", {}, cell) : element("td", { class: cell.kind }, cell.number))));

// `names`: each with the class of its column, if it has one.
export const nameColumns = (frame, names) => frame.querySelector("thead").replaceChildren(headRow(names));

// Links and pins in the reader's words.
export const partNames = (names) => names.map((name) => keyword(name) ?? term(name)).join(say("list.comma")) || "–";
