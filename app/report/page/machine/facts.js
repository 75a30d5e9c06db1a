// What holds for the machine's motions as a whole.

const MACHINE_FACTS = { speed_mean: "rad/s", speed_max: "rad/s", speed_min: "rad/s", fluctuation: "", period: "s", flywheel_inertia: "kg·m²", flywheel_inertia_approximate: "kg·m²",
  greatest_excess_work: "J", motor_power_mean: "W", motor_power_max: "W", energy_residual: "", multiplier: "", start_time: "s", start_turns: "", start_speed_end: "rad/s", stop_time: "s", stop_turns: "" };

function machineFactText(name, facts) {
  const value = facts.get(name);
  const text = typeof value === "number" ? `${number(value, 6)} ${MACHINE_FACTS[name]}`.trim() : factText(value, "");
  const place = facts.get(`${name}_at_deg`);
  return typeof place === "number" ? say("fact.at", { value: text, place: degreesShort(place, 5) }) : text;
}

// Those that there are in the order of the list, with their exact values beside the pointer.
function showMachineFacts(facts) {
  const known = Object.keys(MACHINE_FACTS).filter((name) => facts.has(name));
  const others = [...facts.keys()].filter((name) => !(name in MACHINE_FACTS) && !/_at_deg$/.test(name));
  byId("facts-list").replaceChildren(...known.flatMap((name) => fact(say(`machine.fact.${name}`), machineFactText(name, facts), String(facts.get(name)))),
    ...others.flatMap((name) => fact(factName(name), factText(facts.get(name), ""))));
  byId("facts").hidden = facts.size === 0;
}
