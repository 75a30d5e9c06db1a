// The page of a sketch: a curve, poses or a function that a hand draws, and the linkages for them.

import { followTheme } from "../appearance.js";
import { Controls } from "../controls.js";
import { byId, element } from "../dom.js";
import { History } from "../edit/history.js";
import { degrees, duration, fixed, number, sentence } from "../format.js";
import { Kernel } from "../kernel.js";
import { listenToUndo, shortcut } from "../keys.js";
import { RADIANS } from "../sampling.js";
import { filmed, Saves } from "../saves.js";
import { say, sentenceOf, term } from "../words.js";
import { Zoom } from "../zoom.js";
import { addressOf, readAddress } from "./address.js";
import { Boxes, withClass } from "./boxes.js";
import { Bringings } from "./bringings.js";
import { differing, nearestTo, withoutNoise } from "./candidate.js";
import { Cards, percent } from "./cards.js";
import { clearCosts, costQuestions, showCost } from "./costs.js";
import { drawingOf } from "./drawing.js";
import { FrontPanel } from "./front_panel.js";
import { onLayout } from "./layout.js";
import { Leader } from "./leader.js";
import { Mechanisms } from "./mechanisms.js";
import { modeOf, MODES } from "./modes.js";
import { ANY_SPEED, CLASSES_ASKED, drawingSize, leadingQuestion, liveQuestion, questionsOf, suits } from "./question.js";
import { SketchScene } from "./scene.js";
import { Search } from "./search.js";
import { strokeTargets } from "./stroke.js";
import { Surface } from "./surface.js";
import { Takings } from "./takings.js";
import { Typed } from "./typed.js";
import { Workers } from "./worker.js";

// `angles`: of poses one for each point, in degrees, else null; `ranges`: of a function, whose points are pairs of angles, those of
// input and output in degrees, else null; `typed`: the expression {text, domain} of these pairs, if they are of one.
const EMPTY = { ...MODES.curve.empty({}), class: "any", least: 30, reach: 3, even: ANY_SPEED, region: null, obstacle: null };
const SHOWN = 3;

const scene = new SketchScene(byId("picture"), say("sketch.picture"));
const controls = new Controls((seconds) => goTo(scene.phase / RADIANS + controls.player.pace * controls.player.speed * seconds),
  (sense, large) => goTo(scene.phase / RADIANS + sense * (large ? 10 : 1), true));
controls.player.pace = 120;
const cards = new Cards((i) => choose(i));
const takings = new Takings(() => ({ state: shown, candidate: scene.candidates[scene.chosen] }));
const panel = new FrontPanel({ point: lookAt, take: takePoint });
const workers = Kernel.available ? new Workers((text) => announce(say("sketch.failed", { text }))) : null;
const search = workers && new Search(workers, take), leader = workers && new Leader(workers, lead);
const surface = new Surface(byId("picture"), () => scene.view, { begin: () => stop(), resume: () => solve(), box: (p, q) => boxes.put(p, q), stroke: (line) => put(modeOf(shown).stroke(shown, line)),
  click: (place, i) => put(modeOf(shown).click(shown, place, i)), drag: (i, place) => follow(modeOf(shown).moved(shown, i, place)), turn: (i, degrees) => follow({ angles: shown.angles.with(i, degrees) }), drop, remove });
const boxes = new Boxes(surface, { state: () => shown, change, announce: (text) => announce(text), resume: () => solve() });
const mechanisms = new Mechanisms({ state: () => shown, change });
const typed = new Typed({ state: () => shown, change, ask: (question) => search?.ask([question]), forget: forgetTyped, announce: (text) => announce(text) });
const read = readAddress(CLASSES_ASKED);
let steps = new History({ ...EMPTY, ...read?.state });
// The state shown, which a drag has changed and the history does not hold yet; the design that stays chosen.
let shown = steps.present, held = null, begun = 0;
// The address as the page knows it.
let kept = location.href;
// The designs that were shown when a drag began; null while nothing is dragged. Its steps are counted: that of the last answer with all
// designs, and the last one of the design that leads.
let dragged = null, moves = 0, followed = 0, led = { at: 0, candidate: null };

const announce = (text) => { byId("state").textContent = text; };
const isEnough = () => shown.points.length >= modeOf(shown).fewest;

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
  cards.show(candidates, chosen, shown);
  panel.show(candidates[chosen]);
  followTakings();
}

