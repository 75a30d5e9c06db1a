// The page of a gear train or gearbox: how it turns, what its members do.

import { followTheme } from "../appearance.js";
import { headRow, showChecks } from "../checks.js";
import { Controls, saveResult } from "../controls.js";
import { byId, element, fact } from "../dom.js";
import { embedded } from "../embedded.js";
import { factText } from "../fact_text.js";
import { degrees, duration, fixed, number } from "../format.js";
import { showHead, showNotes, showWarnings, showWork } from "../head.js";
import { offerNoEdit } from "../original.js";
import { filmed, Saves } from "../saves.js";
import { makeSortable } from "../sortable.js";
import { say, sentenceOf, term } from "../words.js";
import { Zoom } from "../zoom.js";
import { TrainScene } from "./scene.js";

const data = JSON.parse(embedded("data"));
const { result, designs } = data;
const state = { index: 0, deg: 0 };
const scene = new TrainScene(byId("picture"), (deg) => goTo(deg, true));
const controls = new Controls((seconds) => goTo(state.deg + controls.player.pace * controls.player.speed * seconds),
  (sense, large) => goTo(state.deg + sense * (large ? 10 : 1), true));

const current = () => designs[state.index];

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
const KEPT = ["speed", "torque"];
const COLUMNS = [["exact", "train.of_input"], ["speed", "train.speed"], ["relative", "train.relative"], ["torque", "train.torque"], ["power", "train.power"], ["inertia", "train.inertia"]];

// A fraction with a true minus.
const fraction = (text) => text.replace("-", "−");
const FRACTIONS = ["ratio_exact"];

function showMembers({ members }) {
  const classOf = (key) => (KEPT.includes(key) ? "number" : "number wide");
  const shown = COLUMNS.filter(([key]) => members.some((member) => member[key] !== null && member[key] !== ""));
  byId("members-table").tHead.replaceChildren(headRow([[say("train.member")], [say("train.role"), "wide"], ...shown.map(([key, words]) => [say(words), classOf(key)])]));
  const cell = (key, value) => element("td", { class: classOf(key) }, value === null || value === "" ? "–" : typeof value === "number" ? number(value, 6) : fraction(value));
  byId("members-rows").replaceChildren(...members.map((member) => element("tr", {}, element("td", {}, term(member.name)), element("td", { class: "wide" }, term(member.role)), ...shown.map(([key]) => cell(key, member[key])))));
}

function choose(index) {
  state.index = index;
  for (const [i, button] of [...byId("designs").children].entries()) button.setAttribute("aria-pressed", String(i === index));
  showMembers(current());
  byId("facts-list").replaceChildren(...current().metrics.flatMap(({ name, value }) => fact(say(`train.fact.${name}`), FRACTIONS.includes(name) ? fraction(value) : factText(value, ""), typeof value === "number" ? String(value) : undefined)));
  showChecks(current().constraints);
  showWarnings(result.designs?.[index]);
  const fastest = Math.max(1, ...current().members.map((_, i) => Math.abs(scene.rate.call({ design: current() }, i))));
  controls.player.pace = 60 / Math.min(fastest, 60);
  drawScene();
}

function showChoice() {
  byId("choice").hidden = designs.length < 2;
  byId("designs").replaceChildren(...designs.map((design, i) => {
    const missed = design.constraints.some((check) => !check.satisfied);
    const button = element("button", { type: "button", title: sentenceOf(design.origin) }, `${nameOf(design)} `, element("span", { class: `mark ${missed ? "no" : "yes"}` }, missed ? "✗" : "✓"));
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

offerNoEdit(say("edit.by_file"));
showHead(result, say("kind.gear_train"), [designs.length > 1 ? say("count.designs", { n: designs.length }) : "", designs.length ? nameOf(designs[0]) : "", result.work ? duration(result.work.seconds) : ""], say("train.keys"));
showNotes(result.notes ?? [], result.warnings);
showWork(result.work);
followTheme(() => {});
byId("save").addEventListener("click", () => saveResult(result));
if (designs.length === 0) {
  for (const id of ["stage", "facts", "members", "constraints"]) byId(id).hidden = true;
} else {
  showChoice();
  choose(0);
  listen();
  controls.start();
  makeSortable();
}
