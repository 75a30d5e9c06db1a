// What can be changed of a machine: the numbers of its problem.

import { problemFields } from "../edit/problem_model.js";
import { machineFactName, machineFactText } from "./facts.js";

const TABLES = ["mechanism", "link", "load", "gravity", "equivalent", "motor", "flywheel", "brake", "run"];

// Rows of functions are no fields of a form, nor is how exactly a run is computed.
const NO_FIELD = /^(table|tolerance)$/;
const MOST_ROWS = 8;

// A machine that takes longer than this to run is none to be changed by hand; nor is one of very many links.
const LONGEST_RUN = 3, MOST_NUMBERS = 400;

const isRows = (value) => Array.isArray(value) && value.length > MOST_ROWS;

export function machineFields(problem) {
  const withinRows = ({ path }) => path.some((key, i) => NO_FIELD.test(key) || isRows(path.slice(0, i + 1).reduce((part, step) => part[step], problem)));
  return problemFields(problem, TABLES).filter((field) => !withinRows(field));
}

export const isEditable = ({ problem, work }) => Boolean(problem?.run) && (work?.seconds ?? 0) < LONGEST_RUN && machineFields(problem).length <= MOST_NUMBERS;

const factsOf = ({ facts }) => new Map(facts.map(({ name, value }) => [name, value]));

// What the panel says of the machine now beside what it was.
export function machineRows(before, now) {
  const [was, is] = [before, now].map(factsOf);
  const cell = (name, facts) => ({ value: facts.get(name) ?? null, text: facts.has(name) ? machineFactText(name, facts) : "–" });
  return [...is.keys()].filter((name) => !name.endsWith("_at_deg")).map((name) => ({ key: name, label: machineFactName(name), before: cell(name, was), now: cell(name, is) }));
}
