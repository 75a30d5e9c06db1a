// Editing a design that is no four-bar: every change is evaluated by the program's own reader and evaluator, and
// shown in place of the design as it was found.

import { MechanismDesign } from "../design/mechanism_design.js";
import { flatMetrics } from "../design/facts.js";
import { checkRows } from "../checks.js";
import { byId } from "../dom.js";
import { embedded } from "../embedded.js";
import { lengthText, squaresText } from "../fact_text.js";
import { degreesShort } from "../format.js";
import { Mechanism } from "../mechanism.js";
import { tableWithoutRounding } from "../rounding.js";
import { RADIANS } from "../sampling.js";
import { problemToml } from "../toml.js";
import { say } from "../words.js";
import { remark } from "./edited_file.js";
import { factRowsOf } from "./fact_rows.js";
import { givenProblem } from "./given_chain.js";
import { History } from "./history.js";
import { EditOverlay } from "./overlay.js";
import { EditPanel } from "./panel.js";
import { ProblemKernel } from "./problem_kernel.js";
import { mechanismJoints, problemFields } from "./problem_model.js";
import { defectsRow } from "./rows.js";

const MECHANISM_KERNEL = "mechanism-kernel";
const KINDS = ["path-generation", "function-generation", "leg"];

// Of metrics those that stand in rows of the panel: what it is called does not change.
const UNCHANGED = /^(topology|change_point)$/;

export class MechanismEditor {
  // `page` as of Editor; `found`: the design.
  constructor(page, found) { Object.assign(this, { page, found }); }

  // Whether the designs of a problem can be edited: those of a raster are on it, and may move their target; groups are
  // where they are drawn.
  static edits({ kind, raster }, { assembles, entry: { mechanism } }) {
    const ofDyads = mechanism.type === "chain" && mechanism.dyad.every(({ type }) => type !== "group");
    return KINDS.includes(kind) && assembles && ofDyads && !raster && embedded(MECHANISM_KERNEL).trim() !== "";
  }

  get open() { return this.panel !== undefined; }

  async load() { MechanismEditor.kernel ??= await ProblemKernel.load(embedded(MECHANISM_KERNEL)); }

  begin() {
    const first = { mechanism: tableWithoutRounding(this.found.entry.mechanism) };
    this.before = this.#evaluate(first);
    if (this.before.faults) return faultsText(this.before);
    this.joints = mechanismJoints(first.mechanism);
    this.history = new History(first);
    this.panel = new EditPanel(problemFields(first), { field: (field, value) => this.#type(field, value), toml: () => this.toml, title: () => this.title,
      undo: () => this.#step("undo"), redo: () => this.#step("redo"), reset: () => this.#settle(this.history.states[0]) });
    this.overlay = new EditOverlay(byId("picture"), Object.keys(this.joints), { begin: () => this.#take(), drag: (name, to) => this.#drag(name, to), end: () => this.#letGo() });
    document.querySelector(".side").prepend(this.panel.root);
    this.#show(this.before);
    this.page.settle();
    return "";
  }

  close() {
    this.panel.root.remove();
    this.overlay.remove();
    Object.assign(this, { panel: undefined, overlay: undefined, shown: undefined });
  }

  // The design of a state, or faults: sentences on why there is none.
  #evaluate(state) {
    const { entry, drawn, faults } = MechanismEditor.kernel.ask("design", withoutUnknownTables(this.#problem(state))) ?? { faults: [say("edit.targets_out_of_reach")] };
    if (faults) return { faults };
    const { topology } = this.found.entry.metrics;
    const design = new MechanismDesign({ ...entry, origin: this.found.entry.origin, metrics: { ...entry.metrics, topology } }, drawn, this.page.target);
    design.boxes = this.found.boxes;
    return { state, design };
  }

  #problem({ mechanism }) { return givenProblem({ ...this.page.problem, title: this.title }, mechanism, this.page.target.point); }

  // Evaluates a state and shows it; where there is no design of it, says why and leaves the picture.
  #try(state, drive) {
    const evaluated = this.#evaluate(state);
    this.panel.say(faultsText(evaluated));
    if (!evaluated.faults) this.#show(evaluated, drive);
    return !evaluated.faults;
  }

  #show(evaluated, drive) {
    this.now = evaluated;
    this.shown = evaluated.design;
    this.page.follow(this.shown);
    this.page.redraw(drive);
    this.#refresh();
  }

  #refresh() {
    this.panel.show(this.now.state, this.history, mechanismDesignRows(this.before.design, this.shown), checkRows(this.shown.entry.constraints));
  }

  // The handles, where the picture is.
  place(view, drive) {
    if (this.open && this.now && view) this.overlay.move(view, this.#points(drive), this.found.point?.path.filter(Boolean) ?? []);
  }

  // Where the named points stand.
  #points(drive) {
    const { mechanism } = this.shown;
    const places = mechanism.places(drive);
    return Object.fromEntries(mechanism.points.map(({ name, body, at }) => [name, Mechanism.point(places[body], at)]));
  }

  #take() { this.taken = { state: this.now.state, at: this.#points(this.page.crank()) }; }

  #drag(name, to) {
    const { state, at } = this.taken ?? {};
    if (!at || !Object.values(at).every(Boolean)) return;
    const joint = this.joints[name];
    const centre = at[joint.about];
    const drive = joint.turns ? Math.atan2(to[1] - centre[1], to[0] - centre[0]) / RADIANS : undefined;
    this.#try({ mechanism: tableWithoutRounding(joint.drag(state.mechanism, at, to)) }, drive);
  }

  #letGo() {
    this.taken = null;
    this.#keep();
  }

