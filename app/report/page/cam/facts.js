// What is known of the cam chosen, its motion and its limits.

import { headRow } from "../checks.js";
import { byId, element, fact } from "../dom.js";
import { degrees, degreesShort, number, sentence } from "../format.js";
import { keyName, unitOfKey } from "../problem.js";
import { extremes, interpolate, locate } from "../sampling.js";
import { say, sentenceOf, term } from "../words.js";
import { JUMPS, STROKE_COLOURS } from "./sheets.js";

const LENGTH_NAMES = ["offset", "roller_radius", "centre_distance", "arm", "face_offset"];

const CLOSURES = ["groove", "conjugate", "constant-breadth"];

// The lengths that this type of follower has other than the radius of the base or prime circle.
function lengthsOf({ flat, knife, oscillating }) {
  return new Set([...(oscillating ? ["centre_distance", ...(flat ? ["face_offset"] : ["arm"])] : flat ? [] : ["offset"]), ...(flat || knife ? [] : ["roller_radius"])]);
}

// Of a roller's cam, base_radius is that of the prime circle, about which the pitch curve lies; that of the
// base circle, about which the profile lies, is less by the roller's.
const radiusKey = ({ flat, knife }) => (flat || knife ? "base_radius" : "prime_radius");

// The same of a follower as files name it.
export const radiusKeyOf = (type) => radiusKey({ flat: type.endsWith("flat"), knife: type.endsWith("knife") });

// A problem whose base radius bears the name of the circle that it is of.
export function withNamedRadius(problem) {
  if (!problem?.follower) return problem;
  const radius = radiusKeyOf(problem.follower.type);
  const named = (table) => Object.fromEntries(Object.entries(table).map(([key, value]) => [key === "base_radius" ? radius : key, value]));
  return Object.fromEntries(Object.entries(problem).map(([name, table]) => [name, table && /^(mechanism|bounds)$/.test(name) ? named(table) : table]));
}

export const radiusText = (kind, radius, digits) => say(`head.${radiusKey(kind)}`, { value: number(radius, digits) });

export function showCamDimensions({ drawn, kind, breadth }) {
  const used = lengthsOf(kind);
  const row = (key, value) => fact(say(`cam.${key}`), number(value, 7), String(value));
  const lengths = (dimensions) => [...row(radiusKey(kind), dimensions.base_radius),
    ...(used.has("roller_radius") ? row("base_radius", dimensions.base_radius - dimensions.roller_radius) : []),
    ...LENGTH_NAMES.filter((key) => used.has(key)).flatMap((key) => row(key, dimensions[key]))];
  byId("dimensions-list").replaceChildren(...fact(say("cam.follower"), sentence(say(`follower.${kind.follower}`))), ...(CLOSURES.includes(kind.closure) ? fact(say("cam.closed_by"), say(`closure.${kind.closure}`)) : []),
    ...lengths(drawn.dimensions),
    ...(drawn.second ? [element("dt", { class: "heading" }, say("cam.other")), element("dd", {}, ""), ...lengths(drawn.second.dimensions)] : []),
    ...(breadth === null ? [] : fact(say("cam.breadth"), number(breadth, 7))),
    ...fact(say("cam.rotation"), say(kind.clockwise ? "cam.clockwise" : "cam.counterclockwise")),
    ...(kind.oscillating ? fact(say("cam.side"), say(drawn.side > 0 ? "cam.trailing" : "cam.leading")) : []),
    ...(drawn.speed ? fact(say("cam.speed"), `${number(drawn.speed, 5)} rad/s`) : []), ...(drawn.preload ? fact(say("cam.preload"), number(drawn.preload, 6)) : []),
    ...fact(say("qualities.found_by"), sentenceOf(drawn.origin) || "–"));
  showProof(drawn.proof, kind);
}

// Chinese has a word of its own for an undercut cam.
export const camMetrics = (metrics) => metrics.map((metric) => (metric.name === "undercut" ? { ...metric, name: "cam_undercut" } : metric));

// Why no smaller cam is possible, in a sentence.
function showProof(proof, kind) {
  byId("proof").hidden = !proof;
  if (!proof) return;
  const limit = ({ deg, limit: key, bound }) => say("proof.limit", { limit: keyName(key, "constraints"), bound: number(bound, 6) + unitOfKey(key, "constraints"), angle: degrees(deg) });
  const { base_radius: radius, within, positions } = proof;
  const key = within ? (positions.length ? "proof.within_where" : "proof.within") : positions.length ? "proof.where" : "proof.text";
  byId("proof").textContent = say(key, { n: positions.length, name: say(`cam.${radiusKey(kind)}`).toLowerCase(), radius: number(radius, 7), within: within && sentenceOf(within), list: positions.map(limit).join(say("list.and")) });
}

