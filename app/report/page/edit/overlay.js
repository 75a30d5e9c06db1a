// What editing lays over the picture: the curve as it was, and a handle on every joint that can be
// dragged. The picture below may be drawn anew while a handle is held.

import { set, svg } from "../dom.js";
import { pathThrough, round } from "../shapes.js";
import { say } from "../words.js";

export class EditOverlay {
  // `on`: begin() when a joint is taken, drag(name, point) as it goes, end() when it is let go.
  constructor(frame, names, on) {
    this.frame = frame;
    this.ghost = svg("path", { class: "edit-ghost" });
    this.root = svg("svg", { class: "edit-layer", role: "group", "aria-label": say("edit.joints") }, this.ghost);
    this.handles = new Map(names.map((name) => [name, this.#handle(name, on)]));
    this.root.append(...this.handles.values());
    frame.append(this.root);
  }

  #handle(name, on) {
    const handle = svg("circle", { class: "edit-handle", r: 11, tabindex: 0, role: "button", "data-joint": name, "aria-label": say("edit.joint", { name }) },
      svg("title", {}, say("edit.joint", { name })));
    const at = (event) => {
      const area = this.root.getBoundingClientRect();
      const scale = this.view.width / area.width;
      return this.view.plane([(event.clientX - area.left) * scale, (event.clientY - area.top) * scale]);
    };
    handle.addEventListener("pointerdown", (event) => { event.preventDefault(); event.stopPropagation(); handle.focus(); handle.setPointerCapture(event.pointerId); on.begin(); });
    handle.addEventListener("pointermove", (event) => { if (handle.hasPointerCapture(event.pointerId)) on.drag(name, at(event)); });
    handle.addEventListener("lostpointercapture", () => on.end());
    handle.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      const pixels = event.shiftKey ? 10 : 1;
      on.begin();
      on.drag(name, this.places[name].map((x, k) => x + (pixels * step[k]) / this.view.scale));
      on.end();
    });
    return handle;
  }

  // `places`: of each joint in the plane; `ghost`: the points of the curve as it was.
  move(view, places, ghost) {
    Object.assign(this, { view, places });
    set(this.root, { viewBox: `0 0 ${view.width} ${view.height}` });
    set(this.ghost, { d: ghost.length ? pathThrough(ghost.map((p) => view.screen(p))) : "" });
    for (const [name, handle] of this.handles) {
      handle.toggleAttribute("hidden", !places[name]);
      if (!places[name]) continue;
      const [x, y] = view.screen(places[name]);
      set(handle, { cx: round(x), cy: round(y) });
    }
  }

  remove() { this.root.remove(); }
}
