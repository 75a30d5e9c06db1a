// What is plotted of gears.

import { padded } from "../curves.js";
import { number, sentence } from "../format.js";
import { extremes, RADIANS } from "../sampling.js";
import { say, withUnit } from "../words.js";

const GEAR_COLOURS = ["--pinion", "--wheel"];
// Specific sliding is cut here: on the base circle it is infinite.
const MOST_SLIDING = 6;
const PATH_STEPS = 240;

const gearLine = (label, colour, y) => ({ label, colour, y, show: (v) => number(v, 4) });

const orInfinite = (v) => (Number.isFinite(v) ? number(v, 4) : v > 0 ? "∞" : "−∞");

const rangeOf = (values, unit = "") => {
  const [least, greatest] = extremes(values);
  return least === null ? say("curves.no_values") : say("curves.range_unit", { least: orInfinite(least), greatest: orInfinite(greatest), unit }).trim();
};

const upTo = (values) => say("range.at_most", { value: number(Math.max(...values), 4) });

export function pairSheets(mesh) {
  if (!mesh.touches) return [countSheet(mesh)];
  const ways = Array.from({ length: PATH_STEPS + 1 }, (_, i) => mesh.start + ((mesh.end - mesh.start) * i) / PATH_STEPS);
  const x = ways.map((way) => way - mesh.pitchPoint);
  const along = { x, xRange: [x[0], x.at(-1)], xLabel: withUnit(say("gear.axis_path"), say("unit.length")), xAt: (deg) => { const way = mesh.followed(deg); return way === null ? null : way - mesh.pitchPoint; },
    driveAt: (at) => (Math.min(x.at(-1), Math.max(x[0], at)) - x[0]) / mesh.pinion.base / RADIANS,
    marks: [{ at: 0, colour: "--dwell" }], shades: aloneShades(mesh) };
  const sliding = ways.map((way) => mesh.sliding(way));
  const cut = (v) => (Number.isFinite(v) && Math.abs(v) <= MOST_SLIDING ? v : null);
  const both = [0, 1].map((i) => sliding.map((pair) => cut(pair[i])));
  const isCut = both.some((list) => list.includes(null));
  const range = sentence(rangeOf(sliding.flat()));
  const speed = ways.map((way) => mesh.slidingSpeed(way));
  return [
    { ...along, title: say("gear.sliding"), summary: range, note: isCut ? say("curves.peaks_cut", { range }) : range, lines: [gearLine(say("gear.pinion"), GEAR_COLOURS[0], both[0]), gearLine(say("gear.wheel"), GEAR_COLOURS[1], both[1])] },
    { ...along, title: say("gear.sliding_speed"), summary: upTo(speed), note: sentence(upTo(speed)), lines: [gearLine("v/v₀", "--velocity", speed)], yRange: padded(0, Math.max(...speed)) },
    countSheet(mesh)];
}

// The stretch of the path where one pair alone is in contact.
function aloneShades(mesh) {
  const borders = mesh.borders();
  const shades = [];
  for (let i = 0; i + 1 < borders.length; ++i) {
    if (mesh.count((borders[i] + borders[i + 1]) / 2) === 1) shades.push({ axis: "x", from: borders[i] - mesh.pitchPoint, to: borders[i + 1] - mesh.pitchPoint, colour: "--alone-soft" });
  }
  return shades;
}

// Pairs in contact over as many pitches of the pinion as a pair stays, two at least.
function countSheet(mesh) {
  const pitch = 360 / mesh.pinion.teeth;
  const all = Math.max(2, mesh.pairs) * pitch;
  const steps = 480;
  const x = Array.from({ length: steps + 1 }, (_, i) => (all * i) / steps);
  const counts = x.map((deg) => mesh.contacts(Math.min(all * (1 - 1e-9), deg)).length);
  const range = rangeOf(counts);
  return { title: say("gear.pairs"), x, xRange: [0, all], xLabel: say("gear.axis_angle"), xAt: (deg) => deg - all * Math.floor(deg / all), driveAt: (at) => Math.min(all * (1 - 1e-9), Math.max(0, at)),
    summary: range, note: sentence(range), lines: [gearLine("n", "--curve", counts)], yRange: [0, Math.max(2, ...counts) + 0.5],
    marks: Array.from({ length: Math.max(2, mesh.pairs) - 1 }, (_, i) => ({ at: (i + 1) * pitch, colour: "--dwell" })) };
}

// Thickness of the tooth and width of the space over the radius, as the outline has them.
export function thicknessSheets({ body, range, angleAt, radius }, generation) {
  const rows = [];
  for (const [x, y] of body.points) {
    const r = Math.hypot(x, y);
    if (!rows.length || r > rows.at(-1).r * (1 + 1e-6)) rows.push({ r, thickness: 2 * r * Math.atan2(-x, y) });
  }
  const x = rows.map(({ r }) => r);
  const [tooth, space] = [rows.map(({ thickness }) => thickness), rows.map(({ r, thickness }) => r * body.pitch - thickness)];
  const note = say("gear.of_tooth", { range: sentence(rangeOf(tooth, say("unit.length"))) });
  const curvature = flankCurvature(body);
  const along = { xLabel: withUnit(say("gear.axis_radius"), say("unit.length")), xAt: (deg) => generation.radius(deg * RADIANS), driveAt: (at) => Math.min(range.deg, Math.max(-range.deg, generation.angleAt(at) / RADIANS)) };
  const marksWithin = (x) => [{ at: body.form, colour: "--form" }, { at: body.base, colour: "--base" }, { at: body.reference, colour: "--working" }].filter(({ at }) => at > x[0] && at < x.at(-1));
  return [{ ...along, x, xRange: [x[0], x.at(-1)], title: say("unit.axis", { name: say("gear.thickness"), unit: say("unit.length") }), summary: note, note, marks: marksWithin(x),
    lines: [gearLine(say("gear.tooth"), "--pinion", tooth), gearLine(say("gear.space"), "--wheel", space)] },
  { ...along, ...curvature, title: say("unit.axis", { name: say("gear.curvature"), unit: say("unit.length") }), marks: marksWithin(curvature.x) }];
}

// The involute's radius of curvature.
function flankCurvature(body) {
  const [from, to] = [Math.max(body.form, body.base), body.tip_end];
  const x = Array.from({ length: 61 }, (_, i) => from + ((to - from) * i) / 60);
  const y = x.map((r) => Math.sqrt(Math.max(0, r * r - body.base * body.base)));
  const note = sentence(rangeOf(y, say("unit.length")));
  return { x, xRange: [x[0], x.at(-1)], summary: note, note, lines: [gearLine("ρ", "--curve", y)], yRange: padded(0, Math.max(...y)) };
}
