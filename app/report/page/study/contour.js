// The map of a column over two others, filled between its level lines.

import { byId, colour, element, svg } from "../dom.js";
import { number } from "../format.js";
import { interpolate, locate } from "../sampling.js";
import { round } from "../shapes.js";
import { say } from "../words.js";
import { Plane, tipLines } from "./axes.js";
import { d3Range } from "./filters.js";
import { keyBar, shadeAt } from "./paint.js";
import { binSurface, gridSurface, triangleSurface } from "./surface.js";

const LEVELS = 14;

export class Contour extends Plane {
  // `actions.select(row)`
  constructor(holder, study, actions) {
    super(holder, say("map.label"));
    Object.assign(this, { study, actions, held: new Map(), method: null, slow: true });
    this.root.addEventListener("click", (event) => { const row = this.#near(this.pointer(event)); if (row !== null) actions.select(row); });
    this.root.addEventListener("pointermove", (event) => this.#hover(this.pointer(event)));
    this.root.addEventListener("pointerleave", () => this.showTip([0, 0], null));
  }

  choose(z, x, y) {
    Object.assign(this, { z, x, y });
    const varied = this.study.columns.filter((c) => c.role === "variable" && !c.constant);
    this.others = varied.filter((c) => c !== x && c !== y);
    const onGrid = [x, y].every((c) => c.grid && c.grid.length > 1) && this.others.every((c) => c.grid);
    this.methods = [...(onGrid && x !== y ? ["grid"] : []), "triangles", "bins"];
    const usual = onGrid && x !== y ? "grid" : this.others.length && [x, y].every((c) => c.role === "variable") ? "bins" : "triangles";
    this.method = this.methods.includes(this.method) && this.picked ? this.method : usual;
    const start = this.study.selected ?? 0;
    this.held = new Map(onGrid ? this.others.map((c) => [c, c.values[start]]) : []);
    this.#choices();
    this.draw();
  }

  // Which methods there are, and where the other grid columns are held.
  #choices() {
    byId("methods").replaceChildren(...this.methods.map((method) => {
      const button = element("button", { type: "button", "data-method": method, "aria-pressed": String(method === this.method) }, say(`map.${method}`));
      button.addEventListener("click", () => { this.method = method; this.picked = true; this.#choices(); this.draw(); });
      return button;
    }));
    const held = this.method === "grid" ? [...this.held.keys()] : [];
    byId("held").replaceChildren(...held.map((column) => {
      const select = element("select", { "aria-label": say("map.held_at", { name: column.name }) }, ...column.grid.map((v, i) => element("option", { value: i }, number(v, 6))));
      select.value = column.grid.indexOf(this.held.get(column));
      select.addEventListener("change", () => { this.held.set(column, column.grid[Number(select.value)]); this.draw(); });
      return element("label", {}, `${say("map.at", { name: column.label })} `, select);
    }));
  }

  #surface() {
    const { x, y, z, study, method } = this;
    const { rows } = study.filters;
    if (method === "grid") return gridSurface(x, y, z, rows, this.held);
    return (method === "bins" ? binSurface : triangleSurface)(x, y, z, rows);
  }

  #note(surface, logarithmic) {
    const { method, others } = this;
    const parts = [say(`map.note_${method}${method === "grid" && surface.missing ? "_missing" : ""}`, { n: surface.missing ?? 0 }),
      ...(method !== "grid" && others.length ? [say("map.note_others", { n: others.length, list: others.map((c) => c.label).join(say("list.comma")) })] : []),
      ...(logarithmic ? [say("map.note_log")] : [])];
    byId("contour-note").textContent = parts.reduce((first, second) => say("map.note_join", { first, second }));
  }

  select() { this.draw(); }
  filtered() { this.draw(); }

  draw() {
    const brush = this.begin();
    const { x, y, z, study } = this;
    const surface = this.#surface();
    const known = surface.z.filter((v) => !Number.isNaN(v));
    const [least, greatest] = d3.extent(known);
    const logarithmic = least > 0 && greatest > 200 * least;
    const level = logarithmic ? Math.log10 : Number;
    [this.scaleX, this.scaleY] = [x.scale(this.across, 0.02), y.scale(this.up, 0.02)];
    if (known.length) {
      const share = (v) => (level(greatest) > level(least) ? (v - level(least)) / (level(greatest) - level(least)) : 0.5);
      const drawn = { ...surface, z: surface.z.map(level) };
      if (surface.cells || surface.nx < 4 || surface.ny < 4) this.#cells(brush, drawn, share);
      else this.#bands(brush, drawn, d3.extent(known.map(level)), share);
    }
    brush.restore();
    const at = (row) => [this.scaleX(x.values[row]), this.scaleY(y.values[row])].map(round);
    const visible = (row) => at(row).every(Number.isFinite) && [...(this.method === "grid" ? this.held : [])].every(([c, v]) => c.values[row] === v);
    const best = [...study.best].filter((row) => study.filters.passes[row] && visible(row)).map((row) => svg("circle", { class: "best-mark", cx: at(row)[0], cy: at(row)[1], r: 3.5 }));
    const chosen = study.selected !== null && visible(study.selected) ? [svg("circle", { class: "chosen", cx: at(study.selected)[0], cy: at(study.selected)[1], r: 8 })] : [];
    this.axes(x, this.scaleX, y, this.scaleY, ...best.slice(0, 400), ...chosen);
    byId("contour-key").replaceChildren(...(known.length ? keyBar(z.label, number(least, 4), number(greatest, 4), d3Range(12).map((i) => shadeAt(i / 11))) : [element("span", { class: "muted" }, say("map.none"))]));
    this.#note(surface, logarithmic);
  }

  // The screen's place of node `i` of `nodes`, linearly between them.
  #place(scale, nodes) {
    const places = nodes.map(scale);
    return (t) => interpolate(places, locate(d3Range(places.length), Math.min(places.length - 1, Math.max(0, t - 0.5))));
  }

  #bands(brush, { nx, ny, xs, ys, z }, [least, greatest], share) {
    const thresholds = [least, ...d3.ticks(least, greatest, LEVELS).filter((v) => v > least && v < greatest)];
    const [px, py] = [this.#place(this.scaleX, xs), this.#place(this.scaleY, ys)];
    const path = d3.geoPath(d3.geoTransform({ point(i, j) { this.stream.point(px(i), py(j)); } }), brush);
    const line = colour("--card");
    for (const [k, contour] of d3.contours().size([nx, ny]).thresholds(thresholds)(Array.from(z)).entries()) {
      const next = thresholds[k + 1] ?? greatest;
      brush.beginPath();
      path(contour);
      brush.fillStyle = shadeAt(share((contour.value + next) / 2));
      brush.fill();
      Object.assign(brush, { strokeStyle: line, lineWidth: 0.6, globalAlpha: 0.5 });
      brush.stroke();
      brush.globalAlpha = 1;
    }
  }

  #cells(brush, { nx, ny, xs, ys, z }, share) {
    const edges = (scale, nodes) => {
      const p = nodes.map(scale);
      const inner = p.slice(1).map((v, i) => (v + p[i]) / 2);
      return p.length > 1 ? [2 * p[0] - inner[0], ...inner, 2 * p.at(-1) - inner.at(-1)] : [p[0] - 40, p[0] + 40];
    };
    const [ex, ey] = [edges(this.scaleX, xs), edges(this.scaleY, ys)];
    for (let j = 0; j < ny; ++j) {
      for (let i = 0; i < nx; ++i) {
        if (Number.isNaN(z[j * nx + i])) continue;
        brush.fillStyle = shadeAt(share(z[j * nx + i]));
        brush.fillRect(ex[i], ey[j], ex[i + 1] - ex[i] + 0.6, ey[j + 1] - ey[j] - 0.6);
      }
    }
  }

  // Of the rows shown that which is nearest to a place of the picture.
  #near(p) {
    if (!this.inside(p)) return null;
    const held = this.method === "grid" ? [...this.held] : [];
    let [nearest, least] = [null, Infinity];
    for (const row of this.study.filters.rows) {
      const away = Math.hypot(this.scaleX(this.x.values[row]) - p[0], this.scaleY(this.y.values[row]) - p[1]);
      if (away < least && held.every(([c, v]) => c.values[row] === v)) [nearest, least] = [row, away];
    }
    return nearest;
  }

  #hover(p) {
    const row = this.#near(p);
    this.root.style.cursor = row === null ? "" : "pointer";
    this.showTip(p, row === null ? null : tipLines(this.study, row, [this.x, this.y, this.z]));
  }
}