  // The state shown becomes the present one.
  #keep() {
    this.history.push(this.now.state);
    this.#refresh();
    this.page.settle();
  }

  #settle(state) { if (this.#try(state)) this.#keep(); else this.#refresh(); }

  #type(field, value) {
    if (Number.isFinite(value)) return this.#settle(field.set(this.now.state, value));
    this.#refresh();
    return this.panel.say(say("edit.number"));
  }

  #step(sense) {
    this.history[sense]();
    this.#try(this.history.present);
    this.page.settle();
  }

  get title() { return say("edit.file.title", { title: this.page.problem.title || say("head.untitled") }); }

  get toml() { return remark(say("edit.file.given")) + problemToml(this.#problem(this.now.state)); }
}

const faultsText = ({ faults = [] }) => faults.join(say("list.semicolon"));

const ERROR_ROWS = { max: "max", rms: "rms", sum: "sum_of_squares" };

// Errors, those of angles in degrees, then metrics.
function mechanismDesignRows(before, now) {
  const errors = Object.entries(ERROR_ROWS).map(([row, key]) => {
    const cell = ({ entry: { error } }) => {
      const degrees = error[`${key}_deg`];
      const angular = error.max_deg !== undefined;
      if (row === "sum") return { value: error[key], text: squaresText(error[key], 5, angular) };
      return angular ? { value: degrees, text: degreesShort(degrees, 5) } : { value: error[key], text: lengthText(error[key], 5) };
    };
    return { key: `error.${row}`, before: cell(before), now: cell(now) };
  });
  return [...errors, ...factRowsOf(...[before, now].map(rowMetrics)), defectsRow(before, now, ({ entry }) => entry.metrics.defects)];
}

const rowMetrics = ({ entry: { metrics } }) => flatMetrics(metrics).filter(([name, value]) => !UNCHANGED.test(name) && value !== null && !Array.isArray(value)).map(([name, value]) => ({ name, value }));

// What the kernel does not know: tolerances and layers take longer than an edit may.
function withoutUnknownTables(problem) {
  const { layers_max, ...constraints } = problem.constraints ?? {};
  return { ...problem, constraints, tolerance: null, layers: null };
}
