// What the limits cost: the error that there would be without each of them.

import { byId } from "../dom.js";
import { say } from "../words.js";
import { rmsText } from "./cards.js";
import { ANY_SPEED, questionFor } from "./question.js";

const ANY_REACH = 10;
const MATTERS = 0.9;   // of the error within all limits: what is not below that is no gain

// Each limit: whether it holds, and the state without it.
const LIMITS = {
  class: { holds: (state) => state.class !== "any" && !state.obstacle, without: (state) => ({ ...state, class: "any" }) },
  least: { holds: (state) => state.least > 0, without: (state) => ({ ...state, least: 0 }) },
  region: { holds: (state) => state.region !== null, without: (state) => ({ ...state, region: null }) },
  obstacle: { holds: (state) => state.obstacle !== null, without: (state) => ({ ...state, obstacle: null }) },
  even: { holds: (state) => state.straight && state.even < ANY_SPEED, without: (state) => ({ ...state, even: ANY_SPEED }) },
  reach: { holds: (state) => state.reach < ANY_REACH, without: (state) => ({ ...state, reach: ANY_REACH }) },
};

// The questions that tell, for a state with a design that is not exact or with none.
export const costQuestions = (state) => Object.entries(LIMITS).filter(([, { holds }]) => holds(state)).map(([limit, { without }]) => ({ ...questionFor(without(state)), limit }));

// Says what the answer to one of them tells. `error`: the least within all limits.
export function showCost({ designs = [] }, { limit }, state, error) {
  const without = Math.min(...designs.map(({ rms }) => rms));
  byId(`cost-of-${limit}`).textContent = without < MATTERS * error ? say(state.straight ? "sketch.cost_of_line" : "sketch.cost", { error: rmsText(without, state) }) : "";
}

export function clearCosts() { for (const limit of Object.keys(LIMITS)) byId(`cost-of-${limit}`).textContent = ""; }
