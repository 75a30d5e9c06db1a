// The page: what is chosen, and everything that follows from it.

import { followTheme } from "../appearance.js";
import { showChecks } from "../checks.js";
import { Controls, saveResult } from "../controls.js";
import { Curves, keySign } from "../curves.js";
import { byId, element, set } from "../dom.js";
import { embedded } from "../embedded.js";
import { Extras } from "../extras.js";
import { degrees, fixed, number, sentence } from "../format.js";
import { Ghost, GHOSTS } from "../ghosts.js";
import { certificateNote, showNotes, showWarnings, showWork } from "../head.js";
import { Kernel } from "../kernel.js";
import { legendItem } from "../shapes.js";
import { Pinned } from "../pinned.js";
import { filmed, Saves } from "../saves.js";
import { takeGiven } from "../rounding.js";
import { makeSortable } from "../sortable.js";
import { Trace } from "../trace.js";
import { TracedPoints } from "../traced.js";
import { Vectors } from "../vectors.js";
import { language, say, sentenceOf } from "../words.js";
import { Zoom } from "../zoom.js";
import { locusColour } from "./backdrop.js";
import { showDesignHead, showDimensions, showFindings, showQualities } from "./facts.js";
import { Families } from "./families.js";
import { bestFraming } from "./framing.js";
import { Front, frontObjectives } from "./front.js";
import { showRaster } from "./raster.js";
import { Lens } from "./lens.js";
import { MechanismDesign } from "./mechanism_design.js";
import { Design, fittingMagnification, MAGNIFICATIONS, turnInto } from "./model.js";
import { DesignTable, isExact, isFourBar } from "./table.js";
import { DesignEditors } from "../edit/design_editors.js";
import { BillCard } from "../workshop/bill.js";
import { LayersCard } from "../workshop/layers.js";
import { ToleranceCard } from "../tolerance/card.js";
import { ToleranceLayer } from "../tolerance/layer.js";
import { designTolerances } from "../tolerance/of_design.js";

const data = JSON.parse(embedded("data"));
const { result } = data;
const { kind } = data.target;
takeGiven(result.problem?.target);
const makeDesign = (entry, i) => (data.designs[i].motion ? new Design(entry, data.designs[i], data.target) : new MechanismDesign(entry, data.designs[i], data.target));
const designs = result.designs.map(makeDesign);
const isFunction = kind === "function" && designs.some((design) => design.linkage);
const loci = data.loci ?? [];
const state = { index: 0, crank: 0, framing: "whole", magnify: 0, shownLoci: new Set(loci.keys()) };
let scene = null;
const curves = new Curves(byId("plots"), (crank) => { if (crank !== null) turnTo(crank, true); }, (crank) => extras.point(crank));
const controls = new Controls((seconds) => turnTo(controls.player.next(playedCrank(), current().played, seconds)),
  (sense, large) => turnTo(state.crank + sense * (large ? 10 : 1) * stepOf(current()), true));

function current() { return editor?.shown ?? designs[state.index]; }

// What an arrow key moves the drive by: a degree, or a part of a slider's way.
const stepOf = (design) => (design.angular ? 1 : (design.to - design.from) / 360);

// The crank angle counted as the range that plays counts it.
function playedCrank() {
  const [from, to, round] = current().played;
  return round || !current().angular ? state.crank : turnInto(state.crank, [from, to]);
}

// Everything that follows the drive. `byHand` stops the clock.
function turnTo(crank, byHand = false) {
  if (byHand) controls.play(false);
  const design = current();
  if (!design.assembles) return;
  state.crank = design.within(crank);
  design.crank = state.crank;
  scene.move(design.moved(state.crank));
  extras.move(state.crank);
  traced.see(scene, state.crank);
  editor?.place(scene.view, design.moved(state.crank));
  curves.move(state.crank);
  tolerances.move(state.crank);
  const slider = byId("crank");
  slider.value = state.crank;
  slider.setAttribute("aria-valuetext", design.angular ? say("motion.degrees", { value: fixed(state.crank, 0) }) : number(state.crank, 4));
  byId("crank-value").textContent = design.angular ? degrees(state.crank, 1) : number(state.crank, 4);
  byId("readout").textContent = design.readout(state.crank);
}

function drawScene() {
  scene.build(current(), { framing: state.framing, magnify: MAGNIFICATIONS[state.magnify], loci, shownLoci: state.shownLoci });
  extras.rebuilt(scene);
  turnTo(state.crank);
}

