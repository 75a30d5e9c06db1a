// Why links cannot be assembled: the longest, and what it would have to bridge.

import { number } from "../format.js";
import { say } from "../words.js";
import { lengthOf, minus } from "./four_bar.js";

export function brokenText({ fixed_pivots: [a, d], crank, coupler, rocker }) {
  const links = Object.entries({ crank, coupler, rocker, frame: lengthOf(minus(d, a)) }).sort((p, q) => q[1] - p[1]);
  const [[name, longest], ...others] = links;
  const sum = others.reduce((total, [, length]) => total + length, 0);
  if (longest > sum) return say("edit.broken", { name: say(`edit.field.${name}`), length: number(longest, 4), sum: number(sum, 4) });
  return say("edit.nowhere");
}
