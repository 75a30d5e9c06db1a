// Cards that still show the design as it was found while another is in the picture: grey, and saying so.

import { byId, element } from "./dom.js";
import { say } from "./words.js";

// The line below the title is of the original too.
export function markOriginal(ids, on) {
  const summary = document.querySelector(".page-head .summary");
  summary.classList.toggle("of-original", on);
  summary.dataset.original = on ? ` · ${say("edit.of_original")}` : "";
  for (const card of ids.map((id) => byId(id))) {
    card.classList.toggle("of-original", on);
    const title = card.querySelector("h2");
    if (on) title.dataset.original = ` · ${say("edit.of_original")}`; else delete title.dataset.original;
  }
}

// In the place of the button that edits, where a page has nothing to edit with.
export function offerNoEdit(why) {
  document.querySelector("#stage .card-head").append(element("button", { type: "button", class: "edit-toggle", disabled: "", title: why }, say("edit.toggle")));
}
