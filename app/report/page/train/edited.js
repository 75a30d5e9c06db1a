// What can be changed of a gear train: its problem with all given as the design shown has it, and the numbers in that.

import { problemFields, withPart } from "../edit/problem_model.js";
import { keyName } from "../problem.js";
import { say } from "../words.js";
import { trainFactName, trainFactText } from "./facts.js";

const TABLES = ["mesh", "planet", "shaft", "input", "output"];

// The problem that gives the whole of a train that was found.
export function givenTrain({ target, bounds, solve, ...problem }, { mechanism: { type, fixed, engaged, ...tables } }) {
  return target ? { ...problem, ...tables, ...(fixed ? { mechanism: { fixed } } : {}) } : problem;
}

// Each gear once: a member's teeth in one mesh are those of its gear in another that has as many.
function gearFields({ mesh }) {
  const gears = [];
  for (const [i, { gears: names, teeth }] of mesh.entries()) {
    for (const side of [0, 1]) {
      const gear = gears.find(({ name, count }) => name === names[side] && count === teeth[side]);
      if (gear) gear.places.push([i, side]);
      else gears.push({ name: names[side], count: teeth[side], places: [[i, side]] });
    }
  }
  return gears.map(({ name, count, places: [[i, side], ...others] }) => {
    const path = ["mesh", i, "teeth", side];
    return { key: path.join("."), path, label: say("edit.of_gear", { gear: name, name: keyName("teeth", "mesh") }), step: 1, range: [Math.min(8, count), Math.max(60, 2 * count)],
      get: ({ mesh: list }) => list[i].teeth[side],
      set: (problem, value) => others.reduce((now, [k, other]) => withPart(now, ["mesh", k, "teeth", other], value), withPart(problem, path, value)) };
  });
}

// Teeth stand first; what else the tables hold is in groups.
export function trainFields(problem) {
  return [...gearFields(problem), ...problemFields(problem, TABLES).filter(({ path: [table, , key] }) => table !== "mesh" || key !== "teeth")];
}

// What the panel says of a train, or of one state of it, beside what it was.
export function trainRows(before, now) {
  const cell = (name, { metrics }) => {
    const { value = null } = metrics.find((metric) => metric.name === name) ?? {};
    return { value, text: value === null ? "–" : trainFactText(name, value) };
  };
  return now.metrics.map(({ name }) => ({ key: name, label: trainFactName(name), before: cell(name, before), now: cell(name, now) }));
}
