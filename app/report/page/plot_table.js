// A plot as a table of numbers, for who cannot see it or wants to read it off.

import { element } from "./dom.js";
import { number } from "./format.js";
import { say } from "./words.js";

const MOST_TABLE_ROWS = 37;

function plotTable(sheet) {
  const step = sheet.stems ? 1 : Math.max(1, (sheet.x.length - 1) / (MOST_TABLE_ROWS - 1));
  const rows = Array.from({ length: Math.floor((sheet.x.length - 1) / step) + 1 }, (_, i) => Math.round(i * step));
  const names = [sheet.xLabel, ...sheet.lines.map((line) => line.label ?? sheet.title)];
  return element("div", { class: "table-frame", tabindex: "0", role: "group", "aria-label": sheet.title },
    element("table", { class: "of-plot" }, element("thead", {}, element("tr", {}, ...names.map((name) => element("th", { scope: "col", class: "number" }, name)))),
      element("tbody", {}, ...rows.map((i) => element("tr", {}, ...[sheet.x[i], ...sheet.lines.map((line) => line.y[i])].map((v) => element("td", { class: "number" }, number(v, 6))))))));
}

// The button that puts a table in the place of the plot in `box`, and back.
export function tableButton(sheet, box) {
  const button = element("button", { type: "button", class: "link as-table", "aria-pressed": "false" }, say("plot.as_table"));
  let table = null;
  button.addEventListener("click", () => {
    const on = table === null;
    if (on) box.after(table = plotTable(sheet)); else { table.remove(); table = null; }
    box.hidden = on;
    button.setAttribute("aria-pressed", String(on));
  });
  return button;
}
