// The follower and what guides it, in pixels about the cam's centre, y down. `build` makes its parts,
// `move` places them.

import { set, svg } from "../dom.js";
import { barPath, groundSign, round } from "../shapes.js";

// A hatched bush beside a stem.
function bushPath(x, top, width, height) {
  let hatches = "";
  for (let y = top + 4; y <= top + height + 3; y += 7) hatches += `M${round(x)} ${round(y)}L${round(x + width)} ${round(Math.max(top, y - Math.abs(width)))}`;
  return svg("g", {}, svg("rect", { class: "bush", x: round(Math.min(x, x + width)), y: round(top), width: round(Math.abs(width)), height: round(height) }),
    svg("path", { class: "ground-hatch", d: hatches }));
}

// The coils of a spring between two heights.
function springPath(x, from, to, width) {
  const coils = 7;
  let d = `M${round(x)} ${round(from)}`;
  for (let i = 1; i < 2 * coils; ++i) d += `L${round(x + (i % 2 ? width : -width))} ${round(from + ((to - from) * i) / (2 * coils))}`;
  return `${d}L${round(x)} ${round(to)}`;
}

export class Follower {
  constructor(design, scale) {
    Object.assign(this, { design, scale, u: design.part * scale });
    this.back = svg("g", {});
    this.frame = svg("g", { class: "follower-frame" });
    this.front = svg("g", {});
    this.moving = [];
    if (design.kind.oscillating) this.#oscillating();
    else this.#translating();
    this.#rollers();
  }

  local([x, y]) { return [this.scale * x, -this.scale * y]; }

  // The heights of a translating follower's parts, in units of the plane, at displacement 0.
  static heights(design) {
    const { first, part, kind } = design;
    const collar = first.start + (kind.flat ? 0.5 * part : kind.knife ? 1.5 * part : Math.max(first.roller_radius, 0.5 * part) + 0.35 * part);
    const room = design.kind.closure === "force" ? 1.1 : 0.4;
    const bush = collar + first.highest + room * part;
    return { collar, bush, bushTop: bush + 1.3 * part, top: bush + 1.3 * part - first.lowest + 0.5 * part };
  }

