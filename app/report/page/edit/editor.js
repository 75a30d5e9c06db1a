// Editing a four-bar design: every change is evaluated by the kernel, and shown in place of the
// design as it was found.

import { byId } from "../dom.js";
import { Kernel } from "../kernel.js";
import { RADIANS } from "../sampling.js";
import { say } from "../words.js";
import { Design } from "../design/model.js";
import { tableWithoutRounding } from "../rounding.js";
import { brokenText } from "./broken.js";
import { editedFile } from "./edited_file.js";
import { measureOf } from "./errors.js";
import { FOUR_BAR_JOINTS, fourBarFields } from "./four_bar.js";
import { checkOf, specifiedChecks } from "./checks.js";
import { History } from "./history.js";
import { EditOverlay } from "./overlay.js";
import { EditPanel } from "./panel.js";
import { checkRow, editRows } from "./rows.js";

const EDIT_SAMPLES = 241;

export class Editor {
  // `page` as of DesignEditors; `found`: the design, `drawn` what the data of the page has of it.
  constructor(page, found, drawn) { Object.assign(this, { page, found, drawn }); }

  static edits(problem, { assembles, entry: { mechanism } }) { return assembles && mechanism.type === "four-bar"; }

  get open() { return this.panel !== undefined; }

  async load() { Editor.kernel ??= await Kernel.load(); }

  begin() {
    const { entry } = this.found;
    const { input_start_deg: input, output_start_deg: output } = entry.metrics;
    const first = withoutNoise({ mechanism: entry.mechanism, starts: input === undefined ? null : { input_deg: input, output_deg: output } });
    this.checks = [...(entry.constraints ?? []), ...specifiedChecks(this.page.problem)];
    this.measure = measureOf(this.page.problem, this.page.target, entry, this.drawn);
    this.history = new History(first);
    this.before = this.#evaluate(first);
    this.panel = new EditPanel(fourBarFields(first), { field: (field, value) => this.#type(field, value), toml: () => this.toml, title: () => this.title,
      undo: () => this.#step("undo"), redo: () => this.#step("redo"), reset: () => this.#reset() });
    const joints = Object.keys(FOUR_BAR_JOINTS).filter((name) => name !== "P" || entry.mechanism.coupler_point);
    this.overlay = new EditOverlay(byId("picture"), joints, { begin: () => this.#take(), drag: (name, to) => this.#drag(name, to), end: () => this.#letGo() });
    document.querySelector(".side").prepend(this.panel.root);
    this.#show(this.before);
    this.page.settle();
  }

  close() {
    this.panel.root.remove();
    this.overlay.remove();
    Object.assign(this, { panel: undefined, overlay: undefined, shown: undefined });
  }

  // What the kernel says of a state; null where its links cannot be assembled.
  #evaluate(state) {
    const { kernel } = Editor;
    const { mechanism } = state;
    if (!kernel.take(mechanism)) return null;
    const measured = this.measure.evaluate(kernel, state);
    const { stations, travel, sequence, error, angular, gap, drawn } = measured;
    const facts = kernel.facts(stations, travel, sequence);
    if (gap && !facts.defects.includes("circuit")) facts.defects.push("circuit");
    const motion = kernel.motion(stations, EDIT_SAMPLES);
    if (motion.crank_deg.length < 2) return null;
    const swing = Math.max(...motion.rocker_deg) - Math.min(...motion.rocker_deg);
    const entry = this.#entry({ state, mechanism, facts, swing, error, angular, stations });
    const guided = this.drawn.guided && this.#guided(stations, mechanism);
    const design = new Design(entry, { ...this.drawn, motion, deviation: null, guided, ...drawn }, this.page.target);
    return { state, mechanism, facts, swing, error, angular, motion, design };
  }

  // The entry of a result that the state would have, as far as the kernel knows it.
  #entry({ state: { starts }, mechanism, facts, swing, error, angular, stations }) {
    const { entry } = this.found;
    const kept = Object.fromEntries(Object.entries(entry.metrics).filter(([key]) => /^body_angle/.test(key)));
    const constraints = this.checks.map((check) => {
      const found = checkOf(check, { mechanism, facts, swing, starts });
      return { ...check, value: found ? found.value : null, satisfied: found ? found.met : null };
    });
    const figures = error && { ...error, ...(angular ? { max_deg: error.max / RADIANS, rms_deg: error.rms / RADIANS } : {}) };
    return { ...entry, mechanism, constraints, error: figures, warnings: [], crank_deg: stations.map((angle) => angle / RADIANS),
      metrics: { ...kept, ...metricsOf(facts), ...(starts ? { input_start_deg: starts.input_deg, output_start_deg: starts.output_deg } : {}) } };
  }

  // The guided body, where it is the coupler.
  #guided(stations, { coupler_point: axes }) {
    const { guided } = this.drawn;
    if (guided.body !== 2) return null;
    const reached = Editor.kernel.poses(stations).map((pose) => pose && [...pose.b, Math.atan2(pose.c[1] - pose.b[1], pose.c[0] - pose.b[0]) / RADIANS]);
    return { ...guided, reached, axes: axes ? [...axes, guided.axes[2]] : guided.axes };
  }

  // Evaluates `state` and shows it; where it cannot be assembled, says why and leaves the picture.
  #try(state, crank) {
    const evaluated = this.#evaluate(state);
    if (!evaluated) {
      this.panel.say(brokenText(state.mechanism));
      return false;
    }
    this.panel.say("");
    this.#show(evaluated, crank);
    return true;
  }

