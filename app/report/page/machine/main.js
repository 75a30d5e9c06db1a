// The page of a machine: which motion is shown, what time it is in it, and everything that follows.

import { followTheme } from "../appearance.js";
import { Controls, saveResult } from "../controls.js";
import { Curves } from "../curves.js";
import { byId, element, set } from "../dom.js";
import { embedded } from "../embedded.js";
import { Extras } from "../extras.js";
import { degrees, duration, number, sentence } from "../format.js";
import { TableEditor } from "../edit/table_editor.js";
import { Ghost, GHOSTS } from "../ghosts.js";
import { showHead, showNotes, showWork } from "../head.js";
import { jointsOf } from "../joints.js";
import { Kernel } from "../kernel.js";
import { Mechanism } from "../mechanism.js";
import { MechanismScene } from "../mechanism_scene.js";
import { Saves } from "../saves.js";
import { legendItem } from "../shapes.js";
import { offerNoEdit } from "../original.js";
import { showProblem } from "../problem.js";
import { Trace } from "../trace.js";
import { TracedPoints } from "../traced.js";
import { say, term } from "../words.js";
import { Zoom } from "../zoom.js";
import { isEditable, machineFields, machineRows } from "./edited.js";
import { showMachineFacts } from "./facts.js";
import { DRIVE_ALONE, Motion } from "./model.js";
import { machineSheets } from "./sheets.js";

const data = JSON.parse(embedded("data"));
const { result } = data;
let { motions, facts, mechanism } = take(data);
const state = { time: 0, motion: motions[0] };
const scene = new MechanismScene(byId("picture"), mechanism, (drive) => drive !== null && goTo(state.motion.timeAt(drive, state.time), true));
scene.jointsAt = jointsOf(mechanism, result.problem?.mechanism);
const traced = new TracedPoints(byId("picture"), byId("ghosts"), () => extras.toggle(traced, traced.points.length > 0));
const extras = new Extras(byId("extras"), [new Trace(), traced, ...Object.keys(GHOSTS).map((ghost) => new Ghost(ghost, byId("ghosts")))]);
extras.redraw = () => drawScene();
extras.onToggle = () => showLegend();
const curves = new Curves(byId("plots"), (time) => goTo(time, true), (time) => extras.point(time === null ? null : driveAt(time)));
const controls = new Controls((seconds) => goTo(controls.player.next(state.time, [0, state.motion?.length ?? 0, true], seconds)),
  (sense, large) => goTo(state.time + (sense * (large ? 10 : 1) * (state.motion?.length ?? 0)) / 360, true));

// What is drawn of a machine.
function take({ motions: tables, facts: figures, mechanism: motion, drive }) {
  return { motions: tables.map((table) => new Motion(table)), facts: new Map(figures.map(({ name, value }) => [name, value])),
    mechanism: new Mechanism(motion ?? DRIVE_ALONE, drive ?? { from: 0, to: 360, round: true }) };
}

// The drive's coordinate, within a turn, at a time of the motion shown.
const driveAt = (time) => mechanism.within(state.motion ? state.motion.angle(time) : mechanism.start);

// Everything that follows the time. `byHand` stops the clock.
function goTo(time, byHand = false) {
  if (time === null) return;
  if (byHand) controls.play(false);
  state.time = state.motion ? state.motion.within(time) : 0;
  const drive = driveAt(state.time);
  scene.move(drive);
  extras.move(drive);
  traced.see(scene, drive);
  curves.move(state.time);
  showTime(drive);
  byId("open").hidden = mechanism.places(drive).every(Boolean);
}

function showTime(drive) {
  const slider = byId("drive");
  const text = say("machine.now", { time: number(state.time, 4), angle: degrees(drive, 1) });
  slider.value = state.time;
  slider.setAttribute("aria-valuetext", text);
  byId("drive-value").textContent = text;
  byId("pace").textContent = state.motion?.length ? say("machine.pace", { factor: number(controls.player.pace * controls.player.speed, 3) }) : "";
}

function choose(motion, time = 0) {
  Object.assign(state, { motion, time });
  controls.player.pace = motion.pace;
  for (const button of document.querySelectorAll("[data-task]")) button.setAttribute("aria-pressed", String(button.dataset.task === motion.task));
  set(byId("drive"), { min: 0, max: motion.length });
  byId("curves-title").textContent = say(`machine.task.${motion.task}`);
  curves.build(machineSheets(motion, facts));
  const marked = motion.steady && facts.has("speed_max_at_deg");
  byId("marks").replaceChildren(...(marked ? [legendItem("good", "dashed", say("machine.greatest")), legendItem("bad", "dashed", say("machine.least"))] : []));
  goTo(Math.min(time, motion.length));
}

