// What is known of the cam chosen, its motion and its limits.

const LENGTH_NAMES = [["base_radius", "Base radius"], ["offset", "Offset"], ["roller_radius", "Roller radius"], ["centre_distance", "Centre distance"], ["arm", "Arm"], ["face_offset", "Offset of the face"]];

const CLOSURES = { groove: "a groove", conjugate: "a conjugate cam", "constant-breadth": "constant breadth" };
const FOLLOWERS = { "translating-roller": "translating roller", "translating-flat": "translating flat face", "translating-knife": "translating knife edge",
  "oscillating-roller": "oscillating roller", "oscillating-flat": "oscillating flat face" };

// The lengths that this type of follower has.
function lengthsOf({ flat, knife, oscillating }) {
  return new Set(["base_radius", ...(oscillating ? ["centre_distance", ...(flat ? ["face_offset"] : ["arm"])] : flat ? [] : ["offset"]), ...(flat || knife ? [] : ["roller_radius"])]);
}

function showCamDimensions({ drawn, kind, breadth }) {
  const used = lengthsOf(kind);
  const lengths = (dimensions) => LENGTH_NAMES.filter(([key]) => used.has(key)).flatMap(([key, name]) => fact(name, number(dimensions[key], 7), String(dimensions[key])));
  byId("dimensions-list").replaceChildren(...fact("Follower", sentence(FOLLOWERS[kind.follower])), ...(CLOSURES[kind.closure] ? fact("Closed by", CLOSURES[kind.closure]) : []),
    ...lengths(drawn.dimensions),
    ...(drawn.second ? [element("dt", { class: "heading" }, "Other cam"), element("dd", {}, ""), ...lengths(drawn.second.dimensions)] : []),
    ...(breadth === null ? [] : fact("Breadth", number(breadth, 7))),
    ...fact("Rotation", kind.clockwise ? "clockwise" : "counter-clockwise"),
    ...(kind.oscillating ? fact("Side of the arm", drawn.side > 0 ? "trailing" : "leading") : []),
    ...(drawn.speed ? fact("Speed", `${number(drawn.speed, 5)} rad/s`) : []), ...(drawn.preload ? fact("Preload", number(drawn.preload, 6)) : []),
    ...fact("Found by", drawn.origin || "–"));
  showProof(drawn.proof);
}

// Why no smaller cam is possible, in a sentence.
function showProof(proof) {
  byId("proof").hidden = !proof;
  if (!proof) return;
  const limit = ({ deg, limit: key, bound }) => `${key} = ${number(bound, 6)} at cam angle ${degrees(deg)}`;
  const where = proof.positions.length ? `: ${proof.positions.map(limit).join(" and ")} ${proof.positions.length > 1 ? "allow" : "allows"} nothing smaller` : "";
  byId("proof").textContent = `Proved: no base radius below ${number(proof.base_radius, 7)} keeps the limits${proof.within ? ` with ${proof.within}` : ""}${where}.`;
}

// A metric's name in words: "Greatest pressure angle in the return" of "pressure_angle_deg_max_return".
function metricName(name) {
  const words = (text) => text.replace(/_deg(?=_|$)/, "").replaceAll("_", " ");
  const [, of, side, stroke] = /^(.*)_(min|max)(?:_(rise|return))?$/.exec(name) ?? [];
  return side ? `${side === "max" ? "Greatest" : "Least"} ${words(of)}${stroke ? ` in the ${stroke}` : ""}` : sentence(words(name));
}

function showMetrics({ drawn }) {
  const places = new Map(drawn.metrics.filter(({ name }) => name.endsWith("_at_deg")).map(({ name, value }) => [name.replace(/_at_deg$/, ""), value]));
  const rows = drawn.metrics.filter(({ name }) => !name.endsWith("_at_deg")).flatMap(({ name, value }) => {
    const text = factText(value, /_deg(?=_|$)/.test(name) ? "deg" : "");
    return fact(metricName(name), places.has(name) ? `${text} at ${degreesShort(places.get(name), 5)}` : text, typeof value === "number" ? String(value) : undefined);
  });
  byId("facts").hidden = rows.length === 0;
  byId("facts-list").replaceChildren(...rows);
}

function boundOf(bound) {
  if (bound === null) return "–";
  if (typeof bound === "number") return number(bound, 7);
  if (Array.isArray(bound)) return bound.map((b) => number(b, 7)).join(" to ");
  if (typeof bound === "object") return "min" in bound ? `at least ${number(bound.min, 7)}` : `at most ${number(bound.max, 7)}`;
  return String(bound);
}

const headRow = (names) => element("tr", {}, ...names.map(([name, kind = ""]) => element("th", { scope: "col", class: kind }, name)));

