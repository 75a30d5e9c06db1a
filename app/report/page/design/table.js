// The table of designs. Each row has a radio button, so that arrow keys go from design to design.

// The largest error: of an angle in degrees, of a slider as a length.
const largestText = (error, digits) => (error.max_deg === undefined ? number(error.max, digits) : degreesShort(error.max_deg, digits));

// What errors are called where designs are of one kind of problem; none where it has no targets.
const ERRORS = {
  function: { name: "Largest error", best: "largest error", text: ({ error }) => largestText(error, 4) },
  path: { name: "Sum of squares", best: "best sum of squares", text: ({ error }) => number(error.sum_of_squares, 5) },
  motion: { name: "Largest error", best: "largest error", text: ({ error }) => number(error.max, 3) },
};

const straightLength = ({ metrics }) => number(metrics.straight_length_at_0_001, 5);
// Searched designs have one stretch, with its own deviation.
const SEARCHED = [
  { name: "Straight", title: "Length of the straight stretch", text: ({ metrics }) => number(metrics.straight_length, 5), kind: "number" },
  { name: "Deviation", title: "Greatest distance from the best line, over the length", text: ({ metrics }) => number(metrics.deviation_relative, 3), kind: "number" },
  { name: "Size", title: "Largest dimension of a link, coupler point included, over the length", text: ({ metrics }) => number(metrics.size_over_length, 3), kind: "number wide" },
];
const isSearched = ({ metrics }) => metrics.straight_length !== undefined;
const STRAIGHT = { name: "Straight", title: "Length of the stretch that is straight to 0.1 % of it", text: straightLength };

const isFourBar = (d) => d.mechanism.type === "four-bar";

// Class of a four-bar; of another mechanism its type.
const classText = (d) => (isFourBar(d) ? d.metrics.class ?? "–" : d.mechanism.type);

function designColumns(kind, entries) {
  const first = kind === "straight-line" ? STRAIGHT : ERRORS[kind];
  const searched = kind === "straight-line" && entries.some(isSearched);
  return [
    ...(searched ? SEARCHED : first ? [{ ...first, kind: "number" }] : []),
    { name: entries.every(isFourBar) ? "Class" : "Type", text: classText },
    { name: "Transm. angle", text: (d) => transmissionText(d), kind: "number" },
    { name: "K", title: "Time ratio", text: (d) => number(d.metrics.time_ratio, 4), kind: "number wide" },
    { name: "OK", title: "Free of defects, and every constraint met", mark: (d) => faults(d), kind: "sound" },
  ];
}

const transmissionText = ({ metrics: { transmission_angle_deg: t } }) => (t && t.max > 0 ? `${fixed(t.min, 0)}–${fixed(t.max, 0)}°` : "–");
const missed = (d) => (d.constraints ?? []).filter((c) => !c.satisfied);

function originText(d) {
  const of = (index, words) => (index === undefined || index === null ? [] : [`${words} ${index + 1}`]);
  return [d.origin, ...of(d.cognate_of, "cognate of"), ...of(d.mirror_of, "mirror image of")].join("; ");
}

// What is wrong with a design: its defects and the count of other constraints missed; empty for a
// sound one.
function faults(d) {
  const defects = d.metrics.defects ?? [];
  const checks = missed(d).filter((c) => !/^no_.*_defect$/.test(c.name)).length;
  return [...defects, ...(checks ? [`${checks} missed`] : [])].join(", ");
}

function markOf(text) {
  return element("span", { class: `mark ${text ? "no" : "yes"}`, title: text || "yes" }, text ? "✗" : "✓",
    element("span", { class: "wide" }, text ? ` ${text}` : ""));
}

class DesignTable {
  constructor(designs, kind, onChoose) {
    const columns = designColumns(kind, designs.map((design) => design.entry));
    const head = element("tr", {}, element("th", { scope: "col" }, "Design"),
      ...columns.map((c) => element("th", { scope: "col", class: c.kind ?? "", ...(c.title ? { title: c.title } : {}) }, c.name)));
    const table = byId("designs");
    table.tHead.replaceChildren(head);
    this.rows = designs.map((design, i) => this.#row(design.entry, i, columns, onChoose));
    table.append(...this.rows);
  }

  #row(entry, index, columns, onChoose) {
    const radio = element("input", { type: "radio", name: "design", id: `design-${index}`, value: index });
    radio.addEventListener("change", () => onChoose(index));
    const cells = columns.map((c) => element("td", { class: c.kind ?? "" },
      c.mark ? markOf(c.mark(entry)) : c.text(entry)));
    const number = element("td", { rowspan: 2 }, element("label", { for: radio.id }, radio, String(index + 1)));
    const row = element("tbody", {}, element("tr", { class: "main" }, number, ...cells),
      element("tr", {}, element("td", { class: "origin", colspan: columns.length }, originText(entry))));
    row.addEventListener("click", (event) => {
      if (event.target.closest("label, input")) return;
      radio.focus({ preventScroll: true });
      onChoose(index);
    });
    return row;
  }

  choose(index) {
    this.rows.forEach((row, i) => {
      row.classList.toggle("chosen", i === index);
      row.querySelector("input").checked = i === index;
    });
    const frame = byId("designs-frame");
    const row = this.rows[index];
    const head = frame.querySelector("thead").offsetHeight;
    if (row.offsetTop < frame.scrollTop + head) frame.scrollTop = row.offsetTop - head;
    else if (row.offsetTop + row.offsetHeight > frame.scrollTop + frame.clientHeight) frame.scrollTop = row.offsetTop + row.offsetHeight - frame.clientHeight;
  }
}