const followTakings = () => takings.follow(isEnough(), scene.candidates.length > 0);

function choose(i) {
  if (!scene.candidates[i]) return;
  held = scene.candidates[i];
  offer(scene.candidates, i);
  byId(`design-${i}`).focus();
  keepAddress();
}

// A design that is only looked at; null where none is.
function lookAt(candidate) {
  if (candidate === scene.looked) return;
  scene.looked = candidate;
  draw();
}

// An answer of the search.
function take(answer, question) {
  if (question.typed) { typed.take(answer, question); return; }
  if (question.limit) { showCost(answer, question, shown, leastError()); return; }
  const found = (answer.designs ?? []).map((entry) => modeOf(shown).candidate(entry, shown));
  if (question.front) takeOfFront(found); else takeFound(answer, found, question);
}

// A design of the front, with the bound that it is the best for.
function takePoint(candidate, least) {
  steps.push({ ...steps.present, least });
  hold(candidate, panel.front.within(least));
  keepAddress();
}

function takeOfFront(found) {
  panel.front.take(found);
  panel.show(scene.candidates[scene.chosen]);
  if (!panel.front.ended) search.ask([panel.front.question]);
}

// The design chosen, which a drag takes along before the others.
function lead({ designs = [] }, { at }) {
  const [first] = differing(designs.map((entry) => modeOf(shown).candidate(entry, shown)), 1, drawingSize(shown), null);
  if (!first || at <= followed) return;
  led = { at, candidate: first };
  offer(scene.candidates.toSpliced(scene.chosen, 1, first), scene.chosen);
}

// Designs of the longer searches replace those before where they are better; in a drag the one that leads may be ahead.
function takeFound(answer, found, { live, first, last, at }) {
  const before = first ? [] : scene.candidates;
  if (live) followed = at; else { panel.front.add(found); leader.prepare(); }
  const candidates = differing([...(live ? found : panel.front.within(shown.least)), ...before], SHOWN, drawingSize(shown), live && led.at > at ? led.candidate : held);
  const chosen = scene.candidates[scene.chosen];
  offer(candidates, Math.max(0, live && chosen ? nearestTo(candidates, chosen) : candidates.indexOf(held)));
  if (!live && scene.candidates.length) widen();
  announce(answer.faults ? answer.faults.map((fault) => sentence(sentenceOf(fault))).join(" ") : stateText(last, live));
  if (!live) keepAddress();
  if (last && !live && !answer.faults) search.ask([...(leastError() > 0 ? costQuestions(shown) : []), ...(panel.front.ended ? [] : [panel.front.question])]);
}

const leastError = () => Math.min(Infinity, ...scene.candidates.map(({ entry }) => withoutNoise(entry.rms, drawingSize(shown))));

function stateText(last, live) {
  const time = duration((performance.now() - begun) / 1000);
  if (scene.candidates.length === 0) return say(last && !live ? "sketch.no_design" : "sketch.searching");
  return say(last || live ? "sketch.found" : "sketch.found_going_on", { n: scene.candidates.length, time });
}

// The linkage chosen is seen whole.
function widen() { if (scene.include(scene.candidates[scene.chosen].places)) draw(); }

function solve(live = false) {
  begun = performance.now();
  clearCosts();
  panel.follow(search && isEnough() && !live ? shown : null);
  if (!search || !isEnough()) return;
  if (live) { searchAlong(); return; }
  announce(say("sketch.searching"));
  search.ask([...typed.checks(shown), ...questionsOf(shown, scene.candidates)]);
}

// While a hand drags.
function searchAlong() {
  const { candidates, chosen } = scene, at = ++moves, leading = candidates[chosen] && leadingQuestion(shown, candidates[chosen]);
  if (leading) leader.ask({ ...leading, at });
  search.askNewest({ ...liveQuestion(shown, [...new Set([...candidates, ...dragged])]), at });
}

const stop = () => { search?.cancel(); leader?.forget(); };

// States

// Takes `change` of the state as a step that can be undone.
function change(parts) {
  steps.push({ ...steps.present, ...parts });
  settle();
}

