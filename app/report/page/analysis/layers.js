// The card of layers: which links lie in which, the pins that cross them, and what cannot share one.

import { byId, element } from "../dom.js";
import { sentence } from "../format.js";
import { keyword, say, term } from "../words.js";

const layerCell = (text, kind = "") => element("td", { class: kind }, ...(Array.isArray(text) ? text : [text]));
const layerRow = (...cells) => element("tr", {}, ...cells);
const layerHead = (id, names) => byId(id).tHead.replaceChildren(layerRow(...names.map((name) => element("th", { scope: "col" }, name))));
const linkNames = (names) => names.map((name) => keyword(name) ?? term(name)).join(", ") || "–";

// From the top layer down to the base.
function layerRows({ count, links, pins }) {
  const layers = Array.from({ length: count }, (_, i) => count - i);
  return [...layers.map((layer) => layerRow(layerCell(String(layer)), layerCell(linkNames(links.filter((link) => link.layer === layer).map(({ name }) => name))),
    layerCell(linkNames(pins.filter(({ crosses }) => crosses.includes(layer)).map(({ name }) => name))))), layerRow(layerCell(say("layers.base")), layerCell(term("frame")), layerCell("–"))];
}

function layerConflict({ links, pins, why, ...at }, driveText, goTo) {
  const place = at.first_at_deg ?? at.first_at;
  const parts = [...pins.map((name) => say("layers.pin", { name: term(name) })), ...links.map((name) => linkNames([name]))];
  if (place === undefined) return layerRow(layerCell(parts.join(" – ")), layerCell(say(`layers.${why}`)), layerCell("–"));
  const button = element("button", { type: "button", class: "link", title: say("landmarks.show") }, driveText(place));
  button.addEventListener("click", () => goTo(place));
  return layerRow(layerCell(parts.join(" – ")), layerCell(say(`layers.${why}`)), layerCell([button]));
}

// `layers` of a design, or nothing.
export function showLayers(layers, driveText, goTo) {
  byId("layers").hidden = !layers;
  if (!layers) return;
  byId("layers-count").textContent = layers.count === null ? say("layers.none", { links: linkNames(layers.blocked) }) : say("layers.fewest", { n: layers.count });
  layerHead("layers-stack", [say("layers.layer"), say("layers.links"), say("layers.crossing")]);
  byId("layers-stack").parentElement.hidden = layers.count === null;
  byId("layers-rows").replaceChildren(...(layers.count === null ? [] : layerRows(layers)));
  layerHead("layers-conflicts", [say("layers.apart"), say("layers.why"), say("layers.first_at", { drive: sentence(byId("drive-name").textContent) })]);
  byId("layers-conflicts").parentElement.hidden = layers.conflicts.length === 0;
  byId("conflict-rows").replaceChildren(...layers.conflicts.map((conflict) => layerConflict(conflict, driveText, goTo)));
}
