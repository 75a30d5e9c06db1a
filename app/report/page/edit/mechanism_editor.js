// Editing an analysed mechanism: every change is evaluated by the kernel, and moves in the picture in
// place of the mechanism of the file. Tables and curves stay those of the file.

import { byId, element } from "../dom.js";
import { factName, factParts, factText } from "../fact_text.js";
import { Mechanism } from "../mechanism.js";
import { RADIANS } from "../sampling.js";
import { say } from "../words.js";
import { brokenText } from "./broken.js";
import { History } from "./history.js";
import { MechanismKernel } from "./mechanism_kernel.js";
import { mechanismFields, mechanismJoints } from "./mechanism_model.js";
import { EditOverlay } from "./overlay.js";
import { EditPanel } from "./panel.js";
import { problemToml } from "../toml.js";

const EDITED_SAMPLES = 181;

export class MechanismEditor {
  // `page`: problem, driving, drawn (the mechanism's motion), drive() in degrees, and show(mechanism,
  // drive), which draws a mechanism, the analysed one for null.
  constructor(page) {
    this.page = page;
    this.toggle = element("button", { type: "button", class: "edit-toggle", "aria-pressed": "false", title: say("edit.toggle.title") }, say("edit.toggle"));
    this.toggle.addEventListener("click", () => (this.panel ? this.close() : this.begin()));
    document.querySelector("#stage .card-head").append(this.toggle);
  }

  async begin() {
    MechanismEditor.kernel ??= await MechanismKernel.load();
    if (this.panel) return;
    const first = this.page.problem.mechanism;
    this.history = new History(first);
    this.before = this.#evaluate(first);
    this.joints = mechanismJoints(first);
    this.panel = new EditPanel(mechanismFields(first), { field: (field, value) => this.#type(field, value), toml: () => this.toml, title: () => this.title,
      undo: () => this.#step("undo"), redo: () => this.#step("redo"), reset: () => this.#settle(this.history.states[0]) });
    this.overlay = new EditOverlay(byId("picture"), Object.keys(this.joints), { begin: () => this.#take(), drag: (name, to) => this.#drag(name, to), end: () => this.#letGo() });
    this.ghost = this.before.mechanism.points.find((point) => point.moves && !point.isPin)?.path.filter(Boolean) ?? [];
    document.querySelector(".side").prepend(this.panel.root);
    this.#press(true);
    this.#show(this.before);
  }

  close() {
    this.panel.root.remove();
    this.overlay.remove();
    Object.assign(this, { panel: undefined, overlay: undefined });
    this.#press(false);
    this.page.show(null, this.page.drive());
  }

  #press(on) {
    this.toggle.setAttribute("aria-pressed", String(on));
    byId("main").classList.toggle("editing", on);
  }

  // What the kernel says of a table; null where it can be assembled nowhere.
  #evaluate(table) {
    const { kernel } = MechanismEditor;
    const { drawn, driving } = this.page;
    if (!kernel.takeMechanism(table, drawn.bodies.map((body) => body.name), driving.from, driving.to)) return null;
    const motion = kernel.mechanismMotion(EDITED_SAMPLES);
    if (!motion) return null;
    motion.bodies.forEach((body, i) => { body.name = drawn.bodies[i].name; });
    motion.points.forEach((point, i) => { point.name = drawn.points[i].name; });
    return { table, facts: kernel.mechanismFacts(), mechanism: new Mechanism({ ...motion, output: drawn.output }, driving) };
  }

  #try(table, drive = this.page.drive()) {
    const evaluated = this.#evaluate(table);
    this.panel.say(evaluated ? "" : brokenMechanism(table));
    if (evaluated) this.#show(evaluated, drive);
    return Boolean(evaluated);
  }

  #show(evaluated, drive = this.page.drive()) {
    this.now = evaluated;
    this.page.show(evaluated.mechanism, drive);
    this.panel.show(evaluated.table, this.history, factRowsOf(this.before.facts, evaluated.facts), []);
  }

  // The handles, where the picture has come to.
  place(view) {
    if (!this.panel || !view) return;
    this.overlay.move(view, this.#points(), this.ghost);
  }

  // Where the named points stand.
  #points() {
    const { mechanism } = this.now;
    const places = mechanism.places(this.page.drive());
    return Object.fromEntries(mechanism.points.map(({ name, body, at }) => [name, Mechanism.point(places[body], at)]));
  }

  #take() {
    const { table, mechanism } = this.now;
    this.taken = { table, at: this.#points(), places: mechanism.places(this.page.drive()) };
  }

  #drag(name, to) {
    const { table, at, places } = this.taken;
    const joint = this.joints[name];
    const body = this.page.drawn.bodies.findIndex((b) => b.name === joint.on);
    const drive = joint.turns ? Math.atan2(to[1] - at.A[1], to[0] - at.A[0]) / RADIANS : undefined;
    if (Object.values(at).every(Boolean)) this.#try(joint.drag(table, at, to, places[body]), drive);
  }

  #letGo() {
    this.history.push(this.now.table);
    this.#refresh();
  }

  #settle(table) {
    if (this.#try(table)) this.history.push(table);
    this.#refresh();
  }

  #refresh() { this.panel.show(this.now.table, this.history, factRowsOf(this.before.facts, this.now.facts), []); }

  #type(field, value) {
    if (Number.isFinite(value) && (!field.positive || value > 0)) return this.#settle(field.set(this.now.table, value));
    this.panel.say(say(field.positive ? "edit.positive" : "edit.number"));
    return this.#refresh();
  }

  #step(sense) {
    this.history[sense]();
    this.#try(this.history.present);
  }

  get title() { return say("edit.file.title", { title: this.page.problem.title || say("head.untitled") }); }

  // The problem of the page with the mechanism changed.
  get toml() { return problemToml({ ...this.page.problem, title: this.title, mechanism: this.now.table }); }
}

const brokenMechanism = (table) => (table.type === "four-bar" ? brokenText(table) : say("edit.nowhere"));

// The facts before and now, in the order of what there is now.
function factRowsOf(before, now) {
  const cell = (name, facts) => {
    const { value = null } = facts.find((fact) => fact.name === name) ?? {};
    return { value, text: factText(value, factParts(name).unit) };
  };
  return now.map(({ name }) => ({ key: name, label: factLabel(name), before: cell(name, before), now: cell(name, now) }));
}

const factLabel = (name) => { const { key, where } = factParts(name); return where ? say("edit.place_of", { name: factName(key) }) : factName(key); };
