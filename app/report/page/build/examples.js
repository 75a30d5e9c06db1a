// Mechanisms to begin with.

import { EMPTY, FRAME } from "./model.js";

const pins = (rows) => rows.map(([name, x, y, ...of]) => ({ name, at: [x, y], of }));
const links = (...names) => names.map((name) => ({ name, mass: 0 }));

export const EXAMPLES = {
  four_bar: { ...EMPTY, links: links("L1", "L2", "L3"),
    joints: pins([["A", -25, -15, FRAME, "L1"], ["B", -17, -3, "L1", "L2"], ["C", 20, 18, "L2", "L3"], ["D", 22, -15, FRAME, "L3"], ["P", -6, 26, "L2"]]) },
  slider_crank: { ...EMPTY, links: links("L1", "L2", "S1"), sliders: [{ name: "G1", block: "S1", on: FRAME, degrees: 0, along: null }],
    joints: pins([["A", -35, 0, FRAME, "L1"], ["B", -27, 12, "L1", "L2"], ["C", 17, 0, "L2", "S1"], ["P", -8, 20, "L2"]]) },
  six_bar: { ...EMPTY, links: links("L1", "L2", "L3", "L4", "L5"),
    joints: pins([["A", -38, -14, FRAME, "L1"], ["B", -32, -8, "L1", "L2"], ["C", -8, 18, "L2", "L3"], ["D", -2, -14, FRAME, "L3"],
      ["E", 6, 18, "L3", "L4"], ["F", 34, 22, "L4", "L5"], ["G", 30, -14, FRAME, "L5"], ["P", 22, 34, "L4"]]) },
  quick_return: { ...EMPTY, links: links("L1", "L2", "L3", "S1", "S2"),
    sliders: [{ name: "G1", block: "S1", on: "L2", degrees: 90, along: ["C", "D"] }, { name: "G2", block: "S2", on: FRAME, degrees: 0, along: null }],
    joints: pins([["A", 0, 0, FRAME, "L1"], ["B", 0, 12, "L1", "S1"], ["C", 0, -32, FRAME, "L2"], ["D", 0, 26, "L2", "L3"], ["E", 32, 30, "L3", "S2"]]) },
};
