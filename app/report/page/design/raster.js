// What a search on a raster found, beside the optimum without a raster and that one rounded.

import { byId, element, fact } from "../dom.js";
import { degreesShort, number } from "../format.js";
import { LENGTH_UNIT, say } from "../words.js";

// Facts that this card shows.
export const ofRaster = (name) => /^(raster|rounded|continuous)_/.test(name);

const share = (part) => say("tolerance.percent", { value: number(100 * part, 3) });

// Bars to a scale of powers of ten: errors differ by orders. The least takes a fifth of the room.
function barWidths(values) {
  const known = values.filter((value) => value > 0).map(Math.log10);
  const [low, high] = [Math.min(...known), Math.max(...known)];
  return values.map((value) => (value > 0 ? (high > low ? 20 + (80 * (Math.log10(value) - low)) / (high - low) : 100) : 0));
}

// What is best on the raster: an error, of straight lines also a length or a size over the length, of cams a size.
const MEASURES = { error: say("raster.error"), error_deg: say("raster.error"), error_relative: say("raster.error_relative"), length: say("raster.length"), size: say("raster.size") };

// `angular`: an error is one of angles; `sizeUnit`: of a size, which mostly is over a length.
export function showRaster(facts, { angular = false, sizeUnit = "" } = {}) {
  const measure = Object.keys(MEASURES).find((one) => facts?.[`raster_${one}`] !== undefined);
  byId("raster").hidden = !measure;
  if (!measure) return;
  const unit = measure === "size" ? sizeUnit : measure === "error_relative" ? "" : LENGTH_UNIT ?? "";
  byId("raster-measure").textContent = say("raster.measure", { measure: MEASURES[measure] });
  const text = (value) => (measure === "error_deg" || (angular && measure === "error") ? degreesShort(value, 4) : `${number(value, 4)} ${unit}`.trim());
  const [continuous, best, rounded] = ["continuous", "raster", "rounded"].map((of) => facts[`${of}_${measure}`]);
  const rows = [["continuous", continuous], ["on_raster", best], ["rounded", rounded]].filter(([, value]) => typeof value === "number");
  const widths = barWidths(rows.map(([, value]) => value));
  byId("raster-bars").replaceChildren(...rows.map(([key, value], i) => {
    const broken = key === "rounded" && facts.rounded_feasible === false;
    const ratio = continuous > 0 && key !== "continuous" ? `×${number(value / continuous, 3)}` : "";
    return element("div", { class: `contribution ${key}`, role: "listitem", "data-error": value },
      element("span", { class: "name" }, say(`raster.${key}`), ...(broken ? [element("small", { class: "missed" }, say("raster.infeasible"))] : [])),
      element("span", { class: "track" }, element("span", { class: "bar", style: `width:${widths[i].toFixed(1)}%` })), element("span", { class: "number" }, text(value)), element("span", { class: "number share" }, ratio));
  }));
  const { raster_combinations: all, raster_covered: covered, raster_evaluated: evaluated, raster_boxes: boxes, raster_bound: bound, raster_gap: gap } = facts;
  const pairs = [["raster.bound", typeof bound === "number" ? text(bound) : null], ["raster.gap", typeof gap === "number" ? share(gap) : null],
    ["raster.covered", all > 0 ? say("raster.covered_of", { covered: number(covered, 3), all: number(all, 3), share: share(covered / all) }) : null],
    ["raster.evaluated", typeof evaluated === "number" ? evaluated.toLocaleString() : null], ["raster.boxes", boxes > 0 ? boxes.toLocaleString() : null],
    ["raster.proven", say(facts.raster_proven ? "raster.is_proven" : facts.raster_complete ? "raster.is_complete" : "raster.is_open")]];
  byId("raster-list").replaceChildren(...pairs.filter(([, value]) => value !== null).map(([key, value]) => element("div", {}, ...fact(say(key), value))));
}
