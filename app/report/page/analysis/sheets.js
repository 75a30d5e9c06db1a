// What is plotted of an analysis: one sheet for each quantity and unit.

import { TURN_STEPS } from "../curves.js";
import { engineeringExponent, number, powerOfTen, sentence } from "../format.js";
import { extremes, quantile } from "../sampling.js";
import { say, term, withUnit } from "../words.js";
import { cutOf } from "./loci.js";
import { INSTANT_GEOMETRY, unitText } from "./table.js";

const SHEET_TITLES = {
  "position deg": say("sheet.angles"), "position length": say("sheet.positions"), "velocity rad/s": say("sheet.angular_velocities"), "velocity length/s": say("sheet.velocities"),
  "acceleration rad/s2": say("sheet.angular_accelerations"), "acceleration length/s2": say("sheet.accelerations"),
  "curvature 1/length": say("sheet.path_curvature"), "reactions N": say("sheet.reactions"), "reactions N m": say("sheet.moments"),
  "torque N m": say("sheet.torque"), "torque N": say("sheet.force"),
};
// The columns of an instant's geometry have one sheet for each quantity of the bodies.
const INSTANTS = ["pole", "moving_centrode", "inflection_diameter", "inflection_centre", "return_centre", "tangential_diameter", "tangential_centre",
  "acceleration_pole", "ball", "stationary", "inflection_line", "inflection_line_deg"];
const POINT_COLOURS = ["--curve", "--crank", "--coupler", "--target", "--rocker", "--link-b", "--link-d", "--velocity", "--link-c"];
const LANDMARK_COLOURS = { "limit position": "--good", "dead point": "--bad", "change point": "--warn",
  "least transmission angle": "--curve", "greatest transmission angle": "--link-b",
  cusp: "--crank", inflection: "--target", "double point": "--coupler" };
export const landmarkColour = (kind) => LANDMARK_COLOURS[kind] ?? "--ground";

// A colour for each part of the table: of bodies that of the picture, of points and joints in turn.
export function partColours(table, scene) {
  let points = 0;
  return new Map(table.parts.map((part) => {
    const body = scene.mechanism.bodies.findIndex((b) => b.name === part);
    return [part, body > 0 ? scene.tint(body) : body === 0 ? "--ground" : POINT_COLOURS[points++ % POINT_COLOURS.length]];
  }));
}

// The quantity of a body in a column of an instant's geometry: "pole" of "coupler_pole_x".
const instantKind = ({ name, of }) => name.slice(of.length + 1).replace(/_[xyuvmn]$/, "");

const instantTitle = (column) => (INSTANTS.includes(instantKind(column)) ? say(`instant.${instantKind(column)}`) : undefined);

function sheetKey(column) {
  return column.quantity === INSTANT_GEOMETRY ? `${column.quantity} ${instantKind(column)}` : `${column.quantity} ${column.unit}`.trim();
}

// The columns of the parts chosen, by quantity and unit, in the order of the table.
function columnGroups(table, parts) {
  const groups = new Map();
  for (const column of table.columns) {
    if (column.quantity === "drive" || !parts.has(column.of)) continue;
    const key = sheetKey(column);
    groups.set(key, [...(groups.get(key) ?? []), column]);
  }
  return groups;
}

export function analysisSheets(table, mechanism, parts, landmarks, xLabel, colours) {
  const angular = xLabel.includes("°");
  const common = { x: table.drive, xRange: [mechanism.from, mechanism.to], xLabel, xSteps: angular ? TURN_STEPS : undefined,
    xAt: (drive) => drive, driveAt: (x) => x, hover: true, marks: landmarks.map(({ drive, kind }) => ({ at: drive, colour: landmarkColour(kind) })) };
  return [...columnGroups(table, parts)].map(([key, columns]) => ({ ...common, ...sheetOf(key, columns, colours) }));
}

function sheetOf(key, columns, colours) {
  const unit = unitText(columns[0].unit);
  const exponent = engineeringExponent(cutOf(columns.flatMap((c) => c.values)));
  const perUnit = 10 ** exponent;
  const counts = new Map();
  const lines = columns.map((column) => {
    const before = counts.get(column.of) ?? 0;
    counts.set(column.of, before + 1);
    return { label: column.label, pressure: /(^|_)pressure(_deg)?$/.test(column.name), colour: colours.get(column.of), dash: [undefined, [7, 4], [2, 3], [9, 3, 2, 3]][before % 4],
      y: exponent === 0 ? column.values : column.values.map((v) => (v === null ? null : v / perUnit)), show: (v) => number(v, 4) };
  });
  const shownUnit = exponent === 0 ? unit : `${powerOfTen(exponent)} ${unit}`;
  const title = key === "transmission deg" ? transmissionTitle(lines)
    : SHEET_TITLES[key] ?? instantTitle(columns[0]) ?? sentence(term(columns[0].quantity));
  return { title: withUnit(title, shownUnit), lines, ...fittingRange(lines, columns, unit) };
}

function transmissionTitle(lines) {
  const pressure = lines.filter((line) => line.pressure).length;
  return say(pressure === 0 ? "sheet.transmission_angle" : pressure === lines.length ? "sheet.pressure_angle" : "sheet.both_angles");
}

// The range of a plot: what the curves take, but where a pole dwarfs all else (beside a dead point)
// it is cut, and the note says so.
function fittingRange(lines, columns, unit) {
  const values = lines.flatMap((line) => line.y);
  const most = quantile(values, 1);
  const usual = quantile(values, 0.93);
  const least = Math.min(...columns.map((c) => c.least ?? Infinity));
  const greatest = Math.max(...columns.map((c) => c.greatest ?? -Infinity));
  const summary = least <= greatest ? say("curves.range_unit", { least: number(least, 4), greatest: number(greatest, 4), unit }) : say("curves.no_values");
  if (!(most > 12 * usual) || usual === 0) return { summary };
  const [low, high] = extremes(values);
  return { summary, yRange: [Math.max(low, -3 * usual), Math.min(high, 3 * usual)], note: say("curves.peaks_cut", { range: sentence(summary) }) };
}
