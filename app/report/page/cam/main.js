// The page of a cam: where it stands, and everything that follows from it.

import { followTheme } from "../appearance.js";
import { checkRows, showChecks, showMetrics } from "../checks.js";
import { Controls, saveResult, saveText } from "../controls.js";
import { Curves } from "../curves.js";
import { byId, element } from "../dom.js";
import { embedded } from "../embedded.js";
import { Extras } from "../extras.js";
import { degrees, duration, fixed } from "../format.js";
import { showHead, showNotes, showWarnings, showWork } from "../head.js";
import { Saves } from "../saves.js";
import { legendItem } from "../shapes.js";
import { offerNoEdit } from "../original.js";
import { showProblem } from "../problem.js";
import { makeSortable } from "../sortable.js";
import { Trace } from "../trace.js";
import { Kernel } from "../kernel.js";
import { TableEditor } from "../edit/table_editor.js";
import { camFields, camRows, givenCam } from "./edited.js";
import { LENGTH_UNIT, say, sentenceOf } from "../words.js";
import { Zoom } from "../zoom.js";
import { showRaster } from "../design/raster.js";
import { camCsv, camMetrics, CamValues, radiusText, showCamDimensions, showSegments, withNamedRadius } from "./facts.js";
import { ToleranceCard } from "../tolerance/card.js";
import { CamMover } from "../tolerance/of_cam.js";
import { CamDesign } from "./model.js";
import { CamScene } from "./scene.js";
import { camSheets, JUMP_COLOURS, JUMPS, missesPressure } from "./sheets.js";

const data = JSON.parse(embedded("data"));
const { result } = data;
const designs = data.designs.map((drawn) => new CamDesign(drawn, data));
const state = { index: 0, deg: 0, turns: 0, byTime: false };
const scene = new CamScene(byId("picture"), (deg) => goTo(deg, true));
const curves = new Curves(byId("plots"), (deg) => { if (deg !== null) goTo(deg, true); }, (deg) => extras.point(deg));
const extras = new Extras(document.querySelector(".layers"), [new Trace()]);
extras.redraw = () => drawScene();
extras.onToggle = () => showLegend();
const tolerances = new ToleranceCard(byId("curves"), { goTo: (deg) => goTo(deg, true), redraw: () => {} });
const values = new CamValues();
const controls = new Controls((seconds) => goTo(state.deg + controls.player.pace * controls.player.speed * seconds),
  (sense, large) => goTo(state.deg + sense * (large ? 10 : 1), true));

// The design shown: one of the result, or what an edit has made of it.
let edited = null;
const current = () => edited ?? designs[state.index];

// Everything that follows the cam; angles beyond a turn go on in the next. `byHand` stops the clock.
function goTo(deg, byHand = false) {
  if (byHand) controls.play(false);
  const whole = Math.floor(deg / 360);
  state.deg = deg - 360 * whole;
  state.turns = whole === 0 ? state.turns : (state.turns + whole) % 1000;
  scene.move(state.deg, state.turns, missesPressure(current(), state.deg));
  extras.move(state.deg);
  curves.move(state.deg);
  tolerances.move(state.deg);
  values.move(state.deg);
  const slider = byId("drive");
  slider.value = state.deg;
  slider.setAttribute("aria-valuetext", say("motion.degrees", { value: fixed(state.deg, 0) }));
  const [angle, stroke] = [degrees(state.deg, 1), current().strokeAt(state.deg)];
  byId("drive-value").textContent = stroke ? say(`stroke_now.${stroke}`, { angle }) : angle;
}

function drawScene() {
  scene.build(current());
  extras.rebuilt(scene);
  goTo(state.deg);
}

function drawCurves() {
  const sheets = camSheets(current(), state.byTime);
  curves.build(sheets);
  values.build(sheets);
  for (const button of document.querySelectorAll("[data-rate]")) button.setAttribute("aria-pressed", String((button.dataset.rate === "time") === state.byTime));
}

const circleName = (kind) => say(kind.flat || kind.knife ? "legend.base" : "legend.base_pitch");

function showLegend() {
  const { kind } = current();
  const present = new Set(current().drawn.strokes.map(({ stroke }) => stroke));
  const strokes = [["rise", "rise", say("stroke.rise")], ["return", "fall", say("stroke.return")], ["dwell", "dwell", say("stroke.dwell")]].filter(([stroke]) => present.has(stroke)).map(([, colour, name]) => legendItem(colour, "line", name));
  const of = { pitch: kind.flat ? [] : [legendItem("curve", "line", say(kind.knife ? "legend.path_of_edge" : "legend.pitch"))], base: [legendItem("ground", "dashed", circleName(kind))],
    pressure: [legendItem("error", "line", say("legend.pressure"))], velocity: [legendItem("crank", "line", say("legend.velocity_cam")), legendItem("velocity", "line", say("legend.velocity_follower"))],
    comb: [legendItem("link-c", "line", say("legend.comb"))], envelope: [legendItem("link-b", "line", say("legend.envelope"))] };
  byId("legend").replaceChildren(...strokes, ...Object.keys(of).filter((layer) => scene.shown[layer]).flatMap((layer) => of[layer]), ...extras.legend());
  const orders = new Set(kind.jumps.map((jump) => jump.order));
  byId("marks").replaceChildren(legendItem("dwell", "dashed", say("legend.border")), ...[...orders].sort().map((order) => legendItem(JUMP_COLOURS[order].slice(2), "dashed", say(`legend.jump_${JUMPS[order]}`))));
}

