// The page of a gear train or gearbox: how it turns, what its members do.

import { followTheme } from "../appearance.js";
import { checkRows, headRow, showChecks } from "../checks.js";
import { Controls, saveResult } from "../controls.js";
import { byId, element, fact } from "../dom.js";
import { embedded } from "../embedded.js";
import { degrees, duration, fixed, number } from "../format.js";
import { showHead, showNotes, showWarnings, showWork } from "../head.js";
import { Kernel } from "../kernel.js";
import { TableEditor } from "../edit/table_editor.js";
import { offerNoEdit } from "../original.js";
import { showProblem } from "../problem.js";
import { filmed, Saves } from "../saves.js";
import { makeSortable } from "../sortable.js";
import { say, sentenceOf, term } from "../words.js";
import { Zoom } from "../zoom.js";
import { givenTrain, trainFields, trainRows } from "./edited.js";
import { fractionText, trainFactName, trainFactText } from "./facts.js";
import { TrainScene } from "./scene.js";

const data = JSON.parse(embedded("data"));
const { result, designs } = data;
// Of a train that is given its states; else trains that were found.
const areStates = !result.problem?.target;
// What an edit has made of all states, or of the train that was shown.
let edited = null;
const state = { index: 0, deg: 0 };
const scene = new TrainScene(byId("picture"), (deg) => goTo(deg, true));
const controls = new Controls((seconds) => goTo(state.deg + controls.player.pace * controls.player.speed * seconds),
  (sense, large) => goTo(state.deg + sense * (large ? 10 : 1), true));

const shownOf = (answer) => answer.designs[areStates ? state.index : 0];
const current = () => (edited ? shownOf(edited) : designs[state.index]);

// What a design is called: its state, or its teeth.
const nameOf = ({ state: named, teeth }) => named || teeth.map((pair) => pair.join(":")).join(" ");

// Everything that follows the drive. `byHand` stops the clock. The angle counts on over turns, as the slowest member does.
function goTo(deg, byHand = false) {
  if (byHand) controls.play(false);
  state.deg = deg;
  scene.move(deg);
  const shown = deg - 360 * Math.floor(deg / 360);
  const slider = byId("drive");
  slider.value = shown;
  slider.setAttribute("aria-valuetext", say("motion.degrees", { value: fixed(shown, 1) }));
  byId("drive-value").textContent = degrees(shown, 2);
}

function drawScene() {
  scene.build(current());
  goTo(state.deg);
}

// Columns are left out where there is little room, but for these.
const KEPT_COLUMNS = ["speed", "torque"];
const COLUMNS = [["exact", "train.of_input"], ["speed", "train.speed"], ["relative", "train.relative"], ["torque", "train.torque"], ["power", "train.power"], ["inertia", "train.inertia"]];

function showMembers({ members }) {
  const classOf = (key) => (KEPT_COLUMNS.includes(key) ? "number" : "number wide");
  const shown = COLUMNS.filter(([key]) => members.some((member) => member[key] !== null && member[key] !== ""));
  byId("members-table").tHead.replaceChildren(headRow([[say("train.member")], [say("train.role"), "wide"], ...shown.map(([key, words]) => [say(words), classOf(key)])]));
  const cell = (key, value) => element("td", { class: classOf(key) }, value === null || value === "" ? "–" : typeof value === "number" ? number(value, 6) : fractionText(value));
  byId("members-rows").replaceChildren(...members.map((member) => element("tr", {}, element("td", {}, term(member.name)), element("td", { class: "wide" }, term(member.role)), ...shown.map(([key]) => cell(key, member[key])))));
}

function choose(index) {
  if (!areStates) {
    editor?.close(false);
    edited = null;
  }
  state.index = index;
  showChoice();
  showDesign();
  editor?.refresh();
}

// Everything that is said and drawn of the train shown.
function showDesign() {
  showMembers(current());
  byId("facts-list").replaceChildren(...current().metrics.flatMap(({ name, value }) => fact(trainFactName(name), trainFactText(name, value), typeof value === "number" ? String(value) : undefined)));
  showChecks(current().constraints);
  showWarnings(edited ? current() : result.designs?.[state.index]);
  const fastest = Math.max(1, ...current().members.map((_, i) => Math.abs(scene.rate.call({ design: current() }, i))));
  controls.player.pace = 60 / Math.min(fastest, 60);
  drawScene();
}

// What an edit has made of the train, and its problem; the train as it was found for null.
function showEdited(answer, problem) {
  edited = answer;
  showProblem(problem, say("kind.gear_train"));
  showNotes((answer ?? result).notes ?? [], (answer ?? result).warnings);
  showChoice();
  showDesign();
}

function showChoice() {
  byId("choice").hidden = designs.length < 2;
  byId("designs").replaceChildren(...(areStates && edited ? edited.designs : designs).map((design, i) => {
    const missed = design.constraints.some((check) => !check.satisfied);
    const button = element("button", { type: "button", title: sentenceOf(design.origin), "aria-pressed": String(i === state.index) }, `${nameOf(design)} `, element("span", { class: `mark ${missed ? "no" : "yes"}` }, missed ? "✗" : "✓"));
    button.addEventListener("click", () => choose(i));
    return button;
  }));
}

function listen() {
  byId("drive").addEventListener("input", (event) => goTo(Number(event.target.value), true));
  new ResizeObserver(drawScene).observe(byId("picture"));
  new Zoom(byId("stage"), byId("picture"), () => scene, drawScene);
  let stood = 0;
  new Saves(byId("stage"), byId("picture"), { title: () => result.problem?.title, go: (share) => { if (!share) stood = state.deg; goTo(filmed([0, 360, true], share), true); }, back: () => goTo(stood) });
}

const editor = Kernel.available && designs.length && result.problem && result.designs?.[0]?.mechanism
  ? new TableEditor({ call: "train", problem: result.problem, hint: say("edit.hint_train"), kept: areStates ? ["work"] : ["choice", "work"], first: () => givenTrain(result.problem, result.designs[state.index]),
    fields: trainFields, rows: (before, now) => trainRows(shownOf(before), shownOf(now)), checks: (now) => checkRows(shownOf(now).constraints), show: showEdited }) : null;
if (!editor) offerNoEdit(say("edit.by_file"));
showHead(result, say("kind.gear_train"), [designs.length > 1 ? say(areStates ? "count.states" : "count.designs", { n: designs.length }) : "", designs.length && !areStates ? nameOf(designs[0]) : "", result.work ? duration(result.work.seconds) : ""], say("train.keys"));
if (areStates) byId("choice-title").textContent = say("train.states");
showNotes(result.notes ?? [], result.warnings);
showWork(result.work);
followTheme(() => {});
byId("save").addEventListener("click", () => saveResult(result));
if (designs.length === 0) {
  for (const id of ["stage", "facts", "members", "constraints"]) byId(id).hidden = true;
} else {
  choose(0);
  listen();
  controls.start();
  makeSortable();
}
