// What the panel says of an edited design beside what it was.

import { checkBound, checkName, checkValue } from "../checks.js";
import { lengthText, squaresText } from "../fact_text.js";
import { degrees, degreesShort, fixed } from "../format.js";
import { RADIANS } from "../sampling.js";
import { say, term } from "../words.js";
import { checkOf } from "./checks.js";

// A row: its key, and `show`'s text and whole value of what `value` takes from each of the two.
function editRow(key, [before, now], value, show) {
  const cell = (evaluated) => ({ value: value(evaluated), text: show(value(evaluated)) });
  return { key, before: cell(before), now: cell(now) };
}

const shownAngle = (angle) => degrees(angle / RADIANS, 2);
const yesOrNo = (is) => say(is ? "edit.yes" : "edit.no");

export function editRows(before, now) {
  const row = (key, value, show) => editRow(key, [before, now], value, show);
  return [
    row("class", ({ facts }) => facts.class, term),
    row("grashof", ({ facts }) => (facts.changePoint ? "change_point" : facts.excess < 0 ? "holds" : "fails"), (key) => say(`edit.${key}`)),
    row("rotates", ({ facts }) => facts.rotates, yesOrNo),
    row("least", ({ facts }) => facts.least, shownAngle),
    row("greatest", ({ facts }) => facts.greatest, shownAngle),
    row("time_ratio", ({ facts }) => facts.timeRatio, (ratio) => fixed(ratio, 4)),
    row("swing", ({ swing }) => swing, (deg) => degrees(deg, 2)),
    ...changedErrors(before, now),
    defectsRow(before, now, ({ facts }) => facts.defects)];
}

// The row of the defects that `defectsOf` takes from each of the two.
export const defectsRow = (before, now, defectsOf) => editRow("defects", [before, now], defectsOf, (list) => list.map(term).join(say("list.comma")) || say("edit.none"));

// None where the problem has no targets.
function changedErrors(before, now) {
  const known = before.error ?? now.error;
  if (!known) return [];
  const angle = (value) => degreesShort(value / RADIANS, 5);
  const length = (value) => lengthText(value, 5);
  const squares = (value) => squaresText(value, 5, before.angular);
  const row = (key, member, show) => editRow(`error.${key}`, [before, now], ({ error }) => error?.[member] ?? null,
    (value) => (value === null ? say("edit.unmet") : show(value)));
  return [row("max", "max", before.angular ? angle : length), row("rms", "rms", before.angular ? angle : length), row("sum", "sum_of_squares", squares),
    ...(known.turned === undefined ? [] : [row("turned", "turned", angle)])];
}

// One constraint of the design: its name, bound, value now, and whether it is met (null: not known here).
export function checkRow(check, evaluated) {
  const found = checkOf(check, { ...evaluated, starts: evaluated.state.starts });
  if (!found) return [checkName(check), checkBound(check), say("edit.program"), null];
  return [checkName(check), checkBound(check), checkValue({ ...check, value: found.value }), found.met];
}
