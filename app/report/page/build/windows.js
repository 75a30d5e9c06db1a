// When a load acts, as one chooses it: always, between positions of the drive, or as a link goes one way or in a part of its stroke.

import { say } from "../words.js";
import { linksOfLoad } from "./model.js";

const STROKE = [0.1, 0.9], BETWEEN = [0, 180];
const ALWAYS = "always", ANGLES = "angles";

const keyOf = ({ link, when, stroke }) => (Array.isArray(when) ? ANGLES : `${when}${stroke ? " stroke" : ""} ${link}`);
const ofLink = (link) => [["advance", null], ["return", null], ["always", STROKE], ["advance", STROKE], ["return", STROKE]].map(([when, stroke]) => ({ link, when, stroke }));

function textOf({ link, when, stroke }) {
  const kind = when === ALWAYS ? "stroke" : stroke ? `${when}_stroke` : when;
  return say(`build.acts_${kind}`, { link });
}

// [key, text] of all that can be chosen for a load, and the key of what is.
export function optionsOfWindow(state, load) {
  const windows = linksOfLoad(state, load).flatMap(ofLink);
  return { options: [[ALWAYS, say("build.acts_always")], [ANGLES, say("build.acts_angles")], ...windows.map((window) => [keyOf(window), textOf(window)])], value: load.window ? keyOf(load.window) : ALWAYS };
}

// The window of what is chosen, with the ends that it had; null: always.
export function windowOfOption(state, load, key) {
  const { window = null } = load, links = linksOfLoad(state, load);
  if (key === ALWAYS) return null;
  if (key === ANGLES) return { link: window?.link ?? links[0], when: Array.isArray(window?.when) ? window.when : BETWEEN, stroke: null };
  const chosen = links.flatMap(ofLink).find((one) => keyOf(one) === key);
  return { ...chosen, stroke: chosen.stroke && (window?.stroke ?? chosen.stroke) };
}
