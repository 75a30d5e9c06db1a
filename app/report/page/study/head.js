// What the study was, how far it came, and what is shown of it.

// The counts of designs that the document names.
function countsLine({ designs, evaluated, kept } = {}, status) {
  const count = (n) => n.toLocaleString("en");
  if (designs === undefined) return [];
  const so = evaluated !== undefined && evaluated < designs ? `${count(evaluated)} of ${plural(designs, "design")} evaluated${status === "done" ? "" : " so far"}` : `${plural(designs, "design")}`;
  return [so, kept === undefined ? "" : `${plural(kept, "row")} kept`];
}

const SAMPLINGS = { sobol: "Sobol points", halton: "Halton points", latin: "a Latin hypercube", random: "random points" };

function variedText(column, { sampling, samples }) {
  const scale = column.log ? ", logarithmic" : "";
  if (column.range) return `${number(column.range[0])} … ${number(column.range[1])}, ${plural(samples, "sample")} (${SAMPLINGS[sampling]})${scale}`;
  const values = column.grid ?? [];
  return values.length <= 6 ? values.map((v) => number(v)).join(", ") : `${number(values[0])} … ${number(values.at(-1))}, ${plural(values.length, "value")}${scale}`;
}

function filterText({ min, max, words }) {
  if (words?.length) return words.join(" or ");
  return min === null ? `at most ${number(max)}` : max === null ? `at least ${number(min)}` : `${number(min)} … ${number(max)}`;
}

function showStudy(columns, study) {
  const rows = [["Base", study.base], ...columns.filter((c) => c.role === "variable").map((c) => [c.name, variedText(c, study)]),
    ...study.filters.map((filter) => [`Filter: ${filter.name}`, filterText(filter)]),
    ...columns.filter((c) => c.wanted).map((c) => ["Objective", `${c.wanted} ${c.name}`])];
  byId("study-list").replaceChildren(...rows.flatMap(([name, value]) => {
    const [dt, dd] = fact("", value);
    dt.append(...breakable(name));
    return [dt, dd];
  }));
}

function showStudyHead(data) {
  const { result } = data;
  const title = data.study.title || data.study.base;
  const shown = data.ids.length < data.total ? `${data.ids.length.toLocaleString("en")} of ${plural(data.total, "row")} shown${data.best.length ? ", the best among them" : ""}` : "";
  showHead({ ...result, problem: { title } }, "Design study", [...countsLine(result.counts, result.status), shown,
    result.work?.seconds ? duration(result.work.seconds) : ""], data.linkage ? "space plays, ← → turn the crank" : "brushes filter");
  showNotes(result.notes ?? []);
  const { designs_per_second: rate, ...work } = result.work ?? {};
  showWork({ ...work, ...(rate ? { designs_per_second: Math.round(rate) } : {}), ...result.counts });
  byId("work-title").textContent = "Counted";
  byId("skipped").textContent = "";
  byId("save").textContent = "Save the summary as JSON";
  byId("save").addEventListener("click", () => saveText(title, "study.json", "application/json", `${JSON.stringify(result, null, 2)}\n`));
}
