// The head and the foot of a report: what it is of, how the run ended, what it took.

const STATUS = {
  solved: ["good", "Solved"], infeasible: ["warn", "No design meets every constraint"], "no-solution": ["bad", "No solution"],
  done: ["good", "Done"], "time-limit": ["warn", "Stopped at the time limit"], interrupted: ["warn", "Interrupted"],
};

// `summary`: the parts of the line below the title; `keys`: what the keyboard does.
function showHead(result, kind, summary, keys) {
  const title = result.problem?.title || "Untitled problem";
  document.title = `${title} – Cognate`;
  byId("title").textContent = title;
  byId("kind").textContent = kind;
  const [tone, text] = STATUS[result.status] ?? ["warn", result.status];
  byId("status").textContent = text;
  byId("status").classList.add(tone);
  byId("summary").textContent = summary.filter(Boolean).join(" · ");
  byId("version").textContent = ["Cognate", result.version, result.seed === undefined ? "" : `· seed ${result.seed}`, `· ${keys}`]
    .filter(Boolean).join(" ");
}

function showNotes(notes) {
  byId("notes").hidden = notes.length === 0;
  byId("notes-list").replaceChildren(...notes.map((note) => element("li", {}, note)));
}

// What is proved of the best design, as one of the notes.
function certificateNote(certificate) {
  if (!certificate) return [];
  const { complete, lower_bound: lower, upper_bound: upper, gap_relative: gap, domain } = certificate;
  return [complete
    ? `Certified: the sum of squares ${number(upper)} is within ${number(gap)} of the least possible among ${domain}.`
    : `Not certified in the time given: the sum of squares is ${number(upper)}, the least possible at least ${number(lower)}, among ${domain}.`];
}

// Of the counts of all kinds of work those that there are.
function showWork(work) {
  const { skipped = [], ...counts } = work ?? {};
  byId("work-list").replaceChildren(...Object.entries(counts).filter(([, count]) => count !== 0).map(([name, value]) =>
    element("div", {}, ...(name === "seconds" ? fact("Time", duration(value)) : fact(sentence(name.replaceAll("_", " ")), value.toLocaleString("en"))))));
  byId("skipped").textContent = skipped.length ? `Skipped, since nothing asked for it: ${skipped.join(", ")}.` : "Nothing was skipped.";
}