function choose(index) {
  editor?.close(false);
  edited = scene.original = null;
  state.index = index;
  for (const [i, button] of [...byId("designs").children].entries()) button.setAttribute("aria-pressed", String(i === index));
  showDesign();
  showWarnings(result.designs?.[index]);
  const limit = result.problem?.tolerance?.yield;
  tolerances.show(result.designs?.[index]?.tolerance, { xOf: (deg) => deg, range: [0, 360], xLabel: say("sheet.cam_angle"), size: 1,
    mover: editor ? new CamMover(givenCam(result.problem, result.designs[index])) : null, limit: limit?.max_error_deg ?? limit?.max_error });
}

// Everything that is said and drawn of the design shown.
function showDesign() {
  const design = current();
  showCamDimensions(design);
  showMetrics(camMetrics(design.drawn.metrics).filter(({ name }) => !name.startsWith("tolerance_")));
  showChecks(design.drawn.constraints);
  showSegments(design, (deg) => goTo(deg, true));
  document.querySelector("[data-layer=base]").textContent = circleName(design.kind);
  byId("rates").hidden = !design.drawn.speed;
  if (!design.drawn.speed) state.byTime = false;
  showLegend();
  drawCurves();
  drawScene();
}

// What an edit has made of the design, and its problem; the design as it was found for null.
function showEdited(drawn, problem) {
  edited = drawn && new CamDesign(drawn.designs[0], drawn);
  scene.original = drawn && designs[state.index].first;
  showProblem(problem, kindName(), withNamedRadius(problem));
  showNotes((drawn ?? result).notes ?? [], drawn ? [] : result.warnings);
  showWarnings(drawn ? {} : result.designs?.[state.index]);
  showDesign();
}

const kindName = () => say(data.oscillating ? "kind.cam_an" : "kind.cam", { follower: say(`follower.${data.follower}`) });

function showChoice() {
  byId("choice").hidden = designs.length < 2;
  byId("designs").replaceChildren(...designs.map(({ drawn, kind }, i) => {
    const missed = drawn.constraints.some((check) => !check.satisfied);
    const button = element("button", { type: "button", title: sentenceOf(drawn.origin) }, `${say("cam.design", { n: i + 1, name: radiusText(kind, drawn.dimensions.base_radius, 4) })} `, element("span", { class: `mark ${missed ? "no" : "yes"}` }, missed ? "✗" : "✓"));
    button.addEventListener("click", () => choose(i));
    return button;
  }));
}

function listenToLayers() {
  for (const button of document.querySelectorAll("[data-layer]")) {
    const { layer } = button.dataset;
    button.hidden = layer === "pitch" && data.flat;
    button.setAttribute("aria-pressed", String(Boolean(scene.shown[layer])));
    button.addEventListener("click", () => {
      scene.show({ [layer]: !scene.shown[layer] });
      button.setAttribute("aria-pressed", String(scene.shown[layer]));
      showLegend();
    });
  }
}

// Whether the frame stands still or the cam.
function hold(held) {
  scene.held = held;
  for (const button of document.querySelectorAll("[data-held]")) button.setAttribute("aria-pressed", String(button.dataset.held === held));
  drawScene();
}

function listen() {
  byId("drive").addEventListener("input", (event) => goTo(Math.min(359.999, Number(event.target.value)), true));
  for (const button of document.querySelectorAll("[data-held]")) button.addEventListener("click", () => hold(button.dataset.held));
  byId("rates").addEventListener("click", (event) => {
    const rate = event.target.closest("button")?.dataset.rate;
    if (rate) { state.byTime = rate === "time"; drawCurves(); goTo(state.deg); }
  });
  byId("save-table").addEventListener("click", () => saveText(result.problem?.title, "csv", "text/csv", camCsv(current())));
  new ResizeObserver(drawScene).observe(byId("picture"));
  new Zoom(byId("stage"), byId("picture"), () => scene, drawScene);
  let stood = 0;
  new Saves(byId("stage"), byId("picture"), { title: () => result.problem?.title, go: (share) => { if (!share) stood = state.deg; goTo(359.999 * share, true); }, back: () => goTo(stood) });
}

const editor = Kernel.available && designs.length && result.problem?.motion && result.designs?.[0]?.mechanism?.motion
  ? new TableEditor({ call: "cam", problem: result.problem, hint: say("edit.hint_cam"), kept: ["choice", "work", "raster", "tolerances"], first: () => givenCam(result.problem, result.designs[state.index]),
    fields: camFields, rows: camRows, checks: ({ designs: [design] }) => checkRows(design.constraints), show: showEdited }) : null;
if (!editor) offerNoEdit(say(Kernel.available && designs.length ? "edit.too_large" : "edit.by_file"));
showHead(result, kindName(),
  [say("count.designs", { n: designs.length }), designs.length ? radiusText(designs[0].kind, designs[0].drawn.dimensions.base_radius, 6) : "", result.work ? duration(result.work.seconds) : ""],
  say("head.keys_cam"));
showProblem(result.problem, kindName(), withNamedRadius(result.problem));
showNotes(result.notes ?? [], result.warnings);
showWork(result.work);
showRaster(result.facts, { sizeUnit: LENGTH_UNIT });
followTheme(() => { curves.redraw(); tolerances.redraw(); });
if (result.problem && !result.problem.motion) byId("save").textContent = say("save.without_motion");
byId("save").addEventListener("click", () => saveResult(result));
if (designs.length === 0) {
  for (const id of ["stage", "dimensions", "facts", "curves", "segments", "constraints", "table"]) byId(id).hidden = true;
  if (!result.notes?.length) showNotes([say("cam.none")]);
} else {
  showChoice();
  listenToLayers();
  choose(0);
  hold("frame");
  listen();
  controls.start();
  makeSortable();
}
