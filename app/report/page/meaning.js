// Figures about the computation rather than the mechanism: they stand behind "More", each
// with what it means beside the pointer and in a dialog.

import { element, fact } from "./dom.js";
import { say } from "./words.js";

const FIGURES = ["found_by", "precision_residual", "condition", "chance_of_unseen_minimum", "best_hits", "closure_residual", "power_residual", "energy_residual"];

export const isOfComputation = (key) => FIGURES.includes(key);

// Puts `rows`, of [key, name, text, whole value], behind "More" at the foot of a card; without rows there is none.
export function showMore(card, rows) {
  card.querySelector(".more")?.remove();
  if (rows.length === 0) return;
  const open = element("button", { type: "button", class: "link", "aria-haspopup": "dialog" }, say("more.meaning"));
  open.addEventListener("click", () => explain(rows));
  card.append(element("details", { class: "more" }, element("summary", { title: say("more.title") }, say("more")),
    element("dl", {}, ...rows.flatMap(([key, name, text, whole]) => {
      const [dt, dd] = fact(name, text, whole === undefined ? undefined : String(whole));
      dt.title = say(`meaning.${key}`);
      return [dt, dd];
    })), open));
}

function explain(rows) {
  const close = element("button", { type: "button", class: "chip" }, say("keys.close"));
  const dialog = element("dialog", { "aria-label": say("more.meaning") }, element("h2", {}, say("more.meaning")),
    element("dl", { class: "meanings" }, ...rows.flatMap(([key, name]) => [element("dt", {}, name), element("dd", {}, say(`meaning.${key}`))])), close);
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