function setFraming(framing) {
  state.framing = framing;
  for (const button of document.querySelectorAll("[data-framing]")) {
    button.setAttribute("aria-pressed", String(button.dataset.framing === framing));
    if (isFunction && button.dataset.framing === "moving") button.textContent = say("stage.range_used");
    button.hidden = button.dataset.framing === "curve" && !current().boxes.curve;
  }
}

function setMagnification(step) {
  state.magnify = step;
  const text = `×${MAGNIFICATIONS[step].toLocaleString(language)}`;
  byId("magnify").value = step;
  byId("magnify").setAttribute("aria-valuetext", text);
  byId("magnify-value").textContent = text;
  showLegend(text);
}

// An exact design has no errors to enlarge.
const showMagnify = (design) => { byId("magnify-label").hidden = isExact(design.entry) || (!isFunction && design.targets.length === 0); };

function showLegend(magnification) {
  const design = current();
  const exact = isExact(design.entry);
  const wanted = exact ? say("legend.wanted_exact") : say("legend.wanted_output", { scale: magnification });
  const own = isFunction && design.trace ? [legendItem("target", "dashed", wanted)] : [];
  if (design.boxes.curve) own.push(legendItem("curve", "line", say(design.walk ? "walk.foot_path" : "legend.coupler_curve")));
  if (design.poses.length) own.push(legendItem("target", "line", say("legend.pose_wanted")), legendItem("coupler", "line", say("legend.body_reached")));
  else if (design.outline.length) own.push(legendItem("target", "line", say("legend.target")));
  else if (design.targets.length) own.push(legendItem("target", "dot", say("legend.target")));
  if (design.targets.length && !exact) own.push(legendItem("error", "line", say("legend.error", { scale: magnification })));
  if (design.walk) own.push(legendItem("error", "line", say("walk.stance")), legendItem("target", "dashed", say("walk.ground")));
  if (design.stretch.length) own.push(legendItem("error", "line", say("legend.straight")));
  byId("legend").replaceChildren(...scene.legend(), ...own, ...extras.legend());
}

// A button for each curve of the synthesis, which shows and hides it.
function showLoci() {
  byId("loci").hidden = loci.length === 0;
  byId("loci").replaceChildren(...loci.map(({ name }, i) => {
    const button = element("button", { type: "button", "aria-pressed": "true" }, keySign({ colour: locusColour(i) }), sentence(sentenceOf(name)));
    button.addEventListener("click", () => {
      if (!state.shownLoci.delete(i)) state.shownLoci.add(i);
      button.setAttribute("aria-pressed", String(state.shownLoci.has(i)));
      drawScene();
    });
    return button;
  }));
}

// What the drive of a design is called and how far it goes.
function setDrive(design) {
  set(byId("crank"), { min: design.from, max: design.to, "aria-label": design.angular ? say("drive.angle", { name: design.driveName }) : design.driveName });
  byId("drive-name").textContent = design.driveName;
  controls.player.pace = design.angular ? 60 : (design.to - design.from) / 4;
}

function choose(index) {
  state.index = index;
  editor?.choose(designs[index], data.designs[index]);
  const design = current();
  table.choose(index);
  families.choose(index);
  front.choose(index);
  follow(design);
  scene?.remove();
  scene = design.sceneIn(byId("picture"), (crank) => turnTo(crank, true));
  setDrive(design);
  tolerances.show(design.entry.tolerance, designTolerances(design, result.problem, kind));
  layers.show(design.entry.layers);
  bill.show(data.designs[index].bill);
  if (extras.shown.has(toleranceLayer)) extras.toggle(toleranceLayer, false);
  setFraming(design.assembles ? bestFraming(design.boxes) : "whole");
  showMagnify(design);
  setMagnification(fittingMagnification(design, design.boxes[state.framing]));
  byId("stage-title").textContent = say(isFourBar(design.entry) ? "stage.linkage_of" : "stage.mechanism_of", { n: index + 1 });
  curves.build(design.assembles ? design.sheets(data.transmission_limits_deg) : []);
  byId("curves").hidden = !design.assembles;
  state.crank = design.crank;
  drawScene();
}

// The design shown, to be kept in the picture.
function present() {
  const design = current();
  return { of: design, name: say("pin.design", { n: state.index + 1 }), at: (drive) => design.outlineAt(drive) };
}

