// What holds for the machine's motions as a whole.

import { byId, fact } from "../dom.js";
import { factName, factText } from "../fact_text.js";
import { degreesShort, number } from "../format.js";
import { isOfComputation, showMore } from "../meaning.js";
import { errorText } from "../rounding.js";
import { say } from "../words.js";

const MACHINE_FACTS = {
  speed_mean_rad_s: "rad/s", speed_max_rad_s: "rad/s", speed_min_rad_s: "rad/s", fluctuation: "", fluctuation_without_flywheel: "",
  flywheel_inertia_kg_m2: "kg·m²", flywheel_inertia_approximate_kg_m2: "kg·m²", greatest_excess_work_J: "J", period_s: "s", energy_swing_J: "J",
  motor_work_J: "J", motor_power_mean_W: "W", motor_power_max_W: "W", multiplier: "", energy_residual: "",
  start_time_s: "s", start_turns: "", start_end_speed_rad_s: "rad/s", stop_time_s: "s", stop_turns: "", stop_end_speed_rad_s: "rad/s",
  train_ratio: "", train_ratio_exact: "", train_efficiency: "", train_reverse_efficiency: "", train_self_locking: "", train_inertia_kg_m2: "kg·m²",
};

export const machineFactName = (name) => (name in MACHINE_FACTS ? say(`machine.fact.${name}`) : factName(name));

export function machineFactText(name, facts) {
  const value = facts.get(name);
  const text = typeof value === "number" ? `${number(value, 6)} ${MACHINE_FACTS[name] ?? ""}`.trim() : factText(value, "");
  const place = facts.get(name.replace(/_rad_s$/, "_at_deg"));
  return typeof place === "number" && name.endsWith("_rad_s") ? say("fact.at", { value: text, place: degreesShort(place, 5) }) : text;
}

// Those that there are in the order of the list, with their exact values beside the pointer.
export function showMachineFacts(facts) {
  const known = Object.keys(MACHINE_FACTS).filter((name) => facts.has(name) && !isOfComputation(name));
  const others = [...facts.keys()].filter((name) => !(name in MACHINE_FACTS) && !/_at_deg$/.test(name));
  byId("facts-list").replaceChildren(...known.flatMap((name) => fact(machineFactName(name), machineFactText(name, facts), String(facts.get(name)))),
    ...others.flatMap((name) => fact(factName(name), factText(facts.get(name), ""))));
  showMore(byId("facts"), [...facts].filter(([name]) => isOfComputation(name)).map(([name, value]) => [name, machineFactName(name), errorText(value, 1, (x) => number(x, 3)), value]));
  byId("facts").hidden = facts.size === 0;
}