  #translating() {
    const { design: { first, kind, breadth }, scale, u } = this;
    const heights = Follower.heights(this.design);
    const x = scale * first.offset;
    const y = (height) => -scale * height;
    const half = 0.36 * u;
    const group = svg("g", { class: "follower" });
    const foot = y(first.start) - (kind.knife ? 0.9 * u : 0);
    group.append(svg("rect", { class: "stem", x: round(x - half), y: round(y(heights.top)), width: round(2 * half), height: round(foot - y(heights.top)) }));
    if (kind.knife) group.append(svg("path", { class: "stem", d: `M${round(x)} ${round(y(first.start))}L${round(x - half)} ${round(foot)}H${round(x + half)}Z` }));
    if (kind.flat) this.#plates(group, x);
    if (kind.closure === "force") {
      group.append(svg("rect", { class: "collar", x: round(x - 2.1 * half), y: round(y(heights.collar) - 0.2 * u), width: round(4.2 * half), height: round(0.2 * u) }));
      this.spring = { path: svg("path", { class: "spring" }), x, half, heights };
      this.frame.append(this.spring.path);
    }
    for (const side of [-1, 1]) this.frame.append(bushPath(x + side * (half + 1.5), y(heights.bushTop), side * 0.55 * u, scale * (heights.bushTop - heights.bush)));
    this.front.append(group);
    this.moving.push((deg) => {
      const s = first.at("displacement", deg);
      set(group, { transform: `translate(0 ${round(-scale * s)})` });
      if (this.yoke) set(this.yoke, { transform: `translate(0 ${round(-scale * s)})` });
      if (this.spring) set(this.spring.path, { d: springPath(x, y(heights.collar + s) - 0.2 * u, y(heights.bush), 1.5 * half) });
    });
    if (breadth !== null && kind.flat) this.#yokeAbout(breadth);
    else if (this.design.second ?? this.design.far) this.#yokeTo(x, this.design.second ?? this.design.far);
  }

  // The plate whose lower side is the face.
  #plates(group, x) {
    const { design: { first }, scale, u } = this;
    const [low, high] = first.reaches.map((reach) => scale * reach);
    const [left, right] = [Math.min(low, x) - 0.45 * u, Math.max(high, x) + 0.45 * u];
    this.plate = [left, right];
    group.append(svg("rect", { class: "stem face", x: round(left), y: round(-scale * first.start - 0.42 * u), width: round(right - left), height: round(0.42 * u), rx: 2 }));
  }

  // The rod past the shaft to the other roller.
  #yokeTo(x, other) {
    const { first } = this.design;
    const far = this.local(other.centre(0));
    const near = this.local(first.centre(0));
    const lift = this.scale * first.at("displacement", 0);
    this.yoke = svg("g", { class: "follower" }, svg("path", { class: "stem", d: barPath([x, near[1] + lift], [far[0], far[1] + lift], 0.3 * this.u) }));
    this.back.append(this.yoke);
  }

  // The frame that carries a second face parallel to the first.
  #yokeAbout(breadth) {
    const { design: { first, radius }, scale, u } = this;
    const [top, foot] = [-scale * first.start, -scale * (first.start - breadth)];
    const width = Math.max(scale * radius + 0.3 * u, ...this.plate.map(Math.abs));
    const thick = 0.42 * u;
    this.yoke = svg("g", { class: "follower" }, svg("path", { class: "stem", "fill-rule": "evenodd",
      d: `M${round(-width - thick)} ${round(top - thick)}H${round(width + thick)}V${round(foot + thick)}H${round(-width - thick)}ZM${round(-width)} ${round(top)}H${round(width)}V${round(foot)}H${round(-width)}Z` }));
    this.back.append(this.yoke);
  }

  #oscillating() {
    const { design, scale, u } = this;
    const pivot = this.local(design.first.pivot);
    for (const body of design.bodies) {
      const group = svg("g", { class: "follower" });
      group.append(...(design.kind.flat ? this.#swingingFace(body) : design.kind.knife ? this.#swingingEdge(body) : [svg("path", { class: "stem", d: barPath([0, 0], [scale * body.arm, 0], 0.3 * u) })]));
      this.front.append(group);
      this.moving.push((deg) => {
        const { arm, normal } = body.arms(deg);
        const [a, b, c, d] = [arm[0], -arm[1], normal[0], -normal[1]].map((v) => v.toFixed(6));
        set(group, { transform: `matrix(${a} ${b} ${c} ${d} ${round(pivot[0])} ${round(pivot[1])})` });
      });
    }
    this.frame.append(svg("g", { transform: `translate(${pivot.map(round).join(" ")})` }, groundSign([0, 0])));
    this.front.append(svg("circle", { class: "pin", cx: round(pivot[0]), cy: round(pivot[1]), r: 4.5 }));
  }

  #swingingFace(body) {
    const { scale, u } = this;
    const [low, high] = body.reaches.map((reach) => scale * reach);
    const face = -scale * body.face_offset;
    const from = Math.min(low - 0.45 * u, 0);
    const plate = svg("rect", { class: "stem face", x: round(from), y: round(face), width: round(high + 0.45 * u - from), height: round(0.42 * u), rx: 2 });
    return [svg("path", { class: "stem", d: barPath([0, 0], [0, face + 0.2 * u], 0.4 * u) }), plate];
  }

  // An arm above its edge, which points to the cam.
  #swingingEdge(body) {
    const { scale, u } = this;
    const [tip, half, foot] = [scale * body.arm, 0.36 * u, 0.9 * u];
    return [svg("path", { class: "stem", d: barPath([0, 0], [tip, foot], 0.3 * u) }),
      svg("path", { class: "stem edge", d: `M${round(tip)} 0L${round(tip - half)} ${round(foot)}H${round(tip + half)}Z` })];
  }

  // Rollers roll: a mark on each shows how fast.
  #rollers() {
    const { design: { kind, contacts }, scale } = this;
    if (kind.flat || kind.knife) return;
    for (const body of contacts) {
      const r = scale * body.roller_radius;
      const spokes = svg("path", { class: "spokes", d: `M${round(-r)} 0H${round(r)}M0 ${round(-r)}V${round(r)}` });
      const roller = svg("g", { class: "roller" }, svg("circle", { r: round(r) }), spokes, svg("circle", { class: "roller-mark", cx: round(0.72 * r), r: round(Math.max(1.4, 0.11 * r)) }),
        svg("circle", { class: "pin", r: round(Math.min(4.5, 0.4 * r)) }));
      this.front.append(roller);
      this.moving.push((deg, turns) => {
        const p = this.local(body.centre(deg));
        set(roller, { transform: `translate(${p.map(round).join(" ")}) rotate(${round(-body.spin(deg, turns) % 360)})` });
      });
    }
  }

  move(deg, turns) { for (const move of this.moving) move(deg, turns); }
}