function showCamConstraints({ drawn: { constraints } }) {
  document.querySelector(".checks thead").replaceChildren(headRow([["Constraint"], ["Value", "number"], ["Bound", "number"], ["Met"]]));
  byId("checks").replaceChildren(...[...constraints].sort((a, b) => a.satisfied - b.satisfied).map((check) =>
    element("tr", { class: check.satisfied ? "met" : "missed" }, element("td", {}, element("code", {}, ...breakable(check.name))),
      element("td", { class: "number" }, boundOf(check.value)), element("td", { class: "number" }, boundOf(check.bound)),
      element("td", {}, element("span", { class: `mark ${check.satisfied ? "yes" : "no"}` }, check.satisfied ? "✓ yes" : "✗ no")))));
  const missed = constraints.filter((check) => !check.satisfied).length;
  byId("constraints-count").textContent = constraints.length === 0 ? "none asked for" : missed ? `${missed} of ${constraints.length} missed` : `all ${constraints.length} met`;
}

const lawTitle = (law) => (/^\d/.test(law) ? `${law} polynomial` : sentence(law.replaceAll("-", " ")));

// A row for each segment; its button goes to its beginning.
function showSegments({ drawn, kind }, goTo) {
  const factors = drawn.segments.some((s) => s.factors);
  const unit = kind.oscillating ? "°" : "";
  byId("segments-table").tHead.replaceChildren(headRow([["Law"], ["From", "number"], ["Over", "number"], ["Rise", "number"],
    ...(factors ? [["Velocity", "number"], ["Acceleration", "number"], ["Jerk", "number wide"]] : []), ["At its beginning", "wide"]]));
  const factor = (segment, key) => {
    const [own, printed] = [segment.factors?.[key], segment.handbook?.[key]];
    const text = (v) => (v === null ? "∞" : number(v, 5));
    const side = key === "jerk" ? "number wide" : "number";
    if (own === undefined || segment.law === "dwell") return element("td", { class: side }, "–");
    return element("td", { class: side }, text(own), ...(printed === undefined ? [] : [element("span", { class: "printed", title: "handbook" }, text(printed))]));
  };
  byId("segments-rows").replaceChildren(...drawn.segments.map((segment) => {
    const button = element("button", { type: "button", class: "link", title: "Show its beginning" }, lawTitle(segment.law));
    button.addEventListener("click", () => goTo(segment.from_deg));
    const sense = segment.rise > 0 ? "rise" : segment.rise < 0 ? "return" : "dwell";
    return element("tr", {}, element("td", {}, element("span", { class: "landmark" }, element("span", { class: "dot", style: `background:var(${STROKE_COLOURS[sense]})` }), button)),
      element("td", { class: "number" }, degreesShort(segment.from_deg)), element("td", { class: "number" }, degreesShort(segment.over_deg)), element("td", { class: "number" }, `${number(segment.rise, 6)}${unit}`),
      ...(factors ? ["velocity", "acceleration", "jerk"].map((key) => factor(segment, key)) : []),
      element("td", { class: "wide" }, jumpText(kind.jumps, segment.from_deg)));
  }));
  byId("factors-note").hidden = !factors;
  const [count, shown] = [drawn.segment_count, drawn.segments.length];
  byId("segments-count").textContent = `${plural(count, "segment")}${shown < count ? `, the first ${shown} shown` : ""} · ${kind.jump_count ? plural(kind.jump_count, "jump") : "velocity and acceleration without a jump"}`;
}

function jumpText(jumps, deg) {
  const here = jumps.filter((jump) => Math.abs(jump.deg - deg) < 1e-4 || (deg === 0 && Math.abs(jump.deg - 360) < 1e-4));
  return here.length ? here.map((jump) => `${JUMPS[jump.order]} jumps from ${number(jump.before, 4)} to ${number(jump.after, 4)}`).join("; ") : "smooth";
}

// What is plotted as numbers: now, least and greatest.
class CamValues {
  constructor() {
    byId("values").tHead.replaceChildren(headRow([["Quantity"], ["Now", "number"], ["Least", "number"], ["at", "number wide"], ["Greatest", "number"], ["at", "number wide"]]));
  }

  build(sheets) {
    this.rows = sheets.flatMap((sheet) => sheet.lines.map((line) => ({ sheet, line, cell: element("td", { class: "number now" }) })));
    byId("values-rows").replaceChildren(...this.rows.map(({ sheet, line, cell }) => {
      const [least, greatest] = extremes(line.y);
      const place = (value) => (value === null ? "–" : degrees(sheet.x[line.y.indexOf(value)], 1));
      return element("tr", {}, element("td", {}, sheet.lines.length > 1 && line.dash ? `${sheet.title} (other cam)` : sheet.title), cell,
        element("td", { class: "number" }, number(least, 5)), element("td", { class: "number wide" }, place(least)), element("td", { class: "number" }, number(greatest, 5)), element("td", { class: "number wide" }, place(greatest)));
    }));
  }

  move(deg) { for (const { sheet, line, cell } of this.rows) cell.textContent = number(interpolate(line.y, locate(sheet.x, deg)), 6); }
}

function camCsv({ first: { table } }) {
  const names = Object.keys(table);
  const lines = [names.map((name) => (name === "deg" ? "cam_deg" : name)), ...table.deg.map((_, i) => names.map((name) => table[name][i] ?? ""))];
  return `${lines.map((row) => row.join(",")).join("\n")}\n`;
}
