// How the reader wants the page: light or dark, and in which language.

import { byId, element } from "./dom.js";
import { language, LANGUAGES, remember, remembered, say, WORDS } from "./words.js";

const darkWanted = matchMedia("(prefers-color-scheme: dark)");

// "light" or "dark": as chosen, else as the system is.
function wantedTheme() {
  const chosen = remembered("theme");
  return chosen === "light" || chosen === "dark" ? chosen : darkWanted.matches ? "dark" : "light";
}

const applyTheme = (theme = wantedTheme()) => { document.documentElement.dataset.theme = theme; };

// Calls `redraw` whenever colours change, for what is drawn as a bitmap. Paper is white.
export function followTheme(redraw) {
  const change = (theme) => { applyTheme(theme); redraw(); };
  darkWanted.addEventListener("change", () => change());
  byId("theme").addEventListener("change", (event) => { remember("theme", event.target.value); change(); });
  // What is drawn as a bitmap is drawn as wide as the paper.
  const paper = (on) => document.documentElement.classList.toggle("printing", on);
  addEventListener("beforeprint", () => { paper(true); change("light"); });
  addEventListener("afterprint", () => { paper(false); change(); });
}

function offerAppearance() {
  const themes = ["auto", "light", "dark"].map((theme) => element("option", { value: theme }, say(`theme.${theme}`)));
  byId("theme").append(...themes);
  byId("theme").value = remembered("theme") || "auto";
  byId("language").append(...LANGUAGES.map((tag) => element("option", { value: tag, lang: tag }, WORDS[tag].name)));
  byId("language").value = language;
  byId("language").addEventListener("change", (event) => {
    remember("language", event.target.value);
    location.hash = [event.target.value, ...location.hash.slice(1).split("&").filter((part) => part && !LANGUAGES.includes(part))].join("&");
    location.reload();
  });
  byId("print").addEventListener("click", () => print());
}

applyTheme();
offerAppearance();
