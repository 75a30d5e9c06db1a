// The page of a gear or of gears in mesh: where they stand, and everything that follows from it.

import { followTheme } from "../appearance.js";
import { showChecks } from "../checks.js";
import { Controls, saveResult, saveText } from "../controls.js";
import { Curves } from "../curves.js";
import { byId, element } from "../dom.js";
import { embedded } from "../embedded.js";
import { Extras } from "../extras.js";
import { degrees, duration, fixed, number } from "../format.js";
import { showHead, showNotes, showWarnings, showWork } from "../head.js";
import { filmed, Saves } from "../saves.js";
import { legendItem } from "../shapes.js";
import { offerNoEdit } from "../original.js";
import { makeSortable } from "../sortable.js";
import { Trace } from "../trace.js";
import { say, sentenceOf } from "../words.js";
import { Zoom } from "../zoom.js";
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
const designs = data.designs.map((drawn) => (isPair && !isWorm ? new GearMesh(drawn) : { drawn }));
const generation = isPair || !designs.length ? null : new Generation(designs[0].drawn.gears[0]);
const state = { index: 0, deg: 0 };
const onDrag = (deg) => goTo(deg, true);
const scene = isWorm ? new WormScene(byId("picture"), onDrag, isRack) : isPair ? new PairScene(byId("picture"), onDrag) : new RackScene(byId("picture"), onDrag);
const curves = new Curves(byId("plots"), (deg) => { if (deg !== null) goTo(deg, true); }, (deg) => extras.point(deg));
const extras = new Extras(document.querySelector(".layers"), [new Trace()]);
extras.redraw = () => drawScene();
extras.onToggle = () => showLegend();
const controls = new Controls((seconds) => goTo(state.deg + controls.player.pace * controls.player.speed * seconds),
  (sense, large) => goTo(state.deg + sense * step() * (large ? 10 : 1), true));

const current = () => designs[state.index];
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
  state.index = index;
  for (const [i, button] of [...byId("designs").children].entries()) button.setAttribute("aria-pressed", String(i === index));
  const { drawn } = current();
  showGears([...drawn.metrics, ...(data.facts ?? [])], gearing);
  showChecks(drawn.constraints ?? []);
  showWarnings(result.designs?.[index]);
  byId("section").hidden = !drawn.cones;
  if (drawn.cones) byId("section-picture").replaceChildren(bevelSection(drawn.cones));
  showCurves();
  drawScene();
  showLegend();
}

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
  byId("save-table").addEventListener("click", () => saveText(result.problem?.title, "csv", "text/csv", flankCsv(data.columns)));
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
  if (generation) { const { deg } = generation.range; Object.assign(byId("drive"), { min: -deg, max: deg }); state.deg = -deg; }
  controls.player.pace = isRack ? pitchOf() / 2 : isWorm ? 45 : generation ? generation.range.deg / 4 : pitchOf() / 2;
}

const designCount = isPair && designs.length > 1 ? say("count.designs", { n: designs.length }) : "";
offerNoEdit(say("edit.by_file"));
showHead(result, say(`kind.${isPair ? "gear_pair" : "gear"}`, { gearing: say(`gearing.${gearing}`) }), [designCount, designs.length ? nameOf(designs[0].drawn) : "", result.work ? duration(result.work.seconds) : ""], say("head.keys_gear"),
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
showFlank(data.columns);
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