const lawTitle = (law) => (/^\d/.test(law) ? say("segments.polynomial", { powers: law }) : sentence(term(law.replaceAll("-", " "))));

// A row for each segment; its button goes to its beginning.
export function showSegments({ drawn, kind }, goTo) {
  const factors = drawn.segments.some((s) => s.factors);
  const unit = kind.oscillating ? "°" : "";
  byId("segments-table").tHead.replaceChildren(headRow([[say("segments.law")], [say("segments.from"), "number"], [say("segments.over"), "number"], [say("segments.rise"), "number"],
    ...(factors ? [[say("segments.velocity"), "number"], [say("segments.acceleration"), "number"], [say("segments.jerk"), "number wide"]] : []), [say("segments.beginning"), "wide"]]));
  const factor = (segment, key) => {
    const [own, printed] = [segment.factors?.[key], segment.handbook?.[key]];
    const text = (v) => (v === null ? "∞" : number(v, 5));
    const side = key === "jerk" ? "number wide" : "number";
    if (own === undefined || segment.law === "dwell") return element("td", { class: side }, "–");
    return element("td", { class: side }, text(own), ...(printed === undefined ? [] : [element("span", { class: "printed", title: say("segments.handbook") }, text(printed))]));
  };
  byId("segments-rows").replaceChildren(...drawn.segments.map((segment) => {
    const button = element("button", { type: "button", class: "link", title: say("segments.show") }, lawTitle(segment.law));
    button.addEventListener("click", () => goTo(segment.from_deg));
    const sense = segment.rise > 0 ? "rise" : segment.rise < 0 ? "return" : "dwell";
    return element("tr", {}, element("td", {}, element("span", { class: "landmark" }, element("span", { class: "dot", style: `background:var(${STROKE_COLOURS[sense]})` }), button)),
      element("td", { class: "number" }, degreesShort(segment.from_deg)), element("td", { class: "number" }, degreesShort(segment.over_deg)), element("td", { class: "number" }, `${number(segment.rise, 6)}${unit}`),
      ...(factors ? ["velocity", "acceleration", "jerk"].map((key) => factor(segment, key)) : []),
      element("td", { class: "wide" }, jumpText(kind.jumps, segment.from_deg)));
  }));
  byId("factors-note").hidden = !factors;
  const [count, shown] = [drawn.segment_count, drawn.segments.length];
  byId("segments-count").textContent = `${say(shown < count ? "segments.count_shown" : "segments.count", { n: count, shown })} · ${kind.jump_count ? say("segments.jumps", { n: kind.jump_count }) : say("segments.no_jump")}`;
}

function jumpText(jumps, deg) {
  const here = jumps.filter((jump) => Math.abs(jump.deg - deg) < 1e-4 || (deg === 0 && Math.abs(jump.deg - 360) < 1e-4));
  return here.length ? here.map((jump) => say(`jump.${JUMPS[jump.order]}`, { before: number(jump.before, 4), after: number(jump.after, 4) })).join(say("list.semicolon")) : say("segments.smooth");
}

// What is plotted as numbers: now, least and greatest.
export class CamValues {
  constructor() {
    byId("values").tHead.replaceChildren(headRow([[say("values.quantity")], [say("values.now"), "number"], [say("values.least"), "number"], [say("values.at"), "number wide"], [say("values.greatest"), "number"], [say("values.at"), "number wide"]]));
  }

  build(sheets) {
    this.rows = sheets.flatMap((sheet) => sheet.lines.map((line) => ({ sheet, line, cell: element("td", { class: "number now" }) })));
    byId("values-rows").replaceChildren(...this.rows.map(({ sheet, line, cell }) => {
      const [least, greatest] = extremes(line.y);
      const place = (value) => (value === null ? "–" : degrees(sheet.x[line.y.indexOf(value)], 1));
      return element("tr", {}, element("td", {}, sheet.lines.length > 1 && line.dash ? say("values.other_cam", { title: sheet.title }) : sheet.title), cell,
        element("td", { class: "number" }, number(least, 5)), element("td", { class: "number wide" }, place(least)), element("td", { class: "number" }, number(greatest, 5)), element("td", { class: "number wide" }, place(greatest)));
    }));
  }

  move(deg) { for (const { sheet, line, cell } of this.rows) cell.textContent = number(interpolate(line.y, locate(sheet.x, deg)), 6); }
}

export function camCsv({ first: { table } }) {
  const names = Object.keys(table);
  const lines = [names.map((name) => (name === "deg" ? "cam_deg" : name)), ...table.deg.map((_, i) => names.map((name) => table[name][i] ?? ""))];
  return `${lines.map((row) => row.join(",")).join("\n")}\n`;
}
