// What the panel says of an edited design beside what it was.

function editRows(before, now) {
  const rows = (text) => [text(before), text(now)];
  const angle = (key) => rows(({ facts }) => degrees(facts[key] / RADIANS, 2));
  const swing = ({ motion: { rocker_deg: list } }) => degrees(Math.max(...list) - Math.min(...list), 2);
  const defects = ({ facts }) => facts.defects.map((name) => term(name)).join(say("list.comma")) || say("edit.none");
  return [
    [say("edit.class"), ...rows(({ facts }) => term(facts.class))],
    [say("edit.grashof"), ...rows(({ facts }) => (facts.changePoint ? say("edit.change_point") : say(facts.excess < 0 ? "edit.holds" : "edit.fails")))],
    [say("edit.rotates"), ...rows(({ facts }) => say(facts.rotates ? "edit.yes" : "edit.no"))],
    [say("edit.least"), ...angle("least")],
    [say("edit.greatest"), ...angle("greatest")],
    [say("edit.time_ratio"), ...rows(({ facts }) => (facts.timeRatio === null ? "–" : fixed(facts.timeRatio, 4)))],
    [say("edit.swing"), ...rows(swing)],
    ...(before.error || now.error ? changedErrors(before, now) : []),
    [say("edit.defects"), ...rows(defects)],
  ];
}

function changedErrors(before, now) {
  const text = (key) => [before, now].map(({ error, angular }) => (!error ? say("edit.unmet") : angular ? degreesShort(error[key] / RADIANS, 5) : number(error[key], 5)));
  const sum = [before, now].map(({ error }) => (error ? number(error.sum_of_squares, 5) : say("edit.unmet")));
  return [[say("edit.error.max"), ...text("max")], [say("edit.error.rms"), ...text("rms")], [say("edit.error.sum"), ...sum]];
}

// One constraint of the design: its name, bound, value now, and whether it is met (null: not known here).
function checkRow(check, evaluated) {
  const found = checkOf(check, evaluated);
  if (!found) return [check.name, boundText(check.bound), say("edit.program"), null];
  const value = typeof found.value === "number" ? number(found.value, 5) : found.value === null ? "–" : term(found.value);
  return [check.name, boundText(check.bound), value, found.met];
}
