// A design that was pinned: it stays in the picture as a ghost while others are looked at.

import { element, svg } from "./dom.js";
import { legendItem, pathThrough, pathWithGaps } from "./shapes.js";
import { say } from "./words.js";

export class Pinned {
  // `head`: where the button goes that pins, and lets go; `present()`: the design to pin, its `name`, and `at(drive)`:
  // its lines in the plane, each a list of points, and its curve.
  constructor(head, present, onChange) {
    Object.assign(this, { name: "pinned", words: "pin", silent: true, root: svg("g", { class: "pinned" }), design: null });
    this.button = element("button", { type: "button", class: "pin-toggle", id: "pin", "aria-pressed": "false", title: say("pin.title") }, say("pin"));
    this.button.addEventListener("click", () => {
      this.design = this.design ? null : present();
      this.button.setAttribute("aria-pressed", String(this.design !== null));
      this.button.textContent = this.design ? say("pin.of", { name: this.design.name }) : say("pin");
      onChange(this.design !== null);
    });
    head.append(this.button);
  }

  available(scene) { return Boolean(scene.view) && this.design !== null; }

  build() {
    this.line = svg("path", { class: "pinned-line" });
    this.curve = svg("path", { class: "pinned-curve" });
    this.root.replaceChildren(this.curve, this.line);
  }

  move({ view }, drive) {
    const { lines, curve } = this.design.at(drive);
    this.line.setAttribute("d", lines.map((points) => pathThrough(points.map((p) => view.screen(p)))).join(""));
    this.curve.setAttribute("d", pathWithGaps(curve.map((p) => p && view.screen(p))));
  }

  legend() { return [legendItem("pinned", "dashed", say("pin.legend", { name: this.design.name }))]; }
}