// An expression that is not that of the pairs.
function forgetTyped() {
  steps.amend({ typed: null });
  shown = { ...shown, typed: null };
  byId("expression").value = "";
  keepAddress();
}

// Shows the present state, and searches for it.
function settle() {
  shown = steps.present;
  held = dragged = null;
  stop();
  leaveOthers();
  if (!isEnough()) askForMore();
  showState();
  keepAddress();
  solve();
}

// Designs of another kind of drawing cannot be drawn in this one, nor those of its front that a hand looks at.
function leaveOthers() {
  scene.targets = shown;
  const { candidates, looked } = scene, own = candidates.filter(({ entry }) => suits(entry, shown));
  if (own.length === candidates.length && (!looked || suits(looked.entry, shown))) return;
  Object.assign(scene, { candidates: own, looked: null });
  panel.follow(null);
  offer(own, Math.max(0, own.indexOf(candidates[scene.chosen])));
}

function askForMore() {
  offer([], 0);
  const { more, fewest } = modeOf(shown);
  announce(shown.points.length ? say(more, { least: fewest }) : "");
}

function showState() {
  const { points, ranges, closed, class: asked, least, reach, even } = shown, mode = modeOf(shown);
  byId("undo").disabled = !steps.canUndo;
  byId("redo").disabled = !steps.canRedo;
  byId("clear").disabled = points.length === 0;
  byId("closed").setAttribute("aria-pressed", String(closed));
  document.body.dataset.drawing = mode.name;
  mechanisms.show();
  for (const name of Object.keys(MODES)) byId(`of-${name}`).setAttribute("aria-pressed", String(name === mode.name));
  byId("hint").hidden = points.length > 0;
  byId("hint").textContent = say(mode.hint);
  byId("class").value = asked;
  byId("least").value = least;
  byId("reach").value = reach;
  byId("even").value = even;
  showLimits({ least, reach, even });
  typed.show(ranges, shown.typed);
  boxes.show();
  showTargets();
  followTakings();
}

function showTargets() {
  scene.target(shown);
  showHandles();
}

function showHandles() {
  const { places, label } = modeOf(shown);
  surface.show(places(shown), shown.angles, (i) => label(shown, i), shown.straight);
}

function showLimits({ least, reach, even }) {
  byId("least-value").textContent = degrees(least, 0);
  byId("reach-value").textContent = say(modeOf(shown).times, { value: number(reach) });
  byId("even-value").textContent = even < ANY_SPEED ? percent(even / 100) : say("sketch.any_speed");
}

// Not over an address that another hand has put there and that is about to be opened.
function keepAddress() {
  if (location.href !== kept) return;
  const address = shown.points.length ? addressOf(shown, scene.candidates[scene.chosen]?.entry) : `#${location.hash.slice(1).split("&").filter((part) => /^[a-z]+$/.test(part)).join("&")}`;
  history.replaceState(null, "", address === "#" ? location.href.split("#")[0] : address);
  kept = location.href;
}

function draw() {
  scene.build();
  showHandles();
}

// What a hand does

// Takes what a stroke or a click changes; null where that is nothing.
function put(parts) { if (parts) change(parts); else solve(); }

// While a hand changes targets nothing that was chosen for the former ones stays.
function follow(targets) {
  shown = { ...shown, ...targets };
  held = null;
  dragged ??= scene.candidates;
  showTargets();
  if (shown.straight && !shown.region) offer(scene.candidates.map(({ entry }) => modeOf(shown).candidate(entry, shown)), scene.chosen); else solve(true);
}

function drop() {
  const { points, angles, typed: expression } = shown;
  if (points !== steps.present.points || angles !== steps.present.angles) change({ points, angles, typed: expression });
}

function remove(i) {
  change(modeOf(shown).removed(shown, i));
  (surface.handles[Math.min(i, surface.handles.length - 1)] ?? surface.area).focus();
}

function step(sense) {
  steps[sense]();
  settle();
}

const clear = () => change(modeOf(shown).empty(shown));
const toggleClosed = () => { if (modeOf(shown) === MODES.curve) change({ closed: !shown.closed }); };

const limits = () => ({ class: shown.class, least: shown.least, reach: shown.reach, even: shown.even, region: shown.region, obstacle: shown.obstacle });

// What is drawn from now on; what there was of another kind goes.
function drawAnother(mode) { if (mode !== modeOf(shown)) change({ ...limits(), ...mode.empty({}) }); }

