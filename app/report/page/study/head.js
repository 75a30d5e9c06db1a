// What the study was, how far it came, and what is shown of it.

import { saveText } from "../controls.js";
import { byId, fact } from "../dom.js";
import { duration, number } from "../format.js";
import { showHead, showNotes, showWork } from "../head.js";
import { language, say, term } from "../words.js";

// The counts of designs that the document names.
function countsLine({ designs, evaluated, kept } = {}, status) {
  if (designs === undefined) return [];
  const done = evaluated !== undefined && evaluated < designs ? evaluated.toLocaleString(language) : null;
  const so = done === null ? say("count.designs", { n: designs }) : say(status === "done" ? "count.evaluated" : "count.evaluated_so_far", { n: designs, done });
  return [so, kept === undefined ? "" : say("count.kept", { n: kept })];
}

function variedText(column, { sampling, samples }) {
  if (column.range) {
    return say(column.log ? "study.sampled_log" : "study.sampled",
      { from: number(column.range[0]), to: number(column.range[1]), n: samples, sampling: say(`sampling.${sampling}`) });
  }
  const values = column.grid ?? [];
  return values.length <= 6 ? values.map((v) => number(v)).join(", ") : say(column.log ? "study.values_log" : "study.values", { from: number(values[0]), to: number(values.at(-1)), n: values.length });
}

function filterText({ min, max, words }) {
  if (words?.length) return words.map(term).join(say("list.or"));
  return min === null ? say("range.at_most", { value: number(max) }) : max === null ? say("range.at_least", { value: number(min) }) : `${number(min)} … ${number(max)}`;
}

export function showStudy(columns, study) {
  const labelOf = (name) => columns.find((column) => column.name === name)?.label ?? name;
  const rows = [[say("study.base"), study.base], ...columns.filter((c) => c.role === "variable").map((c) => [c.label, variedText(c, study)]),
    ...study.filters.map((filter) => [say("study.filter", { name: labelOf(filter.name) }), filterText(filter)]),
    ...columns.filter((c) => c.wanted).map((c) => [say("study.objective"), say(`study.wanted_${c.wanted}`, { name: c.label })])];
  byId("study-list").replaceChildren(...rows.flatMap(([name, value]) => fact(name, value)));
}

export function showStudyHead(data) {
  const { result } = data;
  const title = data.study.title || data.study.base;
  const shown = data.ids.length < data.total
    ? say(data.best.length ? "count.shown_best" : "count.shown", { n: data.total, shown: data.ids.length.toLocaleString(language) }) : "";
  showHead({ ...result, problem: { title } }, say("kind.study"), [...countsLine(result.counts, result.status), shown,
    result.work?.seconds ? duration(result.work.seconds) : ""], say(data.linkage ? "head.keys_study" : "head.keys_filter"));
  showNotes(result.notes ?? []);
  const { designs_per_second: rate, ...work } = result.work ?? {};
  showWork({ ...work, ...(rate ? { designs_per_second: Math.round(rate) } : {}), ...result.counts });
  byId("work-title").textContent = say("study.counted");
  byId("skipped").textContent = "";
  byId("save").textContent = say("save.summary");
  byId("save").addEventListener("click", () => saveText(title, "study.json", "application/json", `${JSON.stringify(result, null, 2)}\n`));
}
