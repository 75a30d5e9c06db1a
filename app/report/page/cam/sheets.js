// What is plotted of a cam over its turn.

import { padded, TURN_STEPS } from "../curves.js";
import { degreesShort, engineeringExponent, number, powerOfTen, sentence } from "../format.js";
import { extremes, interpolate, locate, quantile } from "../sampling.js";
import { say, withUnit } from "../words.js";
import { greatestOf, leastOf } from "./model.js";

export const STROKE_COLOURS = { rise: "--rise", return: "--fall", dwell: "--dwell" };
export const JUMPS = ["displacement", "velocity", "acceleration"];
export const JUMP_COLOURS = ["--bad", "--bad", "--warn"];
const MANY_MARKS = 40;

// The plots in order: the column, what it is called, its sign in the key, and its unit, which for
// derivatives is that of the displacement by the cam angle or by time.
const CAM_SHEETS = [
  { column: "displacement", title: say("sheet.displacement"), sign: "s", colour: "--rocker", order: 0 },
  { column: "velocity", title: say("sheet.velocity"), sign: "v", colour: "--velocity", order: 1 },
  { column: "acceleration", title: say("sheet.acceleration"), sign: "a", colour: "--acceleration", order: 2 },
  { column: "jerk", title: say("sheet.jerk"), sign: "j", colour: "--link-d", order: 3 },
  { column: "pressure_deg", title: say("sheet.pressure_angle"), sign: "α", colour: "--error", unit: "°" },
  { column: "radius", title: say("sheet.radius"), sign: "ρ", colour: "--crank", unit: say("unit.length") },
  { column: "reach", title: say("sheet.reach"), sign: say("sheet.reach_sign"), colour: "--coupler", unit: say("unit.length") },
  { column: "roller_speed", title: say("sheet.roller_speed"), sign: say("sheet.ratio_sign"), colour: "--link-b", unit: "" },
  { column: "force", title: say("sheet.contact_force"), sign: "F", colour: "--curve", unit: say("unit.force"), limit: "force" },
  { column: "torque", title: say("sheet.cam_torque"), sign: "T", colour: "--target", unit: say("unit.torque"), limit: "torque", sides: true },
  { column: "stress", title: say("sheet.stress"), sign: "p", colour: "--link-c", unit: say("unit.stress"), limit: "stress" },
];

const POWERS = ["", "", "²", "³"];

function motionUnit(order, kind, byTime) {
  const length = kind.oscillating ? (order === 0 ? "°" : "rad") : say("unit.length");
  return order === 0 ? length : `${length}/${byTime ? "s" : "rad"}${POWERS[order]}`;
}

export function camSheets(design, byTime) {
  const { kind, drawn, first: { table } } = design;
  return CAM_SHEETS.filter(({ column }) => table[column] && !isIdle(column, kind)).map((spec) => {
    const rate = byTime && spec.order ? drawn.speed ** spec.order : 1;
    const values = plotted(table[spec.column], rate, spec.column === "radius" ? design.radius : Infinity);
    const unit = spec.order === undefined ? spec.unit : motionUnit(spec.order, kind, byTime);
    const lines = [line(spec, values)];
    const other = design.second?.table[spec.column];
    if (other && spec.order === undefined && !["force", "torque", "stress"].includes(spec.column)) {
      lines.push({ ...line(spec, plotted(resampled(design.second.table, spec.column, table.deg), 1, spec.column === "radius" ? design.radius : Infinity)), label: say("sheet.other_cam", { sign: spec.sign }), dash: [6, 4] });
    }
    return fitted({ ...overTurn(design), ...limitsOf(spec, design, rate), title: spec.title, unit, spec, lines, x: table.deg });
  });
}

// A face square to its travel has no pressure angle.
const isIdle = (column, kind) => column === "pressure_deg" && kind.flat && !kind.oscillating;

// Values as they are plotted: rounding is no motion, and there is a gap where they go from one side
// of infinity to the other, beyond `pole`.
function plotted(values, rate, pole) {
  const least = 1e-11 * quantile(values, 1);
  return values.map((v, i) => {
    const next = values[i + 1] ?? v;
    return v === null || (v * next < 0 && Math.abs(v - next) > 2 * pole) ? null : Math.abs(v) < least ? 0 : rate * v;
  });
}

function line({ sign, colour: name }, values) {
  return { label: sign, colour: name, y: values, show: (v) => number(v, 4) };
}

const resampled = (table, column, degs) => degs.map((deg) => interpolate(table[column], locate(table.deg, deg)));

// What all plots have in common: the axis, the segments' borders, the jumps.
function overTurn({ drawn, kind }) {
  const borders = drawn.segments.length <= MANY_MARKS ? drawn.segments.slice(1).map((s) => ({ at: s.from_deg, colour: "--dwell" })) : [];
  const jumps = kind.jumps.length <= MANY_MARKS ? kind.jumps.map(({ deg, order }) => ({ at: deg, colour: JUMP_COLOURS[order] })) : [];
  const taken = new Set(jumps.map(({ at }) => at.toFixed(4)));
  return { xRange: [0, 360], xLabel: say("sheet.cam_angle"), xSteps: TURN_STEPS, xAt: (deg) => deg, driveAt: (x) => Math.min(360, Math.max(0, x)),
    marks: [...borders.filter(({ at }) => !taken.has(at.toFixed(4))), ...jumps] };
}

