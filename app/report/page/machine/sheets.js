// What is plotted of a motion: over the drive's angle where it is steady, else over time.

import { TURN_STEPS } from "../curves.js";
import { engineeringExponent, number, powerOfTen } from "../format.js";
import { extremes, lookUp, quantile } from "../sampling.js";
import { say, withUnit } from "../words.js";

// Each sheet's lines as [column, words, colour, dash].
const SPEED = ["speed_rad_s", "machine.speed", "--curve"];
const TORQUES = [["motor_N_m", "machine.motor", "--crank"], ["load_N_m", "machine.load", "--rocker", [7, 4]]];
const POWERS = [["motor_power_W", "machine.motor", "--crank"], ["load_power_W", "machine.load", "--rocker", [7, 4]]];
const EXCESS = [["excess_work_J", "machine.excess_work", "--coupler"]];
const ENERGIES = [["kinetic_energy_J", "machine.kinetic_energy", "--coupler"], ["motor_work_J", "machine.motor_work", "--crank", [7, 4]], ["load_work_J", "machine.load_work", "--rocker", [2, 3]]];
const INERTIA = [["inertia_kg_m2", "machine.inertia", "--link-b"]];

export function machineSheets(motion, facts) {
  const common = motion.steady
    ? { x: motion.angles, xLabel: say("machine.angle_axis"), xSteps: TURN_STEPS, xAt: (time) => motion.angle(time), driveAt: (x) => lookUp(x, motion.angles, motion.times),
      marks: placesOf(motion, facts) }
    : { x: motion.times, xLabel: say("machine.time_axis"), xAt: (time) => time, driveAt: (x) => Math.min(motion.length, Math.max(0, x)) };
  common.xRange = extremes(common.x);
  const sheet = (words, unit, lines) => ({ ...common, hover: true, ...filledSheet(say(words), unit, lines) });
  const lines = (list) => list.map(([name, words, colour, dash]) => ({ label: say(words), colour, dash, y: motion.values(name) })).filter((line) => line.y.length);
  const turns = motion.steady ? [] : [sheet("machine.turns", "", [{ label: say("machine.turns"), colour: "--ground", y: motion.angles.map((deg) => (deg - motion.angles[0]) / 360) }])];
  return [sheet("machine.speed", "rad/s", [...lines([SPEED]), ...(motion.steady ? levels(motion, facts) : [])]), ...turns, sheet("machine.torques", "N·m", lines(TORQUES)),
    sheet("machine.energies", "J", lines(motion.steady ? EXCESS : ENERGIES)), sheet("machine.powers", "W", lines(POWERS)), sheet("machine.inertia", "kg·m²", lines(INERTIA))]
    .filter((made) => made.lines.length);
}

// Greatest, mean and least speed as level lines.
function levels(motion, facts) {
  const level = (name, words, colour) => (typeof facts.get(name) === "number"
    ? [{ label: say(words), colour, dash: [4, 4], y: motion.times.map(() => facts.get(name)) }] : []);
  return [...level("speed_max_rad_s", "machine.greatest", "--good"), ...level("speed_mean_rad_s", "machine.mean", "--ground"), ...level("speed_min_rad_s", "machine.least", "--bad")];
}

// Where the speed is greatest and least, in the period that is plotted: a turn or two.
function placesOf(motion, facts) {
  const [from, to] = extremes(motion.angles);
  const period = 360 * Math.round((to - from) / 360);
  return [["speed_max_at_deg", "--good"], ["speed_min_at_deg", "--bad"]].flatMap(([name, colour]) => {
    const deg = facts.get(name);
    return typeof deg === "number" ? [{ at: deg - period * Math.floor((deg - from) / period), colour }] : [];
  });
}

function filledSheet(title, unit, lines) {
  const all = lines.flatMap((line) => line.y);
  const exponent = engineeringExponent(quantile(all, 1));
  const [least, greatest] = extremes(all);
  const shownUnit = exponent === 0 ? unit : `${powerOfTen(exponent)} ${unit}`.trim();
  return { title: withUnit(title, shownUnit),
    summary: least === null ? say("curves.no_values") : say("curves.range_unit", { least: number(least, 4), greatest: number(greatest, 4), unit }),
    lines: lines.map((line) => ({ ...line, y: exponent === 0 ? line.y : line.y.map((v) => (v === null ? null : v / 10 ** exponent)), show: (v) => number(v, 5) })) };
}
