// The head and the foot of a report: what it is of, how the run ended, what it took.

import { byId, element, fact } from "./dom.js";
import { duration, number, sentence } from "./format.js";
import { showProblem, withNamedLinks } from "./problem.js";
import { language, say, sentenceOf, term } from "./words.js";

const TONES = { solved: "good", done: "good", infeasible: "warn", "time-limit": "warn", interrupted: "warn", "no-solution": "bad" };

// `summary`: the parts of the line below the title; `keys`: what the keyboard does; `ends`: the text
// of a status where that of designs does not fit.
export function showHead(result, kind, summary, keys, ends = {}) {
  const title = result.problem?.title || say("head.untitled");
  document.title = `${title} – Cognate`;
  byId("title").textContent = title;
  byId("kind").textContent = kind;
  showProblem(result.problem, kind, withNamedLinks(result.problem, (result.designs ?? []).flatMap(({ mechanism }) => mechanism?.dyad ?? [])));
  byId("status").textContent = say(ends[result.status] ?? `status.${result.status}`);
  byId("status").classList.add(TONES[result.status]);
  // A time stays with its unit where a line ends.
  byId("summary").textContent = summary.filter(Boolean).map((part) => part.replace(/ (?=[mµ]?s$)/, "\u00a0")).join(" · ");
  const version = ["Cognate", result.version, result.seed === undefined ? "" : `· ${say("head.seed", { seed: result.seed })}`].filter(Boolean).join(" ");
  byId("version").textContent = `${version} · ${keys}`;
  // Paper has no keys, and names its origin at its head.
  document.querySelector(".page-head").dataset.version = version;
}

// `warnings`: of the whole answer; those of one design stand beside it.
export function showNotes(notes, warnings = []) {
  byId("notes").hidden = notes.length + warnings.length === 0;
  // The picture that moves comes first, its texts next.
  document.querySelector("#main > .side")?.after(byId("notes"));
  byId("notes-list").replaceChildren(...warnings.map((text) => noteItem(text, "warning")), ...notes.map((note) => noteItem(note)));
}

// The warnings of the design chosen, below the list of designs.
export function showWarnings({ warnings = [] } = {}) {
  const list = byId("design-warnings");
  list.replaceChildren(...warnings.map((text) => noteItem(text)));
}

// A note in the reader's language where there are words for it, else in the English of the result.
function noteItem(note, kind) {
  const said = sentenceOf(note);
  return element("li", { ...(said === note ? { lang: "en" } : {}), ...(kind ? { class: kind } : {}) }, `${kind ? "⚠ " : ""}${said}`);
}

// What is proved of the best design, as one of the notes.
export function certificateNote(certificate) {
  if (!certificate) return [];
  const { complete, lower_bound: lower, upper_bound: upper, gap_relative: gap, domain } = certificate;
  return [say(complete ? "certificate.complete" : "certificate.incomplete",
    { upper: number(upper), lower: number(lower), gap: number(100 * gap, 3), domain: sentenceOf(domain) })];
}

// Of the counts of all kinds of work those that there are.
export function showWork(work) {
  const { skipped = [], ...counts } = work ?? {};
  byId("work-list").replaceChildren(...Object.entries(counts).filter(([, count]) => count !== 0).map(([name, value]) =>
    element("div", {}, ...(name === "seconds" ? fact(say("work.seconds"), duration(value)) : fact(sentence(term(name.replaceAll("_", " "))), value.toLocaleString(language))))));
  byId("skipped").textContent = skipped.length ? say("work.skipped", { list: skipped.map(term).join(say("list.comma")) }) : say("work.none_skipped");
}
