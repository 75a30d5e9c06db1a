// The tools as chips, each by a letter, and what is said of them.

import { byId, element, svg } from "../dom.js";
import { shortcut } from "../keys.js";
import { say } from "../words.js";
import { TOOLS } from "./tools.js";

const SIGNS = {
  move: "M12 3V21M3 12H21M9 6L12 3L15 6M9 18L12 21L15 18M6 9L3 12L6 15M18 9L21 12L18 15",
  link: "M7 17L17 7M5 19m-2.6 0a2.6 2.6 0 1 0 5.2 0a2.6 2.6 0 1 0 -5.2 0M19 5m-2.6 0a2.6 2.6 0 1 0 5.2 0a2.6 2.6 0 1 0 -5.2 0",
  pivot: "M12 5L6 16H18ZM3 16H21M6 16l-3 4M12 16l-3 4M18 16l-3 4M12 5m-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0",
  slider: "M5 8H19V16H5ZM2 19H22M7 19l-3 3M13 19l-3 3M19 19l-3 3M12 12m-1.5 0a1.5 1.5 0 1 0 3 0a1.5 1.5 0 1 0 -3 0",
  point: "M3 17C6 5 15 3 21 10M12 7m-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0",
  drive: "M19 12A7 7 0 1 1 14 5.3M14 2v4h4M12 12m-1.5 0a1.5 1.5 0 1 0 3 0a1.5 1.5 0 1 0 -3 0",
  load: "M4 20L19 5M19 12V5H12",
};

export class Toolbar {
  // `choose(tool)`.
  constructor(choose) {
    this.chips = Object.entries(TOOLS).map(([tool, { key }]) => {
      const chip = element("button", { type: "button", class: "chip build-tool", role: "radio", "data-tool": tool, title: say(`build.${tool}_hint`) },
        svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: SIGNS[tool] })), say(`build.${tool}`), element("kbd", { "aria-hidden": "true" }, key.toUpperCase()));
      chip.addEventListener("click", () => choose(tool));
      shortcut([key, key.toUpperCase()], key, `build.choose_${tool}`, () => choose(tool));
      return chip;
    });
    byId("tools").append(...this.chips);
    byId("tools").addEventListener("keydown", (event) => this.#step(event));
  }

  // Arrows go from chip to chip, as among radio buttons.
  #step(event) {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key], at = this.chips.indexOf(event.target);
    if (!step || at < 0) return;
    event.preventDefault();
    event.stopPropagation();
    const next = this.chips[(at + step + this.chips.length) % this.chips.length];
    next.focus();
    next.click();
  }

  show(tool) {
    for (const chip of this.chips) {
      chip.setAttribute("aria-checked", String(chip.dataset.tool === tool));
      chip.tabIndex = chip.dataset.tool === tool ? 0 : -1;
    }
    byId("tool-hint").textContent = say(`build.${tool}_hint`);
    byId("picture").dataset.hand = tool;
  }
}
