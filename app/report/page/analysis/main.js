// The page of an analysis: where the drive stands, and everything that follows from it.

import { followTheme } from "../appearance.js";
import { Controls, saveResult, saveText } from "../controls.js";
import { Curves } from "../curves.js";
import { byId, element, set } from "../dom.js";
import { embedded } from "../embedded.js";
import { Extras } from "../extras.js";
import { degrees, duration, fixed, number, sentence } from "../format.js";
import { Ghost, GHOSTS } from "../ghosts.js";
import { showHead, showNotes, showWork } from "../head.js";
import { jointsOf } from "../joints.js";
import { Kernel } from "../kernel.js";
import { Loads } from "../loads.js";
import { Mechanism } from "../mechanism.js";
import { ARROWS, MechanismScene } from "../mechanism_scene.js";
import { RADIANS } from "../sampling.js";
import { legendItem } from "../shapes.js";
import { filmed, Saves } from "../saves.js";
import { makeSortable } from "../sortable.js";
import { Trace } from "../trace.js";
import { TracedPoints } from "../traced.js";
import { Vectors } from "../vectors.js";
import { say, term } from "../words.js";
import { Zoom } from "../zoom.js";
import { showFacts, showLandmarks, Values } from "./facts.js";
import { Loci, lociSheets } from "./loci.js";
import { analysisSheets, landmarkColour, partColours } from "./sheets.js";
import { partName, Table } from "./table.js";
import { BillCard } from "../workshop/bill.js";
import { LayersCard } from "../workshop/layers.js";
import { ToleranceCard } from "../tolerance/card.js";
import { ToleranceLayer } from "../tolerance/layer.js";
import { analysisTolerances } from "../tolerance/of_analysis.js";
import { AnalysisEditor } from "../edit/analysis_editor.js";
import { markOriginal, offerNoEdit } from "../original.js";
import { showProblem } from "../problem.js";

const data = JSON.parse(embedded("data"));
const { result } = data;
const angular = data.drive.kind !== "slider";
let { driving, mechanism, table, landmarks } = take(data);
const state = { drive: mechanism.start, parts: new Set() };
const scene = new MechanismScene(byId("picture"), mechanism, (drive) => goTo(drive, true), table, angular ? 1 / RADIANS : 1);
scene.jointsAt = jointsOf(mechanism, result.problem?.mechanism);
const traced = new TracedPoints(byId("picture"), byId("ghosts"), () => extras.toggle(traced, traced.points.length > 0));
const bill = new BillCard(byId("curves"));
const layers = new LayersCard(byId("curves"), { goTo: (drive) => goTo(drive, true), driveText: (drive) => driveText(drive) });
const tolerances = new ToleranceCard(byId("curves"), { goTo: (drive) => goTo(drive, true), redraw: (on) => extras.toggle(toleranceLayer, on || extras.shown.has(toleranceLayer)) });
const toleranceLayer = new ToleranceLayer(tolerances);
const extras = new Extras(byId("extras"), [toleranceLayer, new Trace(), traced, new Loads(), ...missingVectors(), ...Object.keys(GHOSTS).map((ghost) => new Ghost(ghost, byId("ghosts")))]);
extras.redraw = () => drawScene();
extras.onToggle = () => showLegend();
let colours = partColours(table, scene);
const curves = new Curves(byId("plots"), (drive) => goTo(drive, true), (drive) => extras.point(drive));
const loci = new Loci(byId("loci-plots"), table);
const values = new Values(table);
const controls = new Controls((seconds) => goTo(controls.player.next(state.drive, [mechanism.from, mechanism.to, mechanism.round], seconds)),
  (sense, large) => goTo(state.drive + sense * (large ? 10 : 1) * (angular ? 1 : (mechanism.to - mechanism.from) / 360), true));
controls.player.pace = angular ? 60 : (mechanism.to - mechanism.from) / 4;

// What is drawn of an analysis.
function take({ drive, mechanism: motion, table: rows, vectors, normals, loads = [], landmarks: places }) {
  const moved = new Mechanism(motion, drive);
  return { driving: drive, mechanism: moved, table: new Table(rows, vectors, normals, loads),
    landmarks: places.filter((l) => l.drive !== null).map((l) => ({ ...l, drive: moved.within(l.drive) })) };
}

