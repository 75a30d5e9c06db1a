// Editing a problem by its numbers: every change is evaluated by the program's own evaluator, and everything on
// the page follows.

import { byId, element } from "../dom.js";
import { markOriginal } from "../original.js";
import { say } from "../words.js";
import { History } from "./history.js";
import { EditPanel } from "./panel.js";
import { ProblemKernel } from "./problem_kernel.js";
import { problemToml } from "../toml.js";

export class TableEditor {
  // `page`: call, that of the kernel; hint; kept, ids of the cards that do not follow; first(), the problem of the design
  // shown with all of it given; mayBeEmpty, where an answer may have no design; fields(problem); rows(before, now) of data;
  // checks(data); and show(data, problem), which draws everything, the design as it was found for null.
  constructor(page) {
    this.page = page;
    this.toggle = element("button", { type: "button", class: "edit-toggle", "aria-pressed": "false", title: say("edit.toggle.title") }, say("edit.toggle"));
    this.toggle.addEventListener("click", () => (this.panel ? this.close() : this.begin()));
    document.querySelector("#stage .card-head").append(this.toggle);
  }

  async begin() {
    TableEditor.kernel ??= await ProblemKernel.load();
    if (this.panel) return;
    const first = this.page.first();
    this.history = new History(first);
    this.before = this.#evaluate(first);
    if (this.before.faults) {  // a design at the edge of what a file may hold
      Object.assign(this.toggle, { disabled: true, title: this.before.faults.join(say("list.semicolon")) });
      return;
    }
    this.panel = new EditPanel(this.page.fields(first), { field: (field, value) => this.#type(field, value), slide: (field, value) => this.#slide(field, value), toml: () => this.toml, title: () => this.title,
      undo: () => this.#step("undo"), redo: () => this.#step("redo"), reset: () => this.#settle(this.history.states[0]) }, this.page.hint);
    document.querySelector(".side").prepend(this.panel.root);
    this.#press(true);
    this.#show(first);
  }

  // Ends without drawing the design found where the page draws another anyway.
  close(redraw = true) {
    if (!this.panel) return;
    this.panel.root.remove();
    this.panel = undefined;
    this.#press(false);
    if (redraw) this.page.show(null, this.page.problem);
  }

  #press(on) {
    this.toggle.setAttribute("aria-pressed", String(on));
    byId("main").classList.toggle("editing", on);
    markOriginal(this.page.kept, on);
  }

  // Evaluates a problem and draws what it gives; where the program would refuse it, says why and leaves the page.
  #show(problem) {
    const data = this.#evaluate(problem);
    this.panel.say(data.faults?.join(say("list.semicolon")) ?? "");
    if (data.faults) return false;
    this.now = { problem, data };
    this.page.show(data, { ...problem, title: this.title });
    this.refresh();
    return true;
  }

  #evaluate(problem) {
    try {
      const data = TableEditor.kernel.ask(this.page.call, withoutSlowTables(problem));
      return data.faults || this.page.mayBeEmpty || data.designs.length ? data : { faults: data.notes.length ? data.notes : [say("edit.no_design")] };
    } catch {
      ProblemKernel.load().then((kernel) => { TableEditor.kernel = kernel; });
      return { faults: [say("edit.failed")] };
    }
  }

  // The panel anew, where what is shown of the data has changed.
  refresh() {
    if (!this.panel) return;
    const { problem, data } = this.now;
    this.panel.show(problem, this.history, this.page.rows(this.before, data), this.page.checks(data));
  }

  // A problem that becomes the present one.
  #settle(problem) {
    if (this.#show(problem)) this.history.push(problem);
    this.refresh();
  }

  // What is shown while a slider moves, once for each picture; it is one change with where it stops.
  #slide(field, value) {
    if (!this.slid) requestAnimationFrame(() => { const { slid } = this; this.slid = null; if (slid && this.panel) this.#show(slid()); });
    this.slid = () => field.set(this.now.problem, value);
  }

  #type(field, value) {
    this.slid = null;
    if (Number.isFinite(value) || field.optional) return this.#settle(field.set(this.now.problem, Number.isFinite(value) ? value : undefined));
    this.refresh();
    return this.panel.say(say("edit.number"));
  }

  #step(sense) {
    this.history[sense]();
    this.#show(this.history.present);
  }

  get title() { return say("edit.file.title", { title: this.page.problem.title || say("head.untitled") }); }

  // The problem of the page as it is now.
  get toml() { return problemToml({ ...this.now.problem, title: this.title }); }
}

// What the kernel does not know: tolerances take longer than an edit may.
const withoutSlowTables = (problem) => ({ ...problem, tolerance: null });
