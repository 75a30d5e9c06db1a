// What a mechanism that is built still lacks, in a sentence.

import { degrees, number, sentence } from "../format.js";
import { say, sentenceOf } from "../words.js";
import { driverOf, isFixed, joinedToFrame, mobilityOf } from "./model.js";

// The first that is missing; empty where the kernel can be asked.
export function lackOf(state) {
  const { joints, sliders, links } = state;
  if (links.length === 0) return say(joints.length ? "build.lacks_links" : "build.lacks_all");
  if (!joints.some(isFixed) && sliders.length === 0) return say("build.lacks_pivot");
  const joined = joinedToFrame(state), loose = links.filter(({ name }) => !joined.has(name)).map(({ name }) => name);
  if (loose.length) return say("build.lacks_joint", { n: loose.length, names: loose.join(say("list.comma")) });
  const mobility = mobilityOf(state);
  if (mobility > 1) return say("build.moves_freely", { mobility, extra: mobility - 1 });
  if (mobility < 1) return say("build.is_rigid", { mobility: String(mobility).replace("-", "−") });
  return driverOf(state) ? "" : say("build.lacks_drive");
}

// What the kernel's sentences begin with that are of the file.
const OF_FILE = /^mechanism\.joint /;

// Where the drive stands.
export const driveText = (drive, isTurning, decimals) => (isTurning ? degrees(drive, decimals) : number(drive, 4));

// What is missing, what the kernel refuses, or how far the mechanism moves.
export function stateText(state, { motion, faults, range }) {
  if (faults) return faults.map((fault) => `${sentence(sentenceOf(fault.replace(OF_FILE, "the drawing "))).replace(/[.。]$/, "")}${say("build.full_stop")}`).join(" ");
  if (!motion) return lackOf(state);
  const { from, to } = motion.mechanism, [low, high] = [from, to].map((x) => driveText(x, motion.isTurning, 1));
  return say(!motion.isTurning ? "build.slides" : range ? "build.swings" : "build.turns", { from: low, to: high });
}