// Arrows that follow from the motion alone, where the table holds none.
function missingVectors() {
  const known = new Set(scene.arrows.map((arrow) => arrow.quantity));
  return ["velocity", "acceleration"].filter((quantity) => !known.has(quantity)).map((quantity) => new Vectors(quantity, quantity === "velocity" ? "v" : "c"));
}

// More parts than are shown all at once.
const MANY_PARTS = 40;
const driveText = (drive, decimals = 2) => (angular ? degrees(drive, decimals) : number(drive, 5));

// Everything that follows the drive. `byHand` stops the clock.
function goTo(drive, byHand = false) {
  if (drive === null) return;
  if (byHand) controls.play(false);
  state.drive = mechanism.within(drive);
  scene.move(state.drive);
  extras.move(state.drive);
  traced.see(scene, state.drive);
  editor?.place(scene.view);
  curves.move(state.drive);
  tolerances.move(state.drive);
  loci.move(state.drive);
  values.move(state.drive);
  const slider = byId("drive");
  slider.value = state.drive;
  slider.setAttribute("aria-valuetext", angular ? say("motion.degrees", { value: fixed(state.drive, 0) }) : number(state.drive, 4));
  byId("drive-value").textContent = driveText(state.drive, 1);
  byId("open").hidden = mechanism.places(state.drive).every(Boolean);
}

function choose(parts) {
  state.parts = parts;
  for (const button of document.querySelectorAll("[data-part]")) button.setAttribute("aria-pressed", String(parts.has(button.dataset.part)));
  byId("all-parts").setAttribute("aria-pressed", String(parts.size === table.parts.length));
  curves.build(analysisSheets(table, mechanism, parts, landmarks, driveAxis(), colours));
  const sheets = lociSheets(table, parts, colours);
  byId("loci").hidden = sheets.length === 0;
  loci.build(sheets);
  values.build(parts);
  goTo(state.drive);
}

// The parts shown at first: all where they are few, else the output and the points beside it.
function firstParts() {
  if (table.parts.length <= 6) return new Set(table.parts);
  const output = mechanism.bodies[mechanism.output]?.name;
  const points = mechanism.pointsOf(mechanism.output).map((p) => p.name);
  const drive = table.columns.filter((c) => c.quantity === "torque").map((c) => c.of);
  const wanted = new Set([output, ...points, ...drive]);
  const parts = table.parts.filter((part) => wanted.has(part));
  return new Set(parts.length ? parts : table.parts.slice(0, 4));
}

function showParts() {
  const all = element("button", { type: "button", id: "all-parts", title: say("curves.all_parts_title") }, say("curves.all_parts"));
  all.addEventListener("click", () => choose(state.parts.size < table.parts.length ? new Set(table.parts) : firstParts()));
  all.hidden = table.parts.length > MANY_PARTS;
  byId("parts").replaceChildren(all, ...table.parts.map((part) => {
    const button = element("button", { type: "button", "data-part": part }, partName(part));
    button.addEventListener("click", () => {
      const parts = new Set(state.parts);
      if (!parts.delete(part)) parts.add(part);
      choose(new Set(table.parts.filter((p) => parts.has(p))));
    });
    return button;
  }));
}

function showLegend() {
  const bodies = mechanism.bodies.length > 9 ? [] : mechanism.bodies.slice(1).map((body, i) => legendItem(scene.tint(i + 1).slice(2), "line", sentence(term(body.name))));
  const paths = mechanism.points.some((p) => p.moves && !p.isPin) ? [legendItem("curve", "line", say("legend.path"))] : [];
  const centrodes = table.centrodes.map(({ of }) => legendItem(scene.tint(mechanism.bodies.findIndex((b) => b.name === of)).slice(2), "dashed", say("picture.fixed_centrode", { of: term(of) })));
  const arrows = Object.keys(ARROWS).filter((kind) => scene.shown[kind]).map((kind) => legendItem(kind === "reactions" ? "error" : kind, "line", ARROWS[kind]));
  byId("legend").replaceChildren(...bodies, ...paths, ...centrodes, ...arrows, ...extras.legend());
  const kinds = [...new Set(landmarks.map((l) => l.kind))];
  byId("marks").replaceChildren(...kinds.map((kind) => legendItem(landmarkColour(kind).slice(2), "dashed", sentence(term(kind)))));
}