function listen() {
  byId("undo").addEventListener("click", () => step("undo"));
  byId("redo").addEventListener("click", () => step("redo"));
  byId("clear").addEventListener("click", clear);
  byId("closed").addEventListener("click", toggleClosed);
  for (const [name, mode] of Object.entries(MODES)) byId(`of-${name}`).addEventListener("click", () => drawAnother(mode));
  byId("class").append(...CLASSES_ASKED.map((name) => element("option", { value: name }, name === "any" ? say("sketch.any_class") : sentence(term(name)))));
  byId("class").addEventListener("change", (event) => change(withClass(event.target.value)));
  const sliders = ["least", "reach", "even"];
  for (const id of sliders) {
    byId(id).addEventListener("input", () => showLimits(Object.fromEntries(sliders.map((name) => [name, byId(name).valueAsNumber]))));
    byId(id).addEventListener("change", (event) => change({ [id]: event.target.valueAsNumber }));
  }
  byId("drive").addEventListener("input", (event) => goTo(event.target.valueAsNumber, true));
  listenToKeys();
  new ResizeObserver(draw).observe(byId("picture"));
  new Zoom(byId("stage"), byId("picture"), () => scene, draw);
  new Saves(byId("stage"), byId("picture"), { title: () => "sketch", go: (share) => goTo(filmed([0, 360, true], share), true), back: () => goTo(0) },
    () => drawingOf(scene.candidates[scene.chosen], scene.phase, shown));
  new Bringings(byId("stage"), { curve: (line) => change({ ...MODES.curve.empty(shown), ...limits(), ...strokeTargets(line), stroke: true }), picture: (picture) => { scene.picture = picture; draw(); }, fault: announce });
  addEventListener("hashchange", openAddress);
  onLayout(layAnew);
}

function listenToKeys() {
  shortcut(["z"], "z", "sketch.undo", () => step("undo"));
  shortcut(["y"], "y", "sketch.redo", () => step("redo"));
  shortcut(["c"], "c", "sketch.close", toggleClosed);
  shortcut(["x"], "x", "sketch.clear_all", clear);
  shortcut(["r"], "r", "sketch.region", () => boxes.toggle("region"));
  shortcut(["o"], "o", "sketch.obstacle", () => { if (!shown.slides && !shown.straight) boxes.toggle("obstacle"); });
  shortcut(["p"], "p", "sketch.another_kind", () => drawAnother(modeOf(shown).next()));
  shortcut(["m"], "m", "sketch.other_mechanism", () => mechanisms.next());
  shortcut(["1", "2", "3"], "1 2 3", "sketch.choose", (event) => choose(Number(event.key) - 1));
  shortcut(["Enter"], "Enter", "sketch.put");
  shortcut(["Delete"], "Delete", "sketch.remove");
  listenToUndo(step);
}

// Another sketch in the address, pasted or gone back to; of one that holds none the address becomes that of what is shown.
function openAddress() {
  kept = location.href;
  const other = readAddress(CLASSES_ASKED);
  if (!other) { keepAddress(); return; }
  steps.push({ ...EMPTY, ...other.state });
  open(other.entry);
}

// Of a function all has another place in a window that is narrow now, or no longer.
function layAnew() {
  if (!shown.ranges) return;
  panel.front.forget();
  open(scene.candidates[scene.chosen]?.entry);
}

// Begins with the design of the address, if any.
function open(entry) {
  const first = entry ? modeOf(steps.present).candidate(entry, steps.present) : null;
  hold(first?.poses.length ? first : null);
}

// Shows the present state with a design, if any, which stays until the points change, and others.
function hold(candidate, others = []) {
  shown = steps.present;
  stop();
  held = candidate;
  dragged = null;
  leaveOthers();
  const candidates = held ? differing([held, ...others], SHOWN, drawingSize(shown), held) : [];
  if (held || isEnough()) offer(candidates, Math.max(0, candidates.indexOf(held))); else askForMore();
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
  byId("plot").disabled = true;
  byId("notes").hidden = false;
  byId("notes-list").append(element("li", { id: "no-kernel" }, say("sketch.no_kernel")));
}
followTheme(() => {});
listen();
open(read?.entry);
controls.start();
