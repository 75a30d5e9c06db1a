// The design of a row: all its values, its file, and its linkage in motion.

import { Controls } from "../controls.js";
import { byId, element, fact } from "../dom.js";
import { Extras } from "../extras.js";
import { degrees } from "../format.js";
import { Ghost, GHOSTS } from "../ghosts.js";
import { RADIANS } from "../sampling.js";
import { Saves } from "../saves.js";
import { Trace } from "../trace.js";
import { Vectors } from "../vectors.js";
import { say } from "../words.js";
import { Zoom } from "../zoom.js";
import { filledIn, RowLinkage, TURN } from "./linkage.js";
import { LinkageScene } from "./scene.js";

export class DesignPanel {
  // `actions.select(row)`
  constructor(data, study, actions) {
    Object.assign(this, { data, study, actions, phase: 0 });
    this.controls = new Controls((seconds) => this.turn((this.phase + (this.controls.player.pace * this.controls.player.speed * seconds * RADIANS))),
      (sense, large) => this.turn(this.phase + sense * (large ? 10 : 1) * RADIANS, true));
    this.scene = data.linkage ? new LinkageScene(byId("picture"), (phase) => this.turn(phase, true)) : null;
    byId("linkage").hidden = !this.scene;
    this.#place();
    this.extras = new Extras(byId("extras"), [new Trace(), new Vectors("velocity", "v"), new Vectors("acceleration", "c"), ...Object.keys(GHOSTS).map((ghost) => new Ghost(ghost, byId("ghosts")))]);
    this.extras.redraw = () => this.#draw();
    this.extras.onToggle = () => byId("legend").replaceChildren(...this.extras.legend());
    byId("drive").addEventListener("input", (event) => this.turn(Number(event.target.value) * RADIANS, true));
    for (const [id, by] of [["previous", -1], ["next", 1]]) byId(id).addEventListener("click", () => this.#step(by));
    for (const button of document.querySelectorAll("[data-copy]")) button.addEventListener("click", () => copy(button));
    if (this.scene) {
      new ResizeObserver(() => this.#draw()).observe(byId("picture"));
      new Zoom(byId("linkage"), byId("picture"), () => this.scene, () => this.#draw());
      let stood = 0;
      new Saves(byId("linkage"), byId("picture"), { title: () => data.study.title, go: (share) => { if (!share) stood = this.phase; this.turn(TURN * share, true); }, back: () => this.turn(stood) });
      this.controls.start();
    }
  }

  // Without a linkage to move, the row stands beside the scatter plot.
  #place() {
    if (this.scene) return;
    byId("scatter").classList.add("stage");
    byId("scatter").after(document.querySelector("#main > .side"));
  }

  #step(by) {
    const { rows } = this.study.filters;
    if (!rows.length) return;
    const place = rows.indexOf(this.study.selected);
    this.actions.select(rows[(Math.max(0, place) + by + rows.length) % rows.length]);
  }

  // The value of a varied key in the row chosen.
  value(variable, row = this.study.selected) { return this.study.columns[variable].values[row]; }

  linkageOf(row) { return this.data.linkage ? new RowLinkage(filledIn(this.data.linkage, (variable) => this.value(variable, row))) : null; }

  show() {
    const { selected: row, ids, best, columns } = this.study;
    byId("design-none").hidden = row !== null;
    byId("design-body").hidden = row === null;
    if (row === null) return;
    byId("design-title").textContent = `${say("row.design", { n: ids[row] })}${best.has(row) ? " ★" : ""}`;
    byId("design-values").replaceChildren(...columns.flatMap((column) => {
      const [name, value] = fact(column.label, column.text(row, 7), column.written(row));
      name.title = column.name;
      return [name, value];
    }));
    byId("design-command").textContent = `cognate export ${quoted(this.data.database ?? databaseName())} --row ${ids[row]}`;
    this.#showFile();
    this.#draw();
  }

  #showFile() {
    const { base } = this.data;
    byId("design-file").hidden = !base;
    if (!base) return;
    byId("design-text").replaceChildren(...base.pieces.flatMap((piece, i) => (i < base.variables.length
      ? [piece, element("mark", {}, String(this.value(base.variables[i])))] : [piece])));
  }

  #draw() {
    if (!this.scene || this.study.selected === null) return;
    this.scene.build(this.linkageOf(this.study.selected));
    this.extras.rebuilt(this.scene);
    this.turn(this.phase);
  }

  // Goes to a phase of the motion. `byHand` stops the clock.
  turn(phase, byHand = false) {
    if (byHand) this.controls.play(false);
    this.phase = phase - TURN * Math.floor(phase / TURN);
    if (!this.scene?.linkage) return;
    this.scene.move(this.phase);
    this.extras.move(this.phase);
    byId("drive").value = this.phase / RADIANS;
    const crank = this.scene.linkage.pose(this.phase)?.crank;
    byId("drive-value").textContent = crank === undefined ? "–" : degrees(crank - 360 * Math.floor(crank / 360), 1);
    byId("drive").setAttribute("aria-valuetext", byId("drive-value").textContent);
  }
}

// The database stands beside the report, under the study's name.
function databaseName() {
  const [, stem = "STUDY"] = /([^/\\]+)\.report\.html$/.exec(decodeURIComponent(location.pathname)) ?? [];
  return `${stem}.study.db`;
}

// A name as a shell takes it.
const quoted = (name) => (/^[\w.+-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`);

// Puts a text into the clipboard, or where that is refused selects it.
async function copy(button) {
  const source = byId(button.dataset.copy);
  try {
    await navigator.clipboard.writeText(source.textContent);
    button.textContent = say("row.copied");
    setTimeout(() => { button.textContent = say("row.copy"); }, 1500);
  } catch {
    getSelection().selectAllChildren(source);
  }
}
