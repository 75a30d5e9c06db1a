// What is known of the gears chosen, in tables.

const yesOr = (value) => (value === undefined || value === null ? "–" : say(value ? "yes" : "no"));
const lengthOf = (value) => number(value, 7);
const twice = (value) => lengthOf(value === null ? null : 2 * value);

// Rows of the table of gears: what it is called, and its text of a gear.
const GEAR_ROWS = [
  ["gear.teeth", (g) => (Number.isInteger(g.teeth) ? String(g.teeth) : number(g.teeth, 7))],
  ["gear.module", (g) => lengthOf(g.module)],
  ["gear.profile_shift", (g) => number(g.shift, 6)],
  ["gear.reference_diameter", (g) => twice(g.reference)],
  ["gear.working_diameter", (g) => (g.working ? twice(g.working) : null)],
  ["gear.base_diameter", (g) => twice(g.base)],
  ["gear.tip_diameter", (g) => twice(g.tip)],
  ["gear.root_diameter", (g) => twice(g.root)],
  ["gear.form_diameter", (g) => twice(g.form)],
  ["gear.thickness_reference", (g) => lengthOf(g.thickness)],
  ["gear.thickness_tip", (g) => lengthOf(g.tip_thickness)],
  ["gear.contact_start", (g) => (g.contact_start ? twice(g.contact_start) : null)],
  ["gear.contact_end", (g) => (g.contact_end ? twice(g.contact_end) : null)],
  ["gear.sliding_start", (g) => (g.sliding_start === undefined ? null : g.sliding_start === null ? "−∞" : number(g.sliding_start, 5))],
  ["gear.sliding_end", (g) => (g.sliding_end === undefined || g.sliding_end === null ? null : number(g.sliding_end, 5))],
  ["gear.tip_clearance", (g) => (g.tip_clearance === undefined ? null : lengthOf(g.tip_clearance))],
  ["gear.undercut", (g) => yesOr(g.undercut)],
  ["gear.interferes", (g) => (g.interferes === undefined ? null : yesOr(g.interferes))],
];

// Whether a row tells of something wrong.
const GEAR_FAULTS = { "gear.undercut": (g) => g.undercut, "gear.interferes": (g) => g.interferes, "gear.thickness_tip": (g) => g.tip_thickness < 0, "gear.tip_clearance": (g) => g.tip_clearance < 0 };

// Of helical gears teeth, module and shift are those of the normal section.
function showGears(drawn, { teeth, module: size, shifts }, names) {
  const gears = drawn.map((gear, i) => (gearing === "helical" ? { ...gear, teeth: teeth[i], module: size, shift: shifts[i] } : gear));
  byId("gears").tHead.replaceChildren(headRow([[say("values.quantity")], ...names.map((name) => [name, "number"])]));
  const rows = GEAR_ROWS.map(([key, text]) => ({ key, cells: gears.map(text) })).filter(({ cells }) => cells.some((cell) => cell !== null));
  byId("gears-rows").replaceChildren(...rows.map(({ key, cells }) => element("tr", {}, element("td", {}, say(key)),
    ...cells.map((cell, i) => element("td", { class: `number${GEAR_FAULTS[key]?.(gears[i]) ? " fault" : ""}` }, cell ?? "–")))));
}

// The table of the flank's points that the result has.
function showFlank(columns) {
  byId("table").hidden = !columns?.length;
  if (!columns?.length) return;
  const title = (name) => sentence(term(name.replace(/_deg$/, "").replaceAll("_", " ")));
  byId("values").tHead.replaceChildren(headRow(columns.map(({ name }) => [/_deg$/.test(name) ? say("unit.axis", { name: title(name), unit: "°" }) : title(name), "number"])));
  byId("values-rows").replaceChildren(...columns[0].values.map((_, i) => element("tr", {}, ...columns.map(({ name, values }) =>
    element("td", { class: "number" }, name === "part" && PARTS[values[i]] ? say(`gear.part_${PARTS[values[i]]}`) : number(values[i], 8))))));
}

const flankCsv = (columns) => `${[columns.map(({ name }) => name), ...columns[0].values.map((_, i) => columns.map(({ values }) => values[i] ?? ""))].map((row) => row.join(",")).join("\n")}\n`;
