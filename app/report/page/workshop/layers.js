// The card of layers: which links lie in which, the pins that cross them, and what cannot share one.

import { byId, element } from "../dom.js";
import { sentence } from "../format.js";
import { keyword, say, term } from "../words.js";
import { bodyRow, nameColumns, partNames } from "./rows.js";

// From the top layer down to the base.
function layerRows({ count, links, pins }) {
  const layers = Array.from({ length: count }, (_, i) => count - i);
  return [...layers.map((layer) => bodyRow(String(layer), partNames(links.filter((link) => link.layer === layer).map(({ name }) => name)),
    partNames(pins.filter(({ crosses }) => crosses.includes(layer)).map(({ name }) => name)))), bodyRow(say("layers.base"), keyword("frame") ?? term("frame"), "–")];
}

function layerConflict({ links, pins, why, ...at }, { driveText, goTo }) {
  const place = at.first_at_deg ?? at.first_at;
  const parts = [...pins.map((name) => say("layers.pin", { name: term(name) })), ...links.map((name) => partNames([name]))];
  if (place === undefined) return bodyRow(parts.join(" – "), say(`layers.${why}`), "–");
  const button = element("button", { type: "button", class: "link", title: say("landmarks.show") }, driveText(place));
  button.addEventListener("click", () => goTo(place));
  return bodyRow(parts.join(" – "), say(`layers.${why}`), button);
}

export class LayersCard {
  // `after`: the card before this one. `page`: goTo(drive), driveText(drive).
  constructor(after, page) {
    this.page = page;
    this.count = element("span", { class: "muted", id: "layers-count" });
    const table = (id, rows) => element("table", { id, "aria-labelledby": "layers-title" }, element("thead"), element("tbody", { id: rows }));
    this.stack = element("div", { class: "table-frame" }, table("layers-stack", "layers-rows"));
    this.conflicts = element("div", { class: "table-frame" }, table("layers-conflicts", "conflict-rows"));
    this.root = element("section", { class: "card", id: "layers", "aria-labelledby": "layers-title", hidden: "" },
      element("div", { class: "card-head" }, element("h2", { id: "layers-title" }, say("layers.title")), this.count), this.stack, this.conflicts);
    after.after(this.root);
  }

  // `layers` of a design, or nothing.
  show(layers) {
    this.root.hidden = !layers;
    if (!layers) return;
    const { count, blocked, conflicts } = layers;
    this.count.textContent = count === null ? say("layers.none", { links: partNames(blocked) }) : say("layers.fewest", { n: count });
    nameColumns(this.stack, [[say("layers.layer")], [say("layers.links")], [say("layers.crossing")]]);
    this.stack.hidden = count === null;
    byId("layers-rows").replaceChildren(...(count === null ? [] : layerRows(layers)));
    nameColumns(this.conflicts, [[say("layers.apart")], [say("layers.why")], [say("layers.first_at", { drive: sentence(byId("drive-name").textContent) })]]);
    this.conflicts.hidden = conflicts.length === 0;
    byId("conflict-rows").replaceChildren(...conflicts.map((conflict) => layerConflict(conflict, this.page)));
  }
}
