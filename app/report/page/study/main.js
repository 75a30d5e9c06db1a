// The page of a study: its rows, which of them pass, and the one that is open.

import { followTheme } from "../appearance.js";
import { saveText } from "../controls.js";
import { byId, element } from "../dom.js";
import { embedded } from "../embedded.js";
import { language, say } from "../words.js";
import { Atlas } from "./atlas.js";
import { columnsOf } from "./columns.js";
import { Contour } from "./contour.js";
import { DesignPanel } from "./design.js";
import { ColumnTable, Filters } from "./filters.js";
import { showStudy, showStudyHead } from "./head.js";
import { Paint } from "./paint.js";
import { Parallel } from "./parallel.js";
import { RowTable } from "./rows.js";
import { Scatter } from "./scatter.js";

const data = JSON.parse(embedded("data"));
const columns = columnsOf(data);
const count = data.ids.length;
const drawn = columns.filter((column) => !column.empty);
const objectives = drawn.filter((column) => column.wanted);
const best = new Set(data.best);
const study = { ids: data.ids, count, columns, best, filters: new Filters(columns, count), selected: count ? data.best[0] ?? 0 : null, paint: new Paint(null) };
const canDraw = typeof d3 !== "undefined";
const views = [];

function select(row) {
  study.selected = row;
  design.show();
  for (const view of views) view.select();
}

// Filters once in a frame, however fast the brush moves.
let waiting = false;
// What takes long follows when the brush rests for so many milliseconds.
const SLOW = 120;
let slowly = 0;
function filter(column, range) {
  study.filters.choose(column, range);
  if (!waiting) requestAnimationFrame(() => { waiting = false; showFiltered(); });
  waiting = true;
}

function showFiltered() {
  showCount();
  for (const view of views) if (!view.slow) view.filtered();
  clearTimeout(slowly);
  slowly = setTimeout(() => { for (const view of views) if (view.slow) view.filtered(); }, SLOW);
}

function showCount() {
  const { filters } = study;
  byId("count").textContent = filters.any ? say("count.passing", { n: count, passing: filters.rows.length.toLocaleString(language) }) : say("count.rows", { n: count });
  byId("clear").hidden = !filters.any;
  table.update(filters, (column) => !parallel || parallel.shown.includes(column));
}

function paintBy(column) {
  study.paint = new Paint(column);
  repaint();
}

function repaint() {
  if (!canDraw) return;
  study.paint.prepare();
  for (const key of document.querySelectorAll("[data-key]")) key.replaceChildren(...study.paint.key());
  for (const view of views) view.draw();
}

// A select of columns; `choose` is called with the one chosen. Those with the same `choice` agree.
function selects(choice, list, chosen, choose, none) {
  const all = [...document.querySelectorAll(`[data-choice="${choice}"]`)];
  for (const one of all) {
    one.replaceChildren(...(none ? [element("option", { value: -1 }, none)] : []), ...list.map((column) => element("option", { value: column.index }, column.label)));
    one.value = chosen?.index ?? -1;
    one.addEventListener("change", () => {
      for (const other of all) other.value = one.value;
      choose(columns[Number(one.value)] ?? null);
    });
  }
}

// What is against what at first: the objectives, else the first numbers that vary.
function firstPair(numbers) {
  const varying = numbers.filter((column) => !column.constant);
  const metrics = varying.filter((column) => column.role === "metric" && !column.wanted);
  const variables = varying.filter((column) => column.role === "variable");
  return [...objectives.length > 1 ? objectives : [...variables.slice(0, 1), ...objectives, ...metrics, ...variables.slice(1)], ...numbers, ...numbers].slice(0, 2);
}

function startScatter() {
  const scatter = new Scatter(byId("scatter-plane"), study, { select });
  let [x, y] = firstPair(drawn.filter((column) => !column.words));
  views.push(scatter);
  selects("x", drawn, x, (column) => { x = column; scatter.choose(x, y); });
  selects("y", drawn, y, (column) => { y = column; scatter.choose(x, y); });
  scatter.choose(x, y);
  scatter.watch();
}

function startContour() {
  const numbers = drawn.filter((column) => !column.words);
  const variables = numbers.filter((column) => column.role === "variable" && !column.constant);
  byId("contour").hidden = numbers.length < 3;
  if (numbers.length < 3) return;
  const levels = (column) => column.grid?.length ?? Infinity;
  let [x, y] = [...[...variables].sort((a, b) => (levels(a) === levels(b) ? a.index - b.index : levels(b) - levels(a))), ...numbers];
  if (x === y) y = numbers.find((column) => column !== x);
  let z = objectives.find((column) => !column.words && column !== x && column !== y) ?? numbers.find((column) => column.role === "metric" && !column.constant) ?? numbers[2];
  const contour = new Contour(byId("contour-plane"), study, { select });
  const choose = () => contour.choose(z, x, y);
  views.push(contour);
  selects("z", numbers, z, (column) => { z = column; choose(); });
  selects("across", numbers, x, (column) => { x = column; choose(); });
  selects("up", numbers, y, (column) => { y = column; choose(); });
  choose();
  contour.watch();
}

function startParallel() {
  const made = new Parallel(byId("axes"), study, { filter, changed: () => table.update(study.filters, (column) => made.shown.includes(column)) });
  views.push(made);
  made.build();
  let width = byId("axes").clientWidth;
  new ResizeObserver(() => { if (byId("axes").clientWidth !== width) { width = byId("axes").clientWidth; made.build(); } }).observe(byId("axes"));
  return made;
}

function startAtlas() {
  const withPoint = Boolean(data.linkage?.coupler_point) && count > 0;
  byId("atlas").hidden = !withPoint;
  if (!withPoint) return;
  const atlas = new Atlas(study, (row) => design.linkageOf(row), { select });
  views.push(atlas);
  atlas.filtered();
}

showStudyHead(data);
showStudy(columns, data.study);
const table = new ColumnTable(drawn, { filter, show: (column, shown) => parallel.show(column, shown) });
const design = new DesignPanel(data, study, { select });
const rows = new RowTable(study, { select });
views.push(rows);
rows.filtered();
let parallel = null;
if (canDraw && count) {
  const first = objectives.find((column) => column.role === "metric") ?? objectives[0] ?? drawn.find((column) => column.role === "metric" && !column.constant) ?? drawn[0];
  selects("colour", drawn, first, paintBy, say("parallel.no_colour"));
  study.paint = new Paint(first);
  repaint();
  parallel = startParallel();
  startScatter();
  startContour();
  startAtlas();
} else {
  byId("main").classList.add("plain");
  for (const part of document.querySelectorAll("#scatter, #contour, #parallel .choices label")) part.hidden = true;
  byId("axes").replaceChildren(element("p", { class: "muted" }, say(count ? "rows.no_library" : "rows.none_kept")));
}
showCount();
design.show();
followTheme(() => { repaint(); parallel?.build(); });
byId("clear").addEventListener("click", () => { study.filters.clear(); showFiltered(); });
byId("save-rows").addEventListener("click", () => saveText(data.study.title, "csv", "text/csv", rows.csv));
byId("rows-note").textContent = say("rows.note");
