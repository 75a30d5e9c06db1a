// The page of a sketch: a curve that a hand draws, and the linkages that trace it.

import { followTheme } from "../appearance.js";
import { Controls } from "../controls.js";
import { byId, element } from "../dom.js";
import { History } from "../edit/history.js";
import { degrees, duration, fixed, number, sentence } from "../format.js";
import { Kernel } from "../kernel.js";
import { shortcut } from "../keys.js";
import { RADIANS } from "../sampling.js";
import { filmed, Saves } from "../saves.js";
import { say, sentenceOf, term } from "../words.js";
import { Zoom } from "../zoom.js";
import { addressOf, readAddress } from "./address.js";
import { Candidate, differing } from "./candidate.js";
import { Cards } from "./cards.js";
import { CLASSES_ASKED, drawingSize, FEWEST_POINTS, problemOf } from "./question.js";
import { SketchScene } from "./scene.js";
import { Search } from "./search.js";
import { rounded, strokeTargets } from "./stroke.js";
import { Surface } from "./surface.js";
import { Takings } from "./takings.js";

const EMPTY = { points: [], closed: false, stroke: false, class: "any", least: 30, reach: 3 };
const SHOWN = 3;
const QUICK = 60, LONG = 500;    // starts of the two searches
const FOUND = 8;    // designs of each, of which those are shown that differ

const scene = new SketchScene(byId("picture"), say("sketch.picture"));
const controls = new Controls((seconds) => goTo(scene.phase / RADIANS + controls.player.pace * controls.player.speed * seconds),
  (sense, large) => goTo(scene.phase / RADIANS + sense * (large ? 10 : 1), true));
controls.player.pace = 120;
const cards = new Cards((i) => choose(i));
const takings = new Takings(() => ({ state: shown, candidate: scene.candidates[scene.chosen] }));
const search = Kernel.available ? new Search(take, (text) => announce(say("sketch.failed", { text }))) : null;
const surface = new Surface(byId("picture"), () => scene.view, { begin: () => search?.cancel(), stroke, click, drag, drop, remove });
const read = readAddress(CLASSES_ASKED);
let steps = new History({ ...EMPTY, ...read?.state });
// The state shown, which a drag has changed and the history does not hold yet; the design that stays chosen.
let shown = steps.present, held = null, begun = 0;

const announce = (text) => { byId("state").textContent = text; };

function goTo(degreesOfMotion, byHand = false) {
  if (byHand) controls.play(false);
  const place = ((degreesOfMotion % 360) + 360) % 360;
  scene.move(place * RADIANS);
  byId("drive").value = place;
  byId("drive").setAttribute("aria-valuetext", say("motion.degrees", { value: fixed(place, 0) }));
  byId("drive-value").textContent = degrees(place, 0);
}

// Designs

function offer(candidates, chosen) {
  Object.assign(scene, { candidates, chosen });
  draw();
  cards.show(candidates, chosen, shown.points);
  followTakings();
}

const followTakings = () => takings.follow(shown.points.length >= FEWEST_POINTS, scene.candidates.length > 0);

function choose(i) {
  if (!scene.candidates[i]) return;
  held = scene.candidates[i];
  offer(scene.candidates, i);
  byId(`design-${i}`).focus();
  keepAddress();
}

// An answer of the search; that of the longer one replaces the designs where it is better.
function take(answer, { live, last }) {
  const found = (answer.designs ?? []).map((entry) => new Candidate(entry));
  const before = last ? scene.candidates : [];
  const candidates = differing([...found, ...before], SHOWN, drawingSize(shown.points), held);
  offer(candidates, Math.max(0, candidates.indexOf(held)));
  if (!live && scene.candidates.length) widen();
  announce(answer.faults ? answer.faults.map((fault) => sentence(sentenceOf(fault))).join(" ") : stateText(answer, last, live));
  if (!live) keepAddress();
}

function stateText({ status, designs = [] }, last, live) {
  const time = duration((performance.now() - begun) / 1000);
  if (designs.length === 0) return say("sketch.no_design");
  if (status === "infeasible") return say("sketch.infeasible");
  return say(last || live ? "sketch.found" : "sketch.found_going_on", { n: scene.candidates.length, time });
}

// The linkage chosen is seen whole.
function widen() { if (scene.include(scene.candidates[scene.chosen].places)) draw(); }

function solve(live = false) {
  begun = performance.now();
  if (!search || shown.points.length < FEWEST_POINTS) return;
  const question = (starts, flags) => ({ problem: problemOf(shown, { starts, designs: FOUND }), ...flags });
  if (live) { search.askNewest(question(QUICK, { live, last: false })); return; }
  announce(say("sketch.searching"));
  search.ask([question(QUICK, { live, last: false }), question(LONG, { live, last: true })]);
}

// States

// Takes `change` of the state as a step that can be undone.
function change(parts) {
  steps.push({ ...steps.present, ...parts });
  settle();
}

// Shows the present state, and searches for it.
function settle() {
  shown = steps.present;
  held = null;
  search?.cancel();
  if (shown.points.length < FEWEST_POINTS) {
    offer([], 0);
    announce(shown.points.length ? say("sketch.more_points", { least: FEWEST_POINTS }) : "");
  }
  showState();
  keepAddress();
  solve();
}

