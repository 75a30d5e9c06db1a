// What is known of the gears chosen, in tables.

import { headRow, metricName, showMetrics } from "../checks.js";
import { byId, element } from "../dom.js";
import { factText } from "../fact_text.js";
import { number, sentence } from "../format.js";
import { say, term } from "../words.js";

// Whether a fact of a gear tells of something wrong.
const GEAR_FAULTS = { undercut: (value) => value === true, interferes: (value) => value === true, tip_thickness: (value) => value < 0, tip_clearance: (value) => value < 0 };
export const GEARS = ["pinion", "worm", "wheel", "rack"];
const OTHER_NAMES = { worm: { wheel: "worm_wheel" }, internal: { wheel: "ring" }, rack: { rack: "its_rack" } };
export const gearName = (gear, gearing) => say(`gear.${OTHER_NAMES[gearing]?.[gear] ?? gear}`);

// Facts of each gear beside one another, and those that are of neither.
export function showGears(metrics, gearing) {
  const of = (gear) => metrics.filter(({ name }) => name.startsWith(`${gear}.`)).map(({ name, value }) => [name.slice(gear.length + 1), value]);
  const tables = GEARS.map((gear) => ({ gear, values: new Map(of(gear)) })).filter(({ values }) => values.size);
  byId("dimensions").hidden = tables.length === 0;
  if (tables.length) byId("gears").tHead.replaceChildren(headRow([[say("values.quantity")], ...tables.map(({ gear }) => [gearName(gear, gearing), "number"])]));
  const names = [...new Set(tables.flatMap(({ values }) => [...values.keys()]))];
  byId("gears-rows").replaceChildren(...names.map((name) => element("tr", {}, element("td", {}, metricName(name)), ...tables.map(({ values }) => gearCell(name, values.get(name))))));
  showMetrics(metrics.filter(({ name }) => !GEARS.some((gear) => name.startsWith(`${gear}.`))));
}

// Specific sliding is infinite on a base circle.
function gearCell(name, value) {
  const text = value === undefined ? "–" : value === null && name.startsWith("sliding") ? "−∞" : factText(value, /_deg$/.test(name) ? "deg" : "");
  return element("td", { class: `number${GEAR_FAULTS[name]?.(value) ? " fault" : ""}`, ...(typeof value === "number" ? { title: String(value) } : {}) }, text);
}

// The table of the flank's points that the result has.
export function showFlank(columns) {
  byId("table").hidden = !columns?.length;
  if (!columns?.length) return;
  const title = (name) => (name === "is_involute" ? say("gear.flank_part") : sentence(term(name.replace(/_deg$/, "").replaceAll("_", " "))));
  // Places are left out where there is little room.
  const classOf = (name) => (name === "x" || name === "y" ? "number wide" : "number");
  byId("values").tHead.replaceChildren(headRow(columns.map(({ name }) => [/_deg$/.test(name) ? say("unit.axis", { name: title(name), unit: "°" }) : title(name), classOf(name)])));
  byId("values-rows").replaceChildren(...columns[0].values.map((_, i) => element("tr", {}, ...columns.map(({ name, values }) =>
    element("td", { class: classOf(name) }, name === "is_involute" ? say(values[i] ? "gear.part_involute" : "gear.part_fillet") 
      : number(values[i], 7))))));
}

export const flankCsv = (columns) => `${[columns.map(({ name }) => name), ...columns[0].values.map((_, i) => columns.map(({ values }) => values[i] ?? ""))].map((row) => row.join(",")).join("\n")}\n`;
