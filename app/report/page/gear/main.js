// The page of a gear or of gears in mesh: where they stand, and everything that follows from it.

import { followTheme } from "../appearance.js";
import { checkRows, showChecks } from "../checks.js";
import { Controls, saveResult, saveText } from "../controls.js";
import { Curves } from "../curves.js";
import { byId, element } from "../dom.js";
import { embedded } from "../embedded.js";
import { Extras } from "../extras.js";
import { degrees, duration, fixed, number } from "../format.js";
import { showHead, showNotes, showWarnings, showWork } from "../head.js";
import { filmed, Saves } from "../saves.js";
import { legendItem } from "../shapes.js";
import { Kernel } from "../kernel.js";
import { TableEditor } from "../edit/table_editor.js";
import { offerNoEdit } from "../original.js";
import { showProblem } from "../problem.js";
import { makeSortable } from "../sortable.js";
import { Trace } from "../trace.js";
import { say, sentenceOf } from "../words.js";
import { Zoom } from "../zoom.js";
import { DISTANCES, gearFields, gearRows, givenGears } from "./edited.js";
import { flankCsv, showFlank, showGears } from "./facts.js";
import { GearMesh, PARTS } from "./model.js";
import { PairScene } from "./pair_scene.js";
import { Generation, RackScene } from "./rack_scene.js";
import { bevelSection } from "./section.js";
import { pairSheets, thicknessSheets } from "./sheets.js";
import { WormScene } from "./worm_scene.js";

const data = JSON.parse(embedded("data"));
const { result, kind, gearing } = data;
const isPair = kind === "pair";
const isRack = gearing === "rack";
// A rack slides past its pinion as the section of a worm past the wheel.
const isWorm = gearing === "worm" || isRack;
const designOf = (drawn) => (isPair && !isWorm ? new GearMesh(drawn) : { drawn });
const generationOf = ({ drawn }) => (isPair ? null : new Generation(drawn.gears[0]));
const designs = data.designs.map(designOf);
// The design shown: one of the result, or what an edit has made of it; of a single gear with the rack that cuts it.
let edited = null;
let generation = designs.length ? generationOf(designs[0]) : null;
const state = { index: 0, deg: 0 };
const onDrag = (deg) => goTo(deg, true);
const scene = isWorm ? new WormScene(byId("picture"), onDrag, isRack) : isPair ? new PairScene(byId("picture"), onDrag) : new RackScene(byId("picture"), onDrag);
const curves = new Curves(byId("plots"), (deg) => { if (deg !== null) goTo(deg, true); }, (deg) => extras.point(deg));
const extras = new Extras(document.querySelector(".layers"), [new Trace()]);
extras.redraw = () => drawScene();
extras.onToggle = () => showLegend();
const controls = new Controls((seconds) => goTo(state.deg + controls.player.pace * controls.player.speed * seconds),
  (sense, large) => goTo(state.deg + sense * step() * (large ? 10 : 1), true));

const current = () => edited?.design ?? designs[state.index];
// A step of the drive: a share of the way from tooth to tooth.
const pitchOf = () => (isWorm ? 360 / current().drawn.worm.starts : 360 / current().drawn.gears[0].teeth);
const step = () => pitchOf() / 20;

// After how many degrees all stands as it was.
const periodOf = () => (isRack ? 360 : isWorm ? 360 * current().drawn.teeth[1] : pitchOf() * current().pairs * (current().bodies.every((body) => body.isWhole) ? current().pinion.teeth * current().wheel.teeth : 1000));

// What a design is called: its teeth, module and shifts.
function nameOf({ teeth, module: size, shifts }) {
  return [`z ${teeth.join("/")}`, `m ${number(size)}`, ...(shifts.some((x) => x !== 0) ? [`x ${shifts.map((x) => number(x, 4)).join("/")}`] : [])].join(say("list.comma"));
}

// Everything that follows the drive. `byHand` stops the clock.
function goTo(deg, byHand = false) {
  if (byHand) controls.play(false);
  state.deg = within(deg);
  scene.move(state.deg);
  extras.move(state.deg);
  curves.move(state.deg);
  const shown = isPair ? state.deg - 360 * Math.floor(state.deg / 360) : state.deg;
  const slider = byId("drive");
  slider.value = shown;
  slider.setAttribute("aria-valuetext", say("motion.degrees", { value: fixed(shown, 1) }));
  const angle = degrees(shown, 2);
  const n = isWorm ? scene.now : isPair ? current().contacts(state.deg).length : 0;
  byId("drive-value").textContent = isPair ? say("gear.now", { n: n ?? 0, angle }) : angle;
}

