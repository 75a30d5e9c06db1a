// The page on which a mechanism is built: what a hand draws is analysed as it moves.

import { followTheme } from "../appearance.js";
import { byId, element, set } from "../dom.js";
import { AnalysisKernel } from "../edit/analysis_kernel.js";
import { embedded } from "../embedded.js";
import { Kernel } from "../kernel.js";
import { listenToUndo, shortcut } from "../keys.js";
import { Saves } from "../saves.js";
import { TakenText } from "../taken_text.js";
import { problemToml } from "../toml.js";
import { say } from "../words.js";
import { Zoom } from "../zoom.js";
import { addressOfState, readState } from "./address.js";
import { problemOfState } from "./chain.js";
import { Desk } from "./desk.js";
import { EXAMPLES } from "./examples.js";
import { stateOfProblem } from "./given.js";
import { Hand, stepOf } from "./hand.js";
import { stateText } from "./lacks.js";
import { Lists } from "./lists.js";
import { EMPTY, loadOf } from "./model.js";
import { Analyst } from "./motion.js";
import { Results } from "./results.js";
import { BuildScene } from "./scene.js";
import { seenSpot, snapTo, stepIn } from "./seen.js";
import { Stage } from "./stage.js";
import { Toolbar } from "./toolbar.js";
import { WholeAnalysis } from "./whole_analysis.js";

// What the kernel says of the state that was analysed last, {motion, range} or {faults}; what was refused last, and the address as the
// page knows it.
let analyst = null, answer = {}, analysed = null, refused = "", kept = location.href;

const opened = readState(), given = givenState();
const scene = new BuildScene(byId("picture"), say("build.picture"));
const stage = new Stage(scene, { moved: showHandles, reached: (drive) => results.move(drive) });
const desk = new Desk(opened ?? given?.state ?? EMPTY, { spot: (place, reach) => seenSpot(scene, desk.state, place, reach, takesTorques()), snap: (place) => snapTo(place, scene.view), hold: () => stage.hold(), show: follow, settle,
  preview: (from, to) => hand.preview(from, to, (spot) => scene.at.get(spot.joint)), pan: ([x, y]) => zoom.pan(x, y), refuse: (why) => { refused = say(`build.refused_${why}`); } });
const hand = new Hand(byId("picture"), () => scene.view, { press: (...at) => desk.press(...at), move: (...at) => desk.move(...at), lift: (...at) => desk.lift(...at), put: (...at) => desk.click(...at), hover, cancel: () => desk.cancel(), abandon: () => desk.abandon(), pinch,
  leave, carry: carryByKey, key: answerKey, focus: (part) => { if (!desk.chosen || Object.entries(part).some(([kind, name]) => desk.chosen[kind] !== name)) desk.select(part); } });
const toolbar = new Toolbar(chooseTool);
listenToKeys();
const zoom = new Zoom(byId("stage"), byId("picture"), () => scene, () => stage.draw(), false);
const lists = new Lists({ state: () => desk.state, change: (next, why = "field") => desk.change(next, desk.chosen, why), chosen: () => desk.chosen, select: (one) => desk.select(one) });
const results = new Results({ goTo: (to) => stage.goTo(to, true), tintOf: (link) => scene.tintOf(link) });
const taken = new TakenText(byId("takings"), [["build.copy_problem", toml, null], ["build.save_problem", toml, "mechanism"], ["sketch.copy_link", () => location.href, null]], say("sketch.file"), toml);

// The mechanism that the program has written into the page; null where the page cannot hold it, undefined where there is none.
function givenState() {
  const data = JSON.parse(embedded("data"));
  return data.problem ? stateOfProblem(data) : undefined;
}

function note(words) {
  byId("notes").hidden = false;
  document.querySelector("#main > .side").after(byId("notes"));
  byId("notes-list").append(element("li", { "data-note": words }, say(words)));
}

function toml() { return problemToml({ title: say("build.title_of_file"), ...problemOfState(desk.state, answer.range) }); }

// States

// What a hand still changes: the curves follow, the rest once it stays.
function follow() {
  answer = analyst?.quick(desk.state) ?? {};
  analyst?.cancel();
  analysed = null;
  stage.take(desk, answer.motion);
  results.wait();
  showText();
}

function settle() {
  const { state } = desk, isOther = state !== analysed;
  stage.isHeld = desk.pending !== null;
  if (isOther) {
    analysed = state;
    answer = analyst?.settled(state, (whole) => complete(state, whole)) ?? {};
    if (answer.motion) stage.begin(answer.motion);
  }
  stage.take(desk, answer.motion);
  if (isOther) showSettled(state); else if (refused) lists.show(state); else lists.mark();
  showText();
}

// All that the kernel says of a state has come; what was said of the one before is dimmed until then.
function complete(state, whole) {
  answer = whole;
  if (whole.motion) stage.refine(desk, whole.motion); else stage.take(desk, null);
  results.show(whole.motion ?? null, state);
  results.move(stage.drive);
  for (const id of ["play", "drive"]) byId(id).disabled = !whole.motion;
  showText();
}

function showSettled(state) {
  lists.show(state);
  if (answer.isPending) results.wait(); else results.show(null, state);
  if (answer.motion && scene.include(scene.reached)) stage.draw();
  stage.goTo(stage.drive);
  const isEmpty = state.joints.length === 0;
  byId("begin").hidden = !isEmpty;
  byId("clear").disabled = isEmpty;
  byId("undo").disabled = !desk.steps.canUndo;
  byId("redo").disabled = !desk.steps.canRedo;
  for (const id of ["play", "drive"]) byId(id).disabled = !answer.motion;
  taken.follow((name) => !isEmpty && (name === "copy_link" || state.links.length > 0));
  keepAddress(state);
}

