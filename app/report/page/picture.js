// The frame of a moving drawing: its view of the plane, its scale, and what can be dragged.

class Picture {
  // `onDrag` is called with the drive coordinate that a handle is dragged to.
  constructor(frame, label, onDrag) {
    this.frame = frame;
    this.root = svg("svg", { role: "img", "aria-label": label });
    frame.append(this.root);
    this.onDrag = onDrag;
  }

  // An empty picture of the part `box` of the plane; without one it says why there is none.
  clear(box, why) {
    const [width, height] = [this.frame.clientWidth || 600, this.frame.clientHeight || 420];
    this.root.replaceChildren();
    set(this.root, { viewBox: `0 0 ${width} ${height}` });
    this.view = box ? new View(box, width, height) : null;
    if (!box) this.root.append(svg("text", { x: width / 2, y: height / 2, class: "joint-name" }, why));
  }

  remove() { this.root.remove(); }

  scaleBar() {
    const { length, pixels } = this.view.scaleBar();
    const [x, y] = [14, this.view.height - 14];
    return svg("g", {}, svg("path", { class: "scale-line", d: `M${x} ${y - 4}v4h${round(pixels)}v-4` }),
      svg("text", { class: "scale-text", x: x + 2, y: y - 8 }, say("picture.scale", { n: length, length: number(length) })));
  }

  // `driveFor` turns a point of the plane into the drive coordinate, or null.
  listen(handle, driveFor) {
    const drag = (event) => {
      const area = this.root.getBoundingClientRect();
      const scale = this.view.width / area.width;
      const at = [(event.clientX - area.left) * scale, (event.clientY - area.top) * scale];
      const drive = driveFor(this.view.plane(at));
      if (drive !== null) this.onDrag(drive);
    };
    set(handle, { style: "touch-action: none" });
    handle.addEventListener("pointerdown", (event) => { event.preventDefault(); handle.setPointerCapture(event.pointerId); drag(event); });
    handle.addEventListener("pointermove", (event) => { if (handle.hasPointerCapture(event.pointerId)) drag(event); });
  }
}