// What is said of a design.
function follow(design) {
  const other = pinned?.design?.of ?? null;
  showDimensions(design, other);
  showQualities(design, kind, other);
  showChecks(design.entry.constraints ?? []);
  showWarnings(design.entry);
}

// Everything that is drawn of a design, once it has been changed.
function redrawDesign() {
  const design = current();
  setDrive(design);
  showMagnify(design);
  curves.build(design.sheets(data.transmission_limits_deg));
  redrawAt(state.crank);
}

// A change is under way: errors are drawn so that they fit.
function redrawAt(crank) {
  controls.play(false);
  state.crank = crank;
  setMagnification(fittingMagnification(current(), current().boxes[state.framing]));
  drawScene();
}

function listen() {
  byId("crank").addEventListener("input", (event) => turnTo(Number(event.target.value), true));
  byId("magnify").addEventListener("input", (event) => { setMagnification(Number(event.target.value)); drawScene(); });
  byId("framing").addEventListener("click", (event) => {
    const framing = event.target.closest("button")?.dataset.framing;
    if (framing) { Object.assign(scene.camera, { factor: 1, shift: [0, 0] }); setFraming(framing); drawScene(); }
  });
  new ResizeObserver(drawScene).observe(byId("picture"));
  new Zoom(byId("stage"), byId("picture"), () => scene, drawScene);
  let stood = 0;
  new Saves(byId("stage"), byId("picture"), { title: () => result.problem?.title, go: (share) => { if (!share) stood = state.crank; turnTo(filmed(current().played, share), true); }, back: () => turnTo(stood) });
}

const notes = byId("ghosts");
const pinned = designs.length > 1 || Kernel.available ? new Pinned(document.querySelector("#stage .card-head"), present, (on) => {
  extras.toggle(pinned, on);
  follow(current());
}) : null;
const traced = new TracedPoints(byId("picture"), notes, () => extras.toggle(traced, traced.points.length > 0));
const bill = new BillCard(byId("curves"));
const layers = new LayersCard(byId("curves"), { goTo: (drive) => turnTo(drive, true), driveText: (drive) => (designs[state.index].angular ? degrees(drive) : number(drive, 5)) });
const tolerances = new ToleranceCard(byId("curves"), { goTo: (drive) => turnTo(drive, true), redraw: (on) => extras.toggle(toleranceLayer, on || extras.shown.has(toleranceLayer)) });
const toleranceLayer = new ToleranceLayer(tolerances);
const extras = new Extras(byId("extras"), [toleranceLayer, ...(pinned ? [pinned] : []), traced, new Trace(), new Vectors("velocity", "v"), new Vectors("acceleration", "c"), new Lens(byId("picture")),
  ...Object.keys(GHOSTS).map((ghost) => new Ghost(ghost, notes))]);
extras.redraw = () => drawScene();
extras.onToggle = () => setMagnification(state.magnify);
const editor = Kernel.available && designs.length ? new DesignEditors({ problem: result.problem, target: data.target, crank: () => state.crank, settle: redrawDesign, follow,
  redraw: (crank) => redrawAt(crank ?? state.crank) }) : null;
let table = null;
let families = null;
let front = null;
showDesignHead(result, kind);
showNotes([...certificateNote(result.certificate), ...(result.notes ?? [])], result.warnings);
byId("families").after(byId("problem"));
showFindings(result.facts);
showRaster(result.facts, { angular: designs[0]?.entry.error?.max_deg !== undefined });
showWork(result.work);
followTheme(() => { curves.redraw(); tolerances.redraw(); families?.redraw(); if (front?.shown) front.draw(); });
if (loci.length && !result.loci) byId("save").textContent = say("save.without_curves");
byId("save").addEventListener("click", () => saveResult(result));
if (designs.length === 0) {
  for (const id of ["stage", "choice", "curves", "dimensions", "qualities", "constraints"]) byId(id).hidden = true;
  if (!result.notes?.length) showNotes([say("designs.none")]);
} else {
  byId("choice-count").textContent = designs.length > 1 ? say("designs.choose") : "";
  table = new DesignTable(designs, kind, choose);
  front = new Front(frontObjectives(result.problem?.solve), result.designs, data.families ?? [], choose);
  families = new Families((data.families ?? []).filter(({ name }) => !front.shown || !/ front$/.test(name)), result.designs, choose);
  showLoci();
  choose(0);
  listen();
  controls.start();
  makeSortable();
}