function showState() {
  const { points, closed, class: asked, least, reach } = shown;
  byId("undo").disabled = !steps.canUndo;
  byId("redo").disabled = !steps.canRedo;
  byId("clear").disabled = points.length === 0;
  byId("closed").setAttribute("aria-pressed", String(closed));
  byId("hint").hidden = points.length > 0;
  byId("class").value = asked;
  byId("least").value = least;
  byId("reach").value = reach;
  showLimits(least, reach);
  scene.target(shown);
  surface.show(points);
  followTakings();
}

function showLimits(least, reach) {
  byId("least-value").textContent = degrees(least, 0);
  byId("reach-value").textContent = say("sketch.times", { value: number(reach) });
}

function keepAddress() {
  const address = shown.points.length ? addressOf(shown, scene.candidates[scene.chosen]?.entry) : `#${location.hash.slice(1).split("&").filter((part) => /^[a-z]+$/.test(part)).join("&")}`;
  history.replaceState(null, "", address === "#" ? location.href.split("#")[0] : address);
}

function draw() {
  scene.build();
  surface.show(shown.points);
}

// What a hand does

function stroke(line) { change({ ...strokeTargets(line), stroke: true }); }

// A click puts a point behind the others, on the first of them it closes the curve; after a stroke it begins anew.
function click(place, i) {
  const { points, stroke: drawn, closed } = shown;
  if (i === undefined) change({ points: drawn ? [rounded(place)] : [...points, rounded(place)], stroke: false, closed: drawn ? false : closed });
  else if (i === 0 && !drawn && points.length >= FEWEST_POINTS) change({ closed: !closed });
}

function drag(i, place) {
  shown = { ...shown, points: shown.points.with(i, rounded(place)) };
  scene.target(shown);
  surface.show(shown.points);
  solve(true);
}

function drop() { change({ points: shown.points }); }

function remove(i) {
  change({ points: shown.points.toSpliced(i, 1) });
  (surface.handles[Math.min(i, surface.handles.length - 1)] ?? surface.area).focus();
}

function step(sense) {
  steps[sense]();
  settle();
}

const clear = () => change({ points: [], closed: false, stroke: false });
const toggleClosed = () => change({ closed: !shown.closed });

function listen() {
  byId("undo").addEventListener("click", () => step("undo"));
  byId("redo").addEventListener("click", () => step("redo"));
  byId("clear").addEventListener("click", clear);
  byId("closed").addEventListener("click", toggleClosed);
  byId("class").append(...CLASSES_ASKED.map((name) => element("option", { value: name }, name === "any" ? say("sketch.any_class") : sentence(term(name)))));
  byId("class").addEventListener("change", (event) => change({ class: event.target.value }));
  for (const id of ["least", "reach"]) {
    byId(id).addEventListener("input", () => showLimits(byId("least").valueAsNumber, byId("reach").valueAsNumber));
    byId(id).addEventListener("change", (event) => change({ [id]: event.target.valueAsNumber }));
  }
  byId("drive").addEventListener("input", (event) => goTo(event.target.valueAsNumber, true));
  listenToKeys();
  new ResizeObserver(draw).observe(byId("picture"));
  new Zoom(byId("stage"), byId("picture"), () => scene, draw);
  new Saves(byId("stage"), byId("picture"), { title: () => "sketch", go: (share) => goTo(filmed([0, 360, true], share), true), back: () => goTo(0) });
  addEventListener("hashchange", openAddress);
}

function listenToKeys() {
  shortcut(["z"], "z", "sketch.undo", () => step("undo"));
  shortcut(["y"], "y", "sketch.redo", () => step("redo"));
  shortcut(["c"], "c", "sketch.close", toggleClosed);
  shortcut(["x"], "x", "sketch.clear_all", clear);
  shortcut(["1", "2", "3"], "1 2 3", "sketch.choose", (event) => choose(Number(event.key) - 1));
  shortcut(["Enter"], "Enter", "sketch.put");
  shortcut(["Delete"], "Delete", "sketch.remove");
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.closest?.("textarea")) return;
    const sense = { z: event.shiftKey ? "redo" : "undo", y: "redo" }[event.key.toLowerCase()];
    if (!sense) return;
    event.preventDefault();
    step(sense);
  });
}

// Another sketch in the address, pasted or gone back to.
function openAddress() {
  const other = readAddress(CLASSES_ASKED);
  if (!other) return;
  steps.push({ ...EMPTY, ...other.state });
  open(other.entry);
}

// Begins with the design of the address, if any, which stays until the points change.
function open(entry) {
  shown = steps.present;
  const first = entry ? new Candidate(entry) : null;
  held = first?.poses.length ? first : null;
  offer(held ? [held] : [], 0);
  showState();
  if (held) widen();
  solve();
}

byId("kind").textContent = say("sketch.name");
byId("title").textContent = say("sketch.title");
document.title = `${say("sketch.title")} – Cognate`;
byId("summary").textContent = say("sketch.summary");
byId("work").remove();
if (!search) {
  byId("notes").hidden = false;
  byId("notes-list").append(element("li", { id: "no-kernel" }, say("sketch.no_kernel")));
}
followTheme(() => {});
listen();
open(read?.entry);
controls.start();
