// What is plotted for a design: one sheet for each plot.

import { padded, TURN_STEPS } from "../curves.js";
import { degrees, number, sentence } from "../format.js";
import { isNoError } from "../rounding.js";
import { RADIANS, scaled } from "../sampling.js";
import { diagonal } from "../view.js";
import { say } from "../words.js";

export function curveSheets(design, limits) {
  const error = design.trace ? structuralErrorSheet(design) : design.stretch.length ? deviationSheet(design) : distanceSheet(design);
  return [rockerSheet(design), error, transmissionSheet(design, limits)].filter(Boolean);
}

// What the plots over the drive have in common.
export function overDrive(design) {
  return { xRange: [design.from, design.to], xLabel: say(design.angular ? "drive.angle_axis" : "drive.way_axis", { name: design.driveName }),
    xSteps: design.angular ? TURN_STEPS : undefined, xAt: (drive) => design.within(drive), driveAt: (x) => x };
}

const overCrank = (design) => ({ ...overDrive(design), x: design.linkage.cranks });

// The part of the crank's turn in which a function is generated, moved into the motion drawn.
function usedShade(design) {
  if (!design.trace || design.trace.crank_deg.length < 2) return [];
  const { linkage, span } = design;
  const from = linkage.within(span[0]);
  const to = from + span[1] - span[0];
  const shades = [{ axis: "x", from, to, colour: "--accent-soft" }];
  if (linkage.fullTurn && to > linkage.to) shades.push({ axis: "x", from: from - 360, to: to - 360, colour: "--accent-soft" });
  return shades;
}

function rockerSheet(design) {
  const { linkage } = design;
  const lines = [{ y: linkage.rockers, colour: "--rocker" }];
  const rocker = linkage.rockers;
  const sheet = { ...overCrank(design), title: say("sheet.output_angle"), lines, shades: usedShade(design),
    summary: say("curves.range", { least: degrees(Math.min(...rocker), 1), greatest: degrees(Math.max(...rocker), 1) }) };
  if (design.trace && design.trace.x === null) {
    const { crank_deg: stations } = design.trace;
    sheet.spots = stations.map((deg) => ({ x: design.within(deg), y: linkage.pose(deg).rocker - design.errorAt(deg), colour: "--target" }));
    sheet.note = say("sheet.pairs_note");
  } else if (design.trace) {
    lines.push({ y: linkage.cranks.map((crank) => {
      const error = design.errorAt(crank);
      return error === null ? null : linkage.pose(crank).rocker - error;
    }), colour: "--target", dash: [6, 4] });
    sheet.note = say("sheet.wanted_note");
  } else {
    sheet.note = say("sheet.swing_note", { angle: degrees(Math.max(...rocker) - Math.min(...rocker), 1) });
  }
  return sheet;
}

// What is plotted are samples: their greatest gives way to the maximum that is known, where that lies between two of them.
const BETWEEN_SAMPLES = 1.05;

export const maximumOf = (known, sampled) => (known > sampled && known < BETWEEN_SAMPLES * sampled ? known : sampled);

const largestOf = ({ entry: { error } }, sampled) => maximumOf(error?.max_deg ?? error?.max, sampled);

// In the target's own unit, which is another than the linkage's where the target was enlarged.
export function distanceSheet(design) {
  const { enlarged } = design;
  const rows = design.targets.map((target, i) => ({ crank: design.within(design.stations[i]),
    distance: design.reached[i] ? Math.hypot(design.reached[i][0] - target[0], design.reached[i][1] - target[1]) / enlarged : null }))
    .filter((row) => Number.isFinite(row.crank)).sort((p, q) => p.crank - q.crank);
  if (rows.length === 0 || isNoError(design.largestError, diagonal(design.boxes.whole))) return null;
  const { values, unit, size: sampled } = scaled(rows.map((row) => row.distance), say("unit.length"));
  const size = largestOf(design, sampled);
  return { ...overDrive(design), x: rows.map((row) => row.crank), title: say(enlarged === 1 ? "sheet.distance" : "sheet.distance_own", { unit }),
    lines: [{ y: values, colour: "--error", dots: true }], stems: true, hover: false,
    yRange: [0, 1.1 * Math.max(...values, 1e-12)], note: say("sheet.largest", { value: number(size, 4) }), summary: say("range.at_most_unit", { value: number(size, 4), unit: say("unit.length") }) };
}

// Distances from the line and places along it, of the positions drawn.
function drawnDeviation(points, metrics) {
  const [x, y] = unitVector(metrics.direction_deg_at_0_001 ?? 0);
  const [start] = points;
  return { along: points.map((p) => (p[0] - start[0]) * x + (p[1] - start[1]) * y),
    across: points.map((p) => (p[1] - start[1]) * x - (p[0] - start[0]) * y) };
}