// Regions that limits forbid, and of the displacement the strokes.
function limitsOf({ column, limit, sides }, { drawn, kind: { limits, flat } }) {
  if (column === "displacement") {
    return { shades: drawn.strokes.filter((s) => s.stroke !== "dwell").map((s) => ({ axis: "x", from: s.from_deg, to: s.to_deg, colour: `${STROKE_COLOURS[s.stroke]}-soft` })) };
  }
  if (column === "pressure_deg") return { shades: pressureShades(drawn.strokes, limits) };
  if (column === "radius") {
    const { convex_radius: convex, concave_radius: concave } = limits;
    const convexShade = convex === null ? [] : [{ axis: "y", from: flat ? -1e300 : 0, to: convex, colour: "--shade" }];
    return { shades: [...convexShade, ...(concave === null || flat ? [] : [{ axis: "y", from: -concave, to: 0, colour: "--shade" }])] };
  }
  const most = limit ? limits[limit] : null;
  if (most === null) return {};
  return { shades: [{ axis: "y", from: most, to: 1e300, colour: "--shade" }, ...(sides ? [{ axis: "y", from: -1e300, to: -most, colour: "--shade" }] : [])], most };
}

// The greatest pressure angle allowed on either side in a stroke (null in a dwell). A working limit
// holds on one side alone: of a rise on the positive, of a return on the negative.
function pressureLimits(stroke, limits) {
  const least = (...all) => Math.min(...all.map((v) => v ?? Infinity));
  const both = least(limits.pressure_deg, stroke === "rise" ? limits.rise_deg : null, stroke === "return" ? limits.return_deg : null);
  return { above: stroke === "rise" ? least(both, limits.rise_working_deg) : both, below: stroke === "return" ? least(both, limits.return_working_deg) : both };
}

function pressureShades(strokes, limits) {
  const band = (from, to, over) => ({ axis: "y", from, to, over, colour: "--shade" });
  const both = limits.pressure_deg;
  const shades = both === null ? [] : [band(both, 90), band(-90, -both)];
  for (const { from_deg: from, to_deg: to, stroke } of strokes) {
    const { above, below } = pressureLimits(stroke, { ...limits, pressure_deg: null });
    if (above < Infinity) shades.push(band(above, 90, [from, to]));
    if (below < Infinity) shades.push(band(-90, -below, [from, to]));
  }
  return shades;
}

// Whether a limit of the pressure angle is missed at `deg`.
export function missesPressure(design, deg) {
  const angle = design.first.at("pressure_deg", deg);
  const { above, below } = pressureLimits(design.strokeAt(deg), design.kind.limits);
  return angle > above + 1e-6 || -angle > below + 1e-6;
}

// Whether values go from one side of infinity to the other.
const hasPole = (values) => values.some((v, i) => v === null && values[i - 1] * values[i + 1] < 0);

// The sign of degrees follows its number without a space.
const spanText = (least, greatest, unit) => (unit === "°" ? say("curves.range", { least: degreesShort(least, 4), greatest: degreesShort(greatest, 4) })
  : say("curves.range_unit", { least: number(least, 4), greatest: number(greatest, 4), unit }).trim());

// Least and greatest value in words, powers of ten taken out, and peaks cut that dwarf all else.
function fitted(sheet) {
  const values = sheet.lines.flatMap((l) => l.y);
  const [least, greatest] = extremes(values);
  const range = least === null ? say("curves.no_values") : sheet.lines.some(({ y }) => hasPole(y)) ? say("cam.unbounded") : spanText(least, greatest, sheet.unit);
  const usual = quantile(values, 0.8);
  const cut = sheet.spec.column === "radius" && quantile(values, 1) > 6 * usual;
  const exponent = engineeringExponent(cut ? usual : quantile(values, 1));
  const per = 10 ** exponent;
  for (const l of sheet.lines) if (exponent) l.y = l.y.map((v) => (v === null ? null : v / per));
  const shades = (sheet.shades ?? []).map((s) => (s.axis === "y" && exponent ? { ...s, from: s.from / per, to: s.to / per } : s));
  const shown = sheet.lines.flatMap((l) => l.y).filter((v) => v !== null);
  let [low, high] = [leastOf(shown), greatestOf(shown)];
  // Limits are shown where they are near enough to be seen without squeezing the curve.
  const near = shades.filter((s) => s.axis === "y").flatMap((s) => [s.from, s.to]).filter((v) => Math.abs(v) < 3 * Math.max(Math.abs(low), Math.abs(high)) && Math.abs(v) < 89);
  if (cut) [low, high] = [Math.max(low, (-2.5 * usual) / per), Math.min(high, (2.5 * usual) / per)];
  const unit = exponent ? `${powerOfTen(exponent)} ${sheet.unit}`.trim() : sheet.unit;
  return { ...sheet, shades, title: withUnit(sheet.title, unit), summary: range, note: cut ? say("curves.peaks_cut", { range: sentence(range) }) : sentence(range),
    yRange: low <= high ? padded(Math.min(low, ...near), Math.max(high, ...near)) : undefined };
}
