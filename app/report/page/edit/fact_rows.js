// Facts of an edited mechanism beside those it had, as the panel of edits shows them.

import { factName, factParts, factText } from "../fact_text.js";
import { isOfComputation } from "../meaning.js";
import { say } from "../words.js";

// In the order of what there is now, but for what is of the computation alone.
export function factRowsOf(before, now) {
  const cell = (name, facts) => {
    const { value = null } = facts.find((fact) => fact.name === name) ?? {};
    return { value, text: factText(value, factParts(name).unit) };
  };
  return now.filter(({ name }) => !isOfComputation(name)).map(({ name }) => ({ key: name, label: factLabel(name), before: cell(name, before), now: cell(name, now) }));
}

const factLabel = (name) => { const { key, where } = factParts(name); return where ? say("edit.place_of", { name: factName(key) }) : factName(key); };