// A rack goes over the tooth again; gears turn on and on, until all stands as it was.
function within(deg) {
  if (!generation) return deg - periodOf() * Math.floor(deg / periodOf());
  const { range } = generation;
  return deg - 2 * range.deg * Math.round(deg / (2 * range.deg));
}

function drawScene() {
  scene.build(generation ?? current());
  extras.rebuilt(scene);
  goTo(state.deg);
}

const LAYERS = { pair: ["action", "working", "base", "tip"], worm: ["action", "reference", "base", "tip"], gear: ["flank", "envelope", "base", "form", "reference", "tip"] };

function showLegend() {
  const of = { action: isWorm ? [legendItem("action", "line", say("gear.layer_action"))] : [legendItem("action", "line", say("gear.layer_action")), legendItem("shared", "line", say("gear.shared")), legendItem("alone", "line", say("gear.alone")),
    ...(current().touches && current().pairs === 1 && current().end - current().start < current().basePitch ? [legendItem("error", "dashed", say("gear.lost"))] : [])],
  working: [legendItem("working", "line", say("gear.layer_working"))], reference: [legendItem("working", "dashed", say("gear.layer_reference"))], base: [legendItem("base", "dashed", say("gear.layer_base"))],
  form: [legendItem("form", "dashed", say("gear.layer_form"))], tip: [legendItem("ground", "dashed", say("gear.layer_tip"))], envelope: [legendItem("rack", "line", say("gear.rack"))],
  flank: PARTS.map((part) => legendItem(`part-${part}`, "line", say(`gear.part_${part}`))) };
  byId("legend").replaceChildren(...Object.keys(of).filter((layer) => scene.shown[layer] && scene.parts?.[layer]).flatMap((layer) => of[layer]), ...extras.legend());
}

function showCurves() {
  const isDrawn = !isWorm && (generation?.body ?? current()).sound;
  byId("curves").hidden = !isDrawn;
  if (isDrawn) curves.build(isPair ? pairSheets(current()) : thicknessSheets(generation, generation));
}

function choose(index) {
  editor?.close(false);
  edited = null;
  state.index = index;
  for (const [i, button] of [...byId("designs").children].entries()) button.setAttribute("aria-pressed", String(i === index));
  showWarnings(result.designs?.[index]);
  showDesign();
}

// Everything that is said and drawn of the design shown. How many pairs were tried is of the original.
function showDesign() {
  const { drawn } = current();
  showGears([...drawn.metrics, ...(edited ? [] : data.facts ?? [])], gearing);
  showChecks(drawn.constraints ?? []);
  byId("section").hidden = !drawn.cones;
  if (drawn.cones) byId("section-picture").replaceChildren(bevelSection(drawn.cones));
  showCurves();
  drawScene();
  showLegend();
}

// What an edit has made of the gears, and their problem; the design as it was found for null.
function showEdited(answer, problem) {
  edited = answer && { design: designOf(answer.designs[0]), columns: answer.columns };
  generation = generationOf(current());
  setDriveRange();
  showProblem(problem, kindName);
  showNotes((answer ?? result).notes ?? [], answer ? [] : result.warnings);
  showWarnings(answer ? {} : result.designs?.[state.index]);
  showFlank(columns());
  showDesign();
}

const columns = () => (edited ?? data).columns;
const kindName = say(`kind.${isPair ? "gear_pair" : "gear"}`, { gearing: say(`gearing.${gearing}`) });

function showChoice() {
  byId("choice").hidden = designs.length < 2;
  byId("designs").replaceChildren(...designs.map(({ drawn }, i) => {
    const missed = (drawn.constraints ?? []).some((check) => !check.satisfied);
    const button = element("button", { type: "button", title: sentenceOf(drawn.origin ?? "") }, `${say("gear.design", { n: i + 1, name: nameOf(drawn) })} `, element("span", { class: `mark ${missed ? "no" : "yes"}` }, missed ? "✗" : "✓"));
    button.addEventListener("click", () => choose(i));
    return button;
  }));
}

function listenToLayers() {
  const layers = LAYERS[isWorm ? "worm" : kind];
  for (const button of document.querySelectorAll("[data-layer]")) {
    const { layer } = button.dataset;
    button.hidden = !layers.includes(layer);
    button.setAttribute("aria-pressed", String(Boolean(scene.shown[layer])));
    button.addEventListener("click", () => {
      scene.show({ [layer]: !scene.shown[layer] });
      button.setAttribute("aria-pressed", String(scene.shown[layer]));
      showLegend();
    });
  }
}

