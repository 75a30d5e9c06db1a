// Hodographs: the curves that the tips of vectors draw, seen from their foot, with equal axes.

import { keySign } from "../curves.js";
import { byId, element, set, svg } from "../dom.js";
import { engineeringExponent, number, powerOfTen } from "../format.js";
import { quantile } from "../sampling.js";
import { arrowPath, pathWithGaps, round } from "../shapes.js";
import { boxOf, SCALE_ROOM, View } from "../view.js";
import { say } from "../words.js";
import { partName, unitText } from "./table.js";

const LOCUS_TITLES = { velocity: say("loci.velocity"), acceleration: say("loci.acceleration"), reactions: say("loci.reactions") };

export function lociSheets(table, parts, colours) {
  const sheets = Object.entries(LOCUS_TITLES).map(([quantity, title]) => ({ title, quantity,
    vectors: table.vectorsOf(quantity).filter((v) => v.at && parts.has(v.x.of)) }));
  sheets.push({ title: say("loci.shaking"), quantity: "reactions", vectors: table.vectorsOf("reactions").filter((v) => !v.at) });
  return sheets.filter((sheet) => sheet.vectors.length > 0).map((sheet) => {
    const lines = sheet.vectors.map((vector) => ({ vector, label: partName(vector.x.of), colour: colours.get(vector.x.of),
      points: vector.x.values.map((x, i) => (x === null || vector.y.values[i] === null ? null : [x, vector.y.values[i]])) }));
    const sizes = lines.flatMap((line) => line.points.filter(Boolean).map((p) => Math.hypot(...p)));
    const exponent = engineeringExponent(Math.max(0, ...sizes));
    return { ...sheet, lines, exponent, cut: cutOf(sizes), unit: unitText(sheet.vectors[0].x.unit) };
  });
}

// Beyond this size a locus leaves its plot: as far as it goes, unless a pole dwarfs all else.
export function cutOf(sizes) {
  const usual = quantile(sizes, 0.93);
  const most = quantile(sizes, 1);
  return usual > 0 && most > 12 * usual ? 3 * usual : most;
}

export class Loci {
  constructor(holder, table) {
    Object.assign(this, { holder, table, plots: [] });
    new ResizeObserver(() => { if (this.sheets) this.build(this.sheets); }).observe(holder);
  }

  build(sheets) {
    const width = this.holder.clientWidth;
    if (this.sheets === sheets && this.width === width) return;
    Object.assign(this, { sheets, width });
    this.holder.replaceChildren();
    byId("loci-title").textContent = say(sheets.some(({ quantity }) => quantity === "reactions") ? "loci.title" : "loci.hodographs");
    // All boxes first, so that each has its width before it is drawn.
    this.plots = sheets.map((sheet) => [sheet, this.#box(sheet)]).map(([sheet, root]) => this.#plot(sheet, root));
    if (this.drive !== undefined) this.move(this.drive);
  }

  #box(sheet) {
    const unit = sheet.exponent ? `${powerOfTen(sheet.exponent)} ${sheet.unit}` : sheet.unit;
    const root = svg("svg", { role: "img", class: "locus", "aria-label": say("loci.label", { title: sheet.title, list: sheet.lines.map((l) => l.label).join(say("list.comma")) }) });
    const legend = element("div", { class: "keys" }, ...sheet.lines.map((line) => element("span", {}, keySign(line), line.label)));
    this.holder.append(element("div", { class: "plot" }, element("h3", {}, say("unit.axis", { name: sheet.title, unit })), legend, root));
    return root;
  }

  #plot(sheet, root) {
    const [width, height] = [root.clientWidth || 320, root.clientHeight || 300];
    set(root, { viewBox: `0 0 ${width} ${height}` });
    const tips = sheet.lines.flatMap((line) => line.points.filter((p) => p && Math.hypot(...p) <= 1.0001 * sheet.cut));
    const view = new View(padBox(boxOf([[0, 0], ...tips])), width, height + SCALE_ROOM, 34);
    root.append(this.#axes(view, sheet, width, height));
    const clip = `clip-${byId("loci").querySelectorAll("svg").length}`;
    root.append(svg("clipPath", { id: clip }, svg("rect", { width, height })));
    const curves = svg("g", { "clip-path": `url(#${clip})` });
    root.append(curves);
    const arrows = sheet.lines.map((line) => {
      curves.append(svg("path", { class: "locus-line", style: `stroke:var(${line.colour})`, d: pathWithGaps(line.points.map((p) => p && view.screen(p))) }));
      const arrow = svg("path", { class: "locus-arrow", style: `stroke:var(${line.colour})` });
      curves.append(arrow);
      return { line, arrow };
    });
    return { view, arrows };
  }

  // Grid and zero lines at round values.
  #axes(view, { exponent }, width, height) {
    const group = svg("g", {});
    const step = niceStep(Math.min(width, height) / view.scale / 5);
    const [[left, top], [right, bottom]] = [view.plane([0, 0]), view.plane([width, height])];
    const lines = (from, to) => Array.from({ length: Math.max(0, Math.floor(to / step) - Math.ceil(from / step) + 1) }, (_, i) => (Math.ceil(from / step) + i) * step);
    const text = (value) => number(value / 10 ** exponent, 6);
    for (const x of lines(left, right)) {
      const at = view.screen([x, 0])[0];
      group.append(svg("path", { class: x === 0 ? "zero" : "grid", d: `M${round(at)} 0V${height}` }));
      if (at > 16 && at < width - 16) group.append(svg("text", { class: "tick", x: round(at), y: height - 4, "text-anchor": "middle" }, text(x)));
    }
    for (const y of lines(bottom, top)) {
      const at = view.screen([0, y])[1];
      group.append(svg("path", { class: y === 0 ? "zero" : "grid", d: `M0 ${round(at)}H${width}` }));
      if (at > 12 && at < height - 22) group.append(svg("text", { class: "tick", x: 4, y: round(at - 3) }, text(y)));
    }
    return group;
  }

  move(drive) {
    this.drive = drive;
    for (const { view, arrows } of this.plots) {
      const foot = view.screen([0, 0]);
      for (const { line: { vector }, arrow } of arrows) {
        const [x, y] = [this.table.at(vector.x, drive), this.table.at(vector.y, drive)];
        set(arrow, { d: x === null || y === null ? "" : arrowPath(foot, [view.scale * x, -view.scale * y]) });
      }
    }
  }
}

// A box that is no mere line.
function padBox(box) {
  const least = 0.35 * Math.max(box.x1 - box.x0, box.y1 - box.y0, 1e-300);
  const widen = (low, high) => (high - low >= least ? [low, high] : [(low + high - least) / 2, (low + high + least) / 2]);
  const [[x0, x1], [y0, y1]] = [widen(box.x0, box.x1), widen(box.y0, box.y1)];
  return { x0, x1, y0, y1 };
}

function niceStep(wanted) {
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= wanted) ?? power;
}