// How far the stretch is from its best line, the middle of the narrowest strip around it.
export function deviationSheet({ stretch, deviation, entry: { metrics } }) {
  const { along, across } = deviation ?? drawnDeviation(stretch.filter(Boolean), metrics);
  if (along.length < 2) return null;
  const middle = (Math.min(...across) + Math.max(...across)) / 2;
  const { values, unit, size } = scaled(across.map((d) => d - middle), say("unit.length"));
  const order = along.map((_, i) => i).sort((i, j) => along[i] - along[j]);
  const length = Math.max(...along) - Math.min(...along);
  return { x: order.map((i) => along[i]), xRange: [Math.min(...along), Math.max(...along)], xLabel: say("sheet.along"),
    title: say("sheet.deviation", { unit }), lines: [{ y: order.map((i) => values[i]), colour: "--error" }], hover: false,
    yRange: size > 0 ? undefined : [-1, 1], xAt: () => null, driveAt: () => null,
    note: say("sheet.deviation_note", { length: number(length, 5), value: number(size, 4) }), summary: say("range.at_most_unit", { value: number(size, 4), unit: say("unit.length") }) };
}

const unitVector = (deg) => [Math.cos(deg * RADIANS), Math.sin(deg * RADIANS)];

// What is left of the error at a precision point, as a share of the greatest, that is no more than drawing between samples.
const LEFT_AT_POINT = 0.02;

// Where an exact synthesis makes the function hold: places on the x axis; none of a design that has been edited since.
function precisionSpots(design, cranks, x) {
  const { entry: { origin = "", crank_deg: stations = [] } } = design;
  if (!origin.startsWith("exact:")) return [];
  const holds = (deg) => Math.abs(design.errorAt(deg)) <= LEFT_AT_POINT * design.largestError;
  return stations.filter(holds).map((deg) => design.between(deg, cranks, x)).filter((at) => at !== null).map((at) => ({ x: at, y: 0, colour: "--target" }));
}

export function structuralErrorSheet(design) {
  const { trace } = design;
  const slides = !trace.error_deg;
  if (isNoError(design.largestError, slides ? diagonal(design.boxes.whole) : 1 / RADIANS)) return null;
  const byX = trace.x !== null;
  const { values, unit, size: sampled } = scaled(slides ? trace.error : trace.error_deg, slides ? say("unit.length") : "°");
  const size = largestOf(design, sampled);
  const x = byX ? trace.x : trace.crank_deg;
  const order = x.map((_, i) => i).sort((i, j) => x[i] - x[j]);
  const sortedX = order.map((i) => x[i]);
  const cranks = order.map((i) => trace.crank_deg[i]);
  const margin = 0.03 * (sortedX.at(-1) - sortedX[0]) || 1;
  const spots = byX ? precisionSpots(design, cranks, sortedX) : [];
  const note = say(slides ? "sheet.structural_note_slider" : "sheet.structural_note", { value: number(size, 4) });
  return { x: sortedX, xRange: [sortedX[0] - margin, sortedX.at(-1) + margin], xLabel: byX ? "x" : say("drive.angle_axis", { name: say("part.crank") }),
    lines: [{ y: order.map((i) => values[i]), colour: "--error", dots: !byX }], stems: !byX, hover: byX,
    yRange: size > 0 ? undefined : [-1, 1],
    title: say("sheet.structural_error", { unit }), spots, note: spots.length ? say("sheet.with_precision", { note, list: spots.map(({ x: at }) => number(at, 4)).join(say("list.comma")) }) : note,
    summary: say("range.at_most_unit", { value: number(size, 4), unit: say(slides ? "unit.length" : "unit.degrees") }),
    xAt: (crank) => design.between(crank, cranks, sortedX), driveAt: (at) => design.between(at, sortedX, cranks, false) };
}

function transmissionSheet(design, limits) {
  const values = design.linkage.poses.map((pose) => pose.transmission);
  const [least, greatest] = design.transmissionDrawn;
  const sheet = { ...overCrank(design), title: say("sheet.transmission"), lines: [{ y: values, colour: "--coupler" }], shades: usedShade(design),
    yRange: limits ? [0, 180] : padded(least, greatest), summary: say("curves.range", { least: degrees(least, 1), greatest: degrees(greatest, 1) }) };
  const range = sentence(sheet.summary);
  const limitsText = limits ? say("sheet.limits", { range, least: number(limits[0]), greatest: number(limits[1]) }) : say("sheet.no_limits", { range });
  const used = design.transmissionOfPart;
  sheet.note = used ? say("sheet.of_whole_motion", { note: limitsText, least: degrees(used.min, 1), greatest: degrees(used.max, 1) }) : limitsText;
  if (limits) sheet.shades.push({ axis: "y", from: 0, to: limits[0], colour: "--shade" }, { axis: "y", from: limits[1], to: 180, colour: "--shade" });
  return sheet;
}
