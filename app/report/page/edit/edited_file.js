// The file of an edited design: the problem of the page with the dimensions as they are now. Where its
// kind takes dimensions as given, `cognate solve` judges them by target and constraints, and finds those anew
// whose lines are removed; else they stand in it as remarks.

import { problemToml } from "../toml.js";
import { say } from "../words.js";
import { lengthOf, minus } from "./four_bar.js";

export const remark = (text) => `# ${text.replaceAll("\n", "\n# ")}\n`;

// The mechanism's table of a problem with all of a four-bar given; nothing for kinds that take none so.
function givenMechanism({ kind, mechanism: asked = {} }, m, starts) {
  const { crank, coupler, rocker, assembly, coupler_point: point, fixed_pivots: [a, d] } = m;
  if (kind === "path-generation") return { type: "four-bar", crank, coupler, rocker, pivot_a: a, pivot_d: d, coupler_point: point, assembly };
  if (kind !== "function-generation" || asked.type === "slider-crank") return undefined;
  return { type: "four-bar", crank, coupler, rocker, frame: lengthOf(minus(d, a)), assembly, ...(starts ? { input_start_deg: starts.input, output_start_deg: starts.output } : {}) };
}

// The bounds that the dimensions keep: what is given beyond a bound, a file may not have.
function boundsKept(bounds, m) {
  const [a, d] = m.fixed_pivots;
  const values = { ...m, frame: lengthOf(minus(d, a)), pivot_a: a, pivot_d: d };
  const keeps = (value, [low, high]) => (Array.isArray(value) ? value.every((x, k) => x >= low[k] && x <= high[k]) : value >= low && value <= high);
  return Object.fromEntries(Object.entries(bounds).filter(([key, bound]) => values[key] === undefined || !Array.isArray(bound) || keeps(values[key], bound)));
}

export function editedFile(problem, title, mechanism, starts) {
  const given = givenMechanism(problem, mechanism, starts);
  if (given) return remark(say("edit.file.given")) + problemToml({ ...problem, title, mechanism: given, ...(problem.bounds ? { bounds: boundsKept(problem.bounds, mechanism) } : {}) });
  const dimensions = Object.entries(mechanism).map(([key, value]) => `${key} = ${JSON.stringify(value)}`).join("\n");
  return problemToml({ ...problem, title }) + remark(`${say("edit.file.remark")}\n${dimensions}`);
}