  #show(evaluated, crank) {
    this.now = evaluated;
    const { design, state } = evaluated;
    design.boxes = this.found.boxes;
    this.shown = design;
    this.page.follow(design);
    this.page.redraw(crank);
    this.panel.show(state, this.history, editRows(this.before, evaluated), this.checks.map((check) => checkRow(check, evaluated)));
  }

  // The handles, where the picture is.
  place(view, pose) {
    if (!this.open || !view) return;
    const { mechanism } = this.now;
    const places = Object.fromEntries(Object.entries(FOUR_BAR_JOINTS).map(([name, joint]) => [name, joint.at(mechanism, pose)]));
    this.overlay.move(view, places, this.found.linkage.point ? this.found.linkage.poses.map((p) => p.p) : []);
  }

  #take() {
    Editor.kernel.take(this.now.mechanism);
    this.taken = { mechanism: this.now.mechanism, pose: Editor.kernel.poses([this.page.crank() * RADIANS])[0] };
  }

  #drag(name, to) {
    const { mechanism, pose } = this.taken ?? {};
    if (!pose) return;
    const joint = FOUR_BAR_JOINTS[name];
    const crank = joint.moves === "crank" ? Math.atan2(to[1] - mechanism.fixed_pivots[0][1], to[0] - mechanism.fixed_pivots[0][0]) / RADIANS : undefined;
    this.#try(withoutNoise({ ...this.now.state, mechanism: joint.drag(mechanism, pose, to) }), crank);
  }

  #letGo() {
    this.taken = null;
    this.#settle(this.now.state);
  }

  #settle(state) {
    this.history.push(state);
    this.panel.show(state, this.history, editRows(this.before, this.now), this.checks.map((check) => checkRow(check, this.now)));
    this.page.settle();
  }

  #type(field, value) {
    const { state } = this.now;
    if (!Number.isFinite(value) || (field.positive && !(value > 0))) {
      this.panel.say(say(field.positive ? "edit.positive" : "edit.number"));
      this.panel.show(state, this.history, editRows(this.before, this.now), []);
      return;
    }
    const next = field.set(state, value);
    if (this.#try(next)) this.#settle(next);
  }

  #step(sense) {
    this.history[sense]();
    this.#try(this.history.present);
    this.page.settle();
  }

  #reset() {
    const [first] = this.history.states;
    this.#try(first);
    this.#settle(first);
  }

  get title() { return say("edit.file.title", { title: this.page.problem.title || say("head.untitled") }); }

  get toml() {
    const { mechanism, starts } = this.now.state;
    return editedFile(this.page.problem, this.title, mechanism, starts && { input: starts.input_deg, output: starts.output_deg });
  }
}

const metricsOf = ({ class: name, changePoint, least, greatest, acute, timeRatio, defects }) => ({ class: name, change_point: changePoint, time_ratio: timeRatio, defects,
  transmission_angle_deg: { min: least / RADIANS, max: greatest / RADIANS, acute_min: acute / RADIANS } });

// A state as it is copied: to twelve digits of its size.
const withoutNoise = ({ mechanism, starts }) => ({ mechanism: tableWithoutRounding(mechanism), starts: starts && tableWithoutRounding(starts) });
