// Extra layers of a picture, each switched on and off by a button below it.

import { element, svg } from "./dom.js";
import { shortcut } from "./keys.js";
import { round } from "./shapes.js";
import { say } from "./words.js";

export class Extras {
  // `layers`: each (a silent one is switched on elsewhere) with its `name`, `words` (key of its text), `root`, `available(scene)`, and
  // `build(scene)`, `move(scene, drive)`; `holder`: where the buttons go.
  constructor(holder, layers) {
    Object.assign(this, { layers, shown: new Set(), hint: svg("g", { class: "hint" }) });
    this.buttons = new Map(layers.map((layer) => [layer, this.#button(layer)]));
    holder.append(...this.buttons.values());
  }

  #button(layer) {
    const button = element("button", { type: "button", "data-extra": layer.name, "aria-pressed": "false", hidden: "" }, say(layer.words));
    button.addEventListener("click", () => this.toggle(layer));
    if (layer.key) shortcut([layer.key], layer.key, layer.words, () => !button.hidden && this.toggle(layer));
    return button;
  }

  toggle(layer, on = !this.shown.has(layer)) {
    if (on) this.shown.add(layer); else this.shown.delete(layer);
    this.buttons.get(layer).setAttribute("aria-pressed", String(on));
    this.#widen(layer, on);
    this.rebuilt(this.scene);
    if (this.drive !== undefined) this.move(this.drive);
    this.onToggle?.();
  }

  // What is switched on is seen whole, and the picture is as before when it is gone.
  #widen(layer, on) {
    const { scene } = this;
    if (!layer.places || !scene?.view) return;
    if (on ? scene.include(layer.places(scene)) : scene.camera.widened) {
      if (!on) {
        Object.assign(scene.camera, { factor: 1, shift: [0, 0], widened: false });
        scene.view.look(scene.camera);
        for (const other of this.shown) if (other.places && other.available(scene)) scene.include(other.places(scene));
      }
      this.redraw();
    }
  }

  // After a picture has been built.
  rebuilt(scene) {
    const fresh = scene !== this.scene;
    this.scene = scene;
    if (!scene.view) return;
    for (const layer of this.layers) {
      if (fresh && !layer.silent) this.buttons.get(layer).hidden = !layer.available(scene);
      const on = this.shown.has(layer) && layer.available(scene);
      layer.root.toggleAttribute("hidden", !on);
      if (layer.root instanceof SVGElement && layer.root.parentNode !== scene.front) scene.front.append(layer.root);
      if (on) layer.build(scene); else layer.clear?.();
    }
    scene.front.append(this.hint);
    this.hint.replaceChildren();
  }

  move(drive) {
    this.drive = drive;
    if (!this.scene?.view) return;
    for (const layer of this.shown) if (layer.available(this.scene)) layer.move(this.scene, drive);
  }

  // Where the points followed are at `drive`, while a curve is pointed at; null takes the marks away.
  point(drive) {
    const { scene, hint } = this;
    const places = drive === null || !scene?.view ? [] : scene.marksAt(drive).map((p) => scene.view.screen(p));
    hint.replaceChildren(...places.flatMap(([x, y]) => [7, 2].map((r) => svg("circle", { cx: round(x), cy: round(y), r, class: r > 4 ? "ring" : "spot" }))));
  }

  // Entries of the legend for what is shown.
  legend() { return [...this.shown].filter((layer) => this.scene && layer.available(this.scene)).flatMap((layer) => layer.legend?.() ?? []); }
}

// At most so many points are followed.
export const MOST_MARKS = 6;
