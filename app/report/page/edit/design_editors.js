// The button that edits the design shown, and the editor of its mechanism, which begins once it is loaded, or says why
// it cannot.

import { byId, element } from "../dom.js";
import { markOriginal } from "../original.js";
import { say } from "../words.js";
import { Editor } from "./editor.js";
import { MechanismEditor } from "./mechanism_editor.js";

const KEPT_CARDS = ["choice", "notes", "families", "findings", "work", "tolerances", "layers", "bill", "front", "raster"];

export class DesignEditors {
  // `page`: problem, target, crank() of the drive, redraw(crank) of the picture, follow(design) of what is said of it,
  // and settle() of what is drawn once a change is done.
  constructor(page) {
    this.page = page;
    this.toggle = element("button", { type: "button", class: "edit-toggle", "aria-pressed": "false" }, say("edit.toggle"));
    this.toggle.addEventListener("click", () => (this.editor.open ? this.#close() : this.#begin()));
    document.querySelector("#stage .card-head").append(this.toggle);
  }

  // The design as it is edited, where one is.
  get shown() { return this.editor?.shown; }

  // Turns to another design; one that is edited is left as it was found.
  choose(design, drawn) {
    if (this.editor?.open) this.#leave();
    const Kind = [Editor, MechanismEditor].find((kind) => kind.edits(this.page.problem, design));
    this.editor = Kind && new Kind(this.page, design, drawn);
    Object.assign(this.toggle, { hidden: !Kind, disabled: false, title: say("edit.toggle.title") });
  }

  place(view, pose) { this.editor?.place(view, pose); }

  async #begin() {
    const { editor } = this;
    await editor.load();
    if (editor !== this.editor || editor.open) return;
    this.#press(true);
    const refusal = editor.begin();
    if (!refusal) return;
    this.#press(false);
    Object.assign(this.toggle, { disabled: true, title: refusal });
  }

  #leave() {
    this.editor.close();
    this.#press(false);
  }

  #close() {
    this.#leave();
    this.page.follow(this.editor.found);
    this.page.settle();
  }

  #press(on) {
    this.toggle.setAttribute("aria-pressed", String(on));
    byId("main").classList.toggle("editing", on);
    markOriginal(KEPT_CARDS, on);
  }
}
