// Editing an analysed problem: every change is evaluated by the program's own evaluator. While a joint
// is dragged the motion follows; once it is let go everything on the page does.

import { byId, element } from "../dom.js";
import { Mechanism } from "../mechanism.js";
import { tableWithoutRounding } from "../rounding.js";
import { RADIANS } from "../sampling.js";
import { say } from "../words.js";
import { AnalysisKernel } from "./analysis_kernel.js";
import { brokenText } from "./broken.js";
import { factRowsOf } from "./fact_rows.js";
import { History } from "./history.js";
import { EditOverlay } from "./overlay.js";
import { EditPanel } from "./panel.js";
import { mechanismJoints, problemFields } from "./problem_model.js";
import { problemToml } from "../toml.js";

export class AnalysisEditor {
  // `page`: problem, drive() in degrees, driving() the sweep of what is drawn, show(data, problem, drive), which draws
  // everything, the analysis of the file for null, and move(mechanism, drive), which draws a motion alone.
  constructor(page) {
    this.page = page;
    this.toggle = element("button", { type: "button", class: "edit-toggle", "aria-pressed": "false", title: say("edit.toggle.title") }, say("edit.toggle"));
    this.toggle.addEventListener("click", () => (this.panel ? this.close() : this.begin()));
    document.querySelector("#stage .card-head").append(this.toggle);
  }

  async begin() {
    AnalysisEditor.kernel ??= await AnalysisKernel.load();
    if (this.panel) return;
    const first = this.page.problem;
    this.history = new History(first);
    this.before = AnalysisEditor.kernel.whole(first);
    this.joints = mechanismJoints(first.mechanism);
    this.panel = new EditPanel(problemFields(first), { field: (field, value) => this.#type(field, value), toml: () => this.toml, title: () => this.title,
      undo: () => this.#step("undo"), redo: () => this.#step("redo"), reset: () => this.#settle(this.history.states[0]) });
    this.overlay = new EditOverlay(byId("picture"), Object.keys(this.joints), { begin: () => this.#take(), drag: (name, to) => this.#drag(name, to), end: () => this.#letGo() });
    document.querySelector(".side").prepend(this.panel.root);
    this.#press(true);
    this.#take(first, this.before);
    this.ghost = this.now.mechanism.points.find((point) => point.moves && !point.isPin)?.path.filter(Boolean) ?? [];
    this.page.show(this.before, first, this.page.drive());
    this.#refresh();
  }

  close() {
    this.panel.root.remove();
    this.overlay.remove();
    Object.assign(this, { panel: undefined, overlay: undefined });
    this.#press(false);
    this.page.show(null, this.page.problem, this.page.drive());
  }

  #press(on) {
    this.toggle.setAttribute("aria-pressed", String(on));
    byId("main").classList.toggle("editing", on);
    byId("main").classList.remove("dragging");
  }

  #take(problem = this.now.problem, data = this.now.data) {
    const mechanism = data === this.now?.data ? this.now.mechanism : new Mechanism(data.mechanism, data.drive ?? this.page.driving());
    this.now = { problem, data, mechanism };
    this.taken = { ...this.now, at: this.#points(), places: mechanism.places(this.page.drive()) };
  }

  // What the kernel says of a problem, its motion alone while it is dragged; null where it is refused, and why.
  #evaluate(problem, whole) {
    const data = whole ? AnalysisEditor.kernel.whole(problem) : AnalysisEditor.kernel.motion(problem);
    const assembles = !data.faults && data.mechanism.bodies.slice(1).every((body) => [body.x].flat().some((x) => x !== null));
    this.panel.say(assembles ? "" : data.faults?.join(say("list.semicolon")) ?? brokenMechanism(problem.mechanism));
    return assembles ? data : null;
  }

  // The handles, where the picture is.
  place(view) {
    if (this.panel && view) this.overlay.move(view, this.#points(), this.ghost ?? []);
  }

  // Where the named points stand.
  #points() {
    const { mechanism } = this.now;
    const places = mechanism.places(this.page.drive());
    return Object.fromEntries(mechanism.points.map(({ name, body, at }) => [name, Mechanism.point(places[body], at)]));
  }

  #drag(name, to) {
    const { problem, at, places, mechanism } = this.taken;
    const joint = this.joints[name];
    if (!Object.values(at).every(Boolean)) return;
    const body = mechanism.bodies.findIndex((b) => b.name === joint.on);
    const centre = at[joint.about ?? "A"];
    const drive = joint.turns ? Math.atan2(to[1] - centre[1], to[0] - centre[0]) / RADIANS : this.page.drive();
    const edited = { ...problem, mechanism: tableWithoutRounding(joint.drag(problem.mechanism, at, to, places[body])) };
    const data = this.#evaluate(edited, false);
    if (!data) return;
    this.now = { problem: edited, data: null, mechanism: new Mechanism(data.mechanism, this.page.driving()) };
    byId("main").classList.add("dragging");
    this.page.move(this.now.mechanism, drive);
    this.#refresh(data.facts);
  }

  #letGo() {
    if (this.now.problem !== this.history.present) this.#settle(this.now.problem);
  }

  // Everything of a problem, which becomes the present one.
  #settle(problem) {
    if (this.#show(problem)) this.history.push(problem);
    this.#refresh();
  }

  #show(problem) {
    const data = this.#evaluate(problem, true);
    if (!data) return false;
    byId("main").classList.remove("dragging");
    this.page.show(data, { ...problem, title: this.title }, this.page.drive());
    this.now = { problem, data, mechanism: this.page.mechanism() };
    this.place(this.overlay.view);
    return true;
  }

  #refresh(facts = this.now.data?.facts ?? this.before.facts) { this.panel.show(this.now.problem, this.history, factRowsOf(this.before.facts, facts), []); }

  #type(field, value) {
    if (Number.isFinite(value)) return this.#settle(field.set(this.now.problem, value));
    this.panel.say(say("edit.number"));
    return this.#refresh();
  }

  #step(sense) {
    this.history[sense]();
    this.#show(this.history.present);
    this.#refresh();
  }

  get title() { return say("edit.file.title", { title: this.page.problem.title || say("head.untitled") }); }

  // The problem of the page as it is now.
  get toml() { return problemToml({ ...this.now.problem, title: this.title }); }
}

const brokenMechanism = (table) => (table.type === "four-bar" ? brokenText(table) : say("edit.nowhere"));