// Buttons that switch on what the picture can show with the mechanism.
function listenToLayers() {
  const kinds = new Set(scene.arrows.map((arrow) => arrow.quantity));
  for (const button of document.querySelectorAll("[data-layer]")) {
    const { layer } = button.dataset;
    button.hidden = layer in ARROWS ? !kinds.has(layer) : !mechanism.points.some((p) => layer === "names" || p.moves);
    button.setAttribute("aria-pressed", String(Boolean(scene.shown[layer])));
    button.addEventListener("click", () => {
      const shown = !scene.shown[layer];
      scene.show({ [layer]: shown });
      button.setAttribute("aria-pressed", String(shown));
      scene.move(state.drive);
      showLegend();
    });
  }
}

function drawScene() {
  scene.build();
  extras.rebuilt(scene);
  goTo(state.drive);
}

// A motion alone in the place of the one analysed, while it changes.
function showMotion(moved, drive) {
  controls.play(false);
  mechanism = moved;
  state.drive = moved.within(drive);
  scene.adopt(moved);
  scene.jointsAt = jointsOf(moved, result.problem.mechanism);
  drawScene();
}

// An edited analysis with everything that follows from it; that of the file for null.
function showAnalysis(edited, problem, drive) {
  controls.play(false);
  ({ driving, mechanism, table, landmarks } = take(edited ?? data));
  state.drive = mechanism.within(drive);
  scene.adopt(mechanism, table);
  scene.jointsAt = jointsOf(mechanism, problem.mechanism);
  colours = partColours(table, scene);
  for (const follower of [loci, values]) follower.table = table;
  set(byId("drive"), { min: mechanism.from, max: mechanism.to });
  showProblem(problem, say("kind.analysis"));
  showAll(edited ?? data, (edited ?? result).notes);
  markOriginal(["work", "tolerances", "layers", "bill"], Boolean(edited));
  drawScene();
  choose(new Set(table.parts.filter((part) => state.parts.has(part))));
}

// What is said of the analysis shown.
function showAll({ facts }, notes = []) {
  showNotes(notes, result.warnings);
  showFacts(facts, driving, mechanism);
  showLandmarks(landmarks, mechanism, driveText, (drive) => goTo(drive, true));
  showLegend();
}

const driveAxis = () => say(angular ? "drive.angle_axis" : "drive.way_axis", { name: sentence(term(driving.name)) });

function showTolerances() {
  tolerances.show(result.designs?.[0]?.tolerance, analysisTolerances(result.problem ?? {}, driving, mechanism, driveAxis(), Boolean(editor)));
}

function listen() {
  set(byId("drive"), { min: mechanism.from, max: mechanism.to });
  byId("drive").addEventListener("input", (event) => goTo(Number(event.target.value), true));
  new ResizeObserver(drawScene).observe(byId("picture"));
  new Zoom(byId("stage"), byId("picture"), () => scene, drawScene);
  let stood = 0;
  new Saves(byId("stage"), byId("picture"), { title: () => result.problem?.title, go: (share) => { if (!share) stood = state.drive; goTo(filmed([mechanism.from, mechanism.to, mechanism.round], share), true); }, back: () => goTo(stood) });
}

const editor = Kernel.available && result.problem?.mechanism && mechanism.closes
  ? new AnalysisEditor({ problem: result.problem, driving: () => driving, drive: () => state.drive, mechanism: () => mechanism, show: showAnalysis, move: showMotion }) : null;
if (!editor && mechanism.closes) offerNoEdit(say("edit.too_large"));
byId("drive-name").textContent = sentence(term(driving.name));
showHead(result, say("kind.analysis"), [say("count.moving_bodies", { n: mechanism.bodies.length - 1 }),
  say("count.positions", { n: table.rows }), result.work ? duration(result.work.seconds) : ""], say("head.keys_drive"));
showWork(result.work);
showAll(data, result.notes);
showTolerances();
layers.show(result.designs?.[0]?.layers);
bill.show(data.bill);
followTheme(() => { curves.redraw(); tolerances.redraw(); });
if (!result.analysis?.columns) byId("save").textContent = say("save.without_table");
byId("save").addEventListener("click", () => saveResult(result));
byId("save-table").addEventListener("click", () => saveText(result.problem?.title, "csv", "text/csv", table.csv));
if (table.thinned) byId("save-table").textContent = say("values.save_drawn", { n: table.drawn });
showParts();
scene.build();
extras.rebuilt(scene);
choose(firstParts());
byId("parts").scrollTop = (document.querySelector('[data-part][aria-pressed="true"]')?.offsetTop ?? 0) - byId("parts").offsetTop;
listenToLayers();
listen();
controls.start();
makeSortable();