function showText() {
  const text = refused || stateText(desk.state, answer);
  set(byId("state"), { class: refused || answer.faults ? "wrong" : answer.motion && !answer.isPending ? "sound" : "", "aria-busy": String(Boolean(answer.isPending)) });
  byId("state").textContent = text;
  refused = "";
}

// Not over an address that another hand has put there and that is about to be opened.
function keepAddress(state) {
  if (location.href !== kept) return;
  const address = addressOfState(state);
  history.replaceState(null, "", address === "#" ? location.href.split("#")[0] : address);
  kept = location.href;
}

// Of one that holds no mechanism the address becomes that of what is shown.
function openAddress() {
  kept = location.href;
  const other = readState();
  if (other) { desk.change(other, null); return; }
  keepAddress(desk.state);
  if (other === undefined) { refused = say("build.bad_address"); showText(); }
}

// What a hand chooses

// A cross that moves over the sheet finds things where they are drawn.
function hover(place, reach, byKeys) {
  if (byKeys && !stage.isHeld) stage.hold();
  desk.hover(place, reach);
}

function chooseTool(tool) {
  toolbar.show(tool);
  desk.choose(tool);
}

function pinch(factor, at, way) {
  zoom.pan(...way);
  zoom.by(factor, at);
}

function leave() { if (!desk.pending && !desk.from) stage.release(); }

function carryByKey(event) {
  const step = stepOf(event);
  if (!step || !desk.chosen || desk.tool !== "move") return false;
  desk.carry(step.map((x) => x * stepIn(scene.view)));
  return true;
}

// Torques are selected, or turned round.
const takesTorques = () => ["move", "load"].includes(desk.tool);

// What a click at a part would take.
function spotOfPart({ joint, load }) {
  const of = load === undefined ? null : loadOf(desk.state, load);
  return joint !== undefined ? { joint } : { load, ...(of.force || desk.tool !== "load" ? {} : { link: of.on }) };
}

function showHandles() {
  hand.show(desk.state.joints.map(({ name, at }) => ({ name, at: scene.at.get(name) ?? at, label: say("build.joint", { name }) })),
    scene.grips.map(({ name, on, force, grip }) => ({ name, at: grip, label: say(force ? "build.force" : "build.torque", { name: on }) })));
}

// Of a joint or a load: arrows move it, Delete removes it, Enter does what a click of the tool does.
function answerKey(part, event) {
  const step = stepOf(event);
  if (event.key === "Delete" || event.key === "Backspace") { desk.remove(part); hand.focus(desk.state.joints[0]?.name); return true; }
  if (event.key === "Enter" || event.key === " ") { desk.click(null, 0, spotOfPart(part)); return true; }
  if (!step) return false;
  desk.chosen = part;
  desk.carry(step.map((x) => x * stepIn(scene.view)));
  return true;
}

function listenToKeys() {
  shortcut(["Escape"], "Esc", "build.cancel", () => desk.cancel() || (zoom.isLarge && zoom.large(false)));
  shortcut(["Delete", "Backspace"], "Delete", "build.remove", () => desk.remove());
  shortcut(["z"], "z", "sketch.undo", () => desk.step("undo"));
  shortcut(["y"], "y", "sketch.redo", () => desk.step("redo"));
  shortcut(["x"], "x", "build.clear_all", () => desk.change(EMPTY));
  shortcut(["Enter"], "Enter", "build.put");
  listenToUndo((sense) => desk.step(sense));
}

function listen() {
  byId("undo").addEventListener("click", () => desk.step("undo"));
  byId("redo").addEventListener("click", () => desk.step("redo"));
  byId("clear").addEventListener("click", () => desk.change(EMPTY));
  byId("drive").addEventListener("input", (event) => stage.goTo(event.target.valueAsNumber, true));
  byId("examples").append(...Object.entries(EXAMPLES).map(([name, state]) => {
    const button = element("button", { type: "button", class: "chip", "data-example": name }, say(`build.example_${name}`));
    button.addEventListener("click", () => { chooseTool("move"); desk.change(state); });
    return button;
  }));
  new ResizeObserver(() => stage.draw()).observe(byId("picture"));
  new Saves(byId("stage"), byId("picture"), { title: () => "mechanism", go: (share) => stage.film(share), back: () => stage.goTo(stage.start) }, () => scene.drawing);
  addEventListener("hashchange", openAddress);
}

// With the mechanism of the address, if any; of one that is damaged it is said again once the kernel is there.
function begin() {
  if (opened === undefined && desk.steps.states.length === 1) refused = say("build.bad_address");
  settle();
}

byId("kind").textContent = say("build.name");
byId("title").textContent = say("build.title");
document.title = `${say("build.title")} – Cognate`;
byId("summary").textContent = say("build.summary");
byId("work").remove();
if (!Kernel.available) note("build.no_kernel");
if (given === null) note("build.not_given"); else if (given && !given.isWhole) note("build.given_in_part");
followTheme(() => results.redraw());
stage.take(desk, null);
// On an empty sheet one begins with links.
chooseTool(desk.state.links.length ? "move" : "link");
listen();
begin();
stage.controls.start();
if (Kernel.available) {
  AnalysisKernel.load().then((kernel) => {
    analyst = new Analyst(kernel, new WholeAnalysis());
    analysed = null;
    begin();
    scene.look();
    stage.draw();
  });
}