function showTasks() {
  byId("tasks").hidden = motions.length < 2;
  byId("tasks").replaceChildren(...motions.map((motion) => {
    const button = element("button", { type: "button", "data-task": motion.task }, say(`machine.task.${motion.task}`));
    button.addEventListener("click", () => choose(motion));
    return button;
  }));
}

function showLegend() {
  const bodies = mechanism.bodies.length > 9 ? [] : mechanism.bodies.slice(1).map((body, i) => legendItem(scene.tint(i + 1).slice(2), "line", sentence(term(body.name))));
  const paths = mechanism.points.some((p) => p.moves && !p.isPin) ? [legendItem("curve", "line", say("legend.path"))] : [];
  byId("legend").replaceChildren(...bodies, ...paths, ...extras.legend());
}

// Buttons that switch on what the picture can show with the mechanism.
function listenToLayers() {
  for (const button of document.querySelectorAll("[data-layer]")) {
    const { layer } = button.dataset;
    button.hidden = !mechanism.points.some((p) => layer === "names" || p.moves);
    button.setAttribute("aria-pressed", String(Boolean(scene.shown[layer])));
    button.addEventListener("click", () => {
      scene.show({ [layer]: !scene.shown[layer] });
      button.setAttribute("aria-pressed", String(scene.shown[layer]));
    });
  }
}

function drawScene() {
  scene.build();
  extras.rebuilt(scene);
  goTo(state.time);
}

// The motions that there are, the one that was shown if it is among them; a machine that does not move has none.
function showMotions() {
  const stands = motions.length === 0;
  showTasks();
  byId("curves").hidden = byId("player").hidden = stands;
  if (stands) Object.assign(state, { motion: undefined, time: 0 });
  if (stands) drawScene(); else choose(motions.find(({ task }) => task === state.motion?.task) ?? motions[0], state.time);
}

// An edited machine with everything that follows from it; that of the file for null.
function showEdited(answer, problem) {
  controls.play(false);
  ({ motions, facts, mechanism } = take(answer ?? data));
  scene.adopt(mechanism);
  scene.jointsAt = jointsOf(mechanism, problem.mechanism);
  showProblem(problem, say("kind.machine"));
  showNotes((answer ?? result).notes ?? [], answer ? [] : result.warnings);
  showMachineFacts(facts);
  showLegend();
  scene.build();
  extras.rebuilt(scene);
  showMotions();
}

function listen() {
  byId("drive").addEventListener("input", (event) => goTo(Number(event.target.value), true));
  new ResizeObserver(drawScene).observe(byId("picture"));
  new Zoom(byId("stage"), byId("picture"), () => scene, drawScene);
  let stood = 0;
  new Saves(byId("stage"), byId("picture"), { title: () => result.problem?.title, go: (share) => { if (!share) stood = state.time; goTo(share * (state.motion?.length ?? 0), true); }, back: () => goTo(stood) });
}

if (!data.mechanism) byId("stage-title").textContent = say("machine.drive");
const editor = Kernel.available && isEditable(result)
  ? new TableEditor({ call: "machine", problem: result.problem, hint: say("edit.hint_machine"), kept: ["work"], first: () => result.problem, mayBeEmpty: true,
    fields: machineFields, rows: machineRows, checks: () => [], show: showEdited }) : null;
if (!editor) offerNoEdit(say(Kernel.available ? "edit.too_large" : "edit.by_file"));
showHead(result, say("kind.machine"), [data.mechanism ? say("count.moving_bodies", { n: mechanism.bodies.length - 1 }) : "",
  say("machine.count", { n: motions.length }), result.work ? duration(result.work.seconds) : ""], say("head.keys_drive"),
  { infeasible: "machine.incomplete" });
showNotes(result.notes ?? [], result.warnings);
showWork(result.work);
showMachineFacts(facts);
followTheme(() => curves.redraw());
if (data.thinned) byId("save").textContent = say("save.without_table");
byId("save").addEventListener("click", () => saveResult(result));
showLegend();
scene.build();
extras.rebuilt(scene);
listenToLayers();
listen();
showMotions();
controls.start();
if (motions.length === 0) controls.play(false);