// Which of the choices of `name` above the picture holds.
function hold(name, choice) {
  scene[name === "look" ? "looks" : "held"] = choice;
  for (const button of document.querySelectorAll(`[data-${name}]`)) button.setAttribute("aria-pressed", String(button.dataset[name] === choice));
  Object.assign(scene.camera, { factor: 1, shift: [0, 0], widened: false });
  drawScene();
}

function listen() {
  byId("drive").addEventListener("input", (event) => goTo(Number(event.target.value), true));
  for (const button of document.querySelectorAll("[data-look]")) button.addEventListener("click", () => hold("look", button.dataset.look));
  for (const button of document.querySelectorAll("[data-held]")) button.addEventListener("click", () => hold("held", button.dataset.held));
  byId("save-table").addEventListener("click", () => saveText(result.problem?.title, "csv", "text/csv", flankCsv(columns())));
  new ResizeObserver(drawScene).observe(byId("picture"));
  new Zoom(byId("stage"), byId("picture"), () => scene, drawScene);
  let stood = 0;
  const span = () => (generation ? [-generation.range.deg, generation.range.deg, true] : [0, isWorm ? 360 : 4 * pitchOf(), true]);
  new Saves(byId("stage"), byId("picture"), { title: () => result.problem?.title, go: (share) => { if (!share) stood = state.deg; goTo(filmed(span(), share), true); }, back: () => goTo(stood) });
}

// What the drive is called, and how fast it goes: from tooth to tooth in two seconds.
function prepareDrive() {
  const name = say(isWorm && !isRack ? "gear.worm_angle" : isPair ? "gear.pinion_angle" : "gear.roll_angle");
  byId("drive-name").textContent = name;
  byId("drive").setAttribute("aria-label", name);
  setDriveRange();
  if (generation) state.deg = -generation.range.deg;
  controls.player.pace = isRack ? pitchOf() / 2 : isWorm ? 45 : generation ? generation.range.deg / 4 : pitchOf() / 2;
}

// A rack goes over its gear from one side to the other.
function setDriveRange() {
  if (!generation) return;
  const { deg } = generation.range;
  Object.assign(byId("drive"), { min: -deg, max: deg });
}

const editor = Kernel.available && designs.length && result.problem?.mechanism && result.designs?.[0]?.mechanism
  ? new TableEditor({ call: isPair ? "gear_pair" : "gear", problem: result.problem, hint: say(isPair && gearing in DISTANCES ? "edit.hint_gears" : "edit.hint_gear"), kept: ["choice", "work"], first: () => givenGears(result.problem, result.designs[state.index]),
    fields: gearFields, rows: gearRows, checks: ({ designs: [design] }) => checkRows(design.constraints ?? []), show: showEdited }) : null;
if (!editor) offerNoEdit(say("edit.by_file"));
const designCount = isPair && designs.length > 1 ? say("count.designs", { n: designs.length }) : "";
showHead(result, kindName, [designCount, designs.length ? nameOf(designs[0].drawn) : "", result.work ? duration(result.work.seconds) : ""], say("head.keys_gear"),
  isPair ? {} : { infeasible: "gear.faulty" });
showNotes(result.notes ?? [], result.warnings);
showWork(result.work);
byId("notes").classList.toggle("warned", result.status !== "solved" && result.status !== "done");
byId("stage-title").textContent = say(`stage.${isRack ? "rack" : isWorm ? "worm" : gearing === "bevel" ? "virtual_gears" : isPair ? "gear_pair" : "gear"}`);
byId("curves-title").textContent = say(isPair ? "curves.contact" : "curves.tooth");
byId("looks").hidden = !isPair;
byId("holds").hidden = isPair;
followTheme(() => curves.redraw());
byId("save").addEventListener("click", () => saveResult(result));
showFlank(columns());
byId("constraints").hidden = !isPair;
if (designs.length === 0) {
  for (const id of ["stage", "dimensions", "facts", "curves", "constraints", "table"]) byId(id).hidden = true;
  if (!result.notes?.length) showNotes([say("gear.none")]);
} else {
  prepareDrive();
  showChoice();
  listenToLayers();
  choose(0);
  hold(isPair ? "look" : "held", isPair ? "whole" : "gear");
  listen();
  controls.start();
  makeSortable();
}
