// The coupler curves of the rows that pass, those of one linkage together as in the atlas of Hrones
// and Nelson (1951), unless nearly each linkage has but one.

import { byId, element, svg } from "../dom.js";
import { number } from "../format.js";
import { pathThrough, round } from "../shapes.js";
import { boxOf, SCALE_ROOM, View } from "../view.js";
import { language, say, term } from "../words.js";

const ATLAS = { curves: 60, samples: 96, width: 132, height: 104 };

export class Atlas {
  // `actions.select(row)`; `linkageOf(row)`: its RowLinkage.
  constructor(study, linkageOf, actions) {
    Object.assign(this, { study, linkageOf, actions, page: 0, slow: true, holder: byId("curves-of-linkages") });
    this.pager = new Pager(byId("atlas"), (page) => { this.page = page; this.draw(); });
  }

  filtered() {
    const groups = new Map();
    for (const row of this.study.filters.rows) {
      const { dimensions, lengths, closes } = this.linkageOf(row);
      if (!closes) continue;
      const key = [...lengths.map((l) => l.toPrecision(6)), dimensions.assembly].join(" ");
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(row);
    }
    this.alone = groups.size > 0.5 * this.study.filters.rows.length;
    this.pages = pagesOf([...groups.values()], this.alone ? ATLAS.curves / 2 : ATLAS.curves);
    this.page = 0;
    this.draw();
  }

  draw() {
    this.pager.show(this.page, this.pages.length);
    this.holder.replaceChildren(...(this.pages[this.page] ?? []).flatMap((group) => this.#group(group)));
    this.select();
  }

  // One linkage: its lengths as multiples of the crank's, and a curve for each of its points.
  #group(rows) {
    const linkage = this.linkageOf(rows[0]);
    const [crank, ...others] = linkage.lengths;
    const [coupler, rocker, frame] = others.map((length) => number(length / crank, 4));
    const curves = rows.map((row) => this.#curve(row));
    if (this.alone) return curves;
    const overview = new Overview(linkage, rows.map((row) => ({ row, linkage: this.linkageOf(row) })), this.study.paint);
    for (const button of curves) {
      for (const [kind, shown] of [["pointerenter", true], ["focus", true], ["pointerleave", false], ["blur", false]]) button.addEventListener(kind, () => overview.lift(Number(button.dataset.row), shown));
    }
    return [element("h3", {}, say("atlas.ratios", { coupler, rocker, frame }),
      element("span", { class: "muted" }, ` ${say("atlas.about", { assembly: term(linkage.dimensions.assembly), curves: say("count.curves", { n: rows.length }) })}`)),
      element("div", { class: "curves-of-one" }, overview.root, ...curves)];
  }

  #curve(row) {
    const linkage = this.linkageOf(row);
    const points = linkage.poses(ATLAS.samples).map((pose) => pose.p);
    const view = new View(boxOf(points), ATLAS.width, ATLAS.height + SCALE_ROOM, 12);
    const pivots = [linkage.closure.a, linkage.closure.d].map((p) => view.screen(p));
    const drawing = svg("svg", { viewBox: `0 0 ${ATLAS.width} ${ATLAS.height}`, "aria-hidden": "true" },
      svg("path", { d: pathThrough(points.map((p) => view.screen(p))), style: `stroke:${this.study.paint.of(row)}` }),
      ...pivots.map(([x, y]) => svg("circle", { cx: round(x), cy: round(y), r: 2.5 })));
    const [u, v] = linkage.dimensions.coupler_point.map((x) => number(x, 3));
    const button = element("button", { type: "button", "data-row": row, "aria-label": say("atlas.curve", { n: this.study.ids[row] }), title: say("atlas.curve_title", { n: this.study.ids[row], u, v }) },
      drawing, element("span", {}, this.alone ? this.study.ids[row].toLocaleString(language) : `${u}, ${v}`));
    button.addEventListener("click", () => this.actions.select(row));
    return button;
  }

  select() {
    for (const button of this.holder.querySelectorAll("[data-row]")) button.setAttribute("aria-pressed", String(Number(button.dataset.row) === this.study.selected));
  }
}

// The sample at which an overview shows its linkage.
const SHOWN = 16;

// A linkage with the curves of all its coupler points.
class Overview {
  constructor(linkage, rows, paint) {
    const motions = rows.map(({ linkage: own }) => own.poses(ATLAS.samples));
    const curves = rows.map(({ row }, i) => ({ row, points: motions[i].map((pose) => pose.p) }));
    const { b, c } = motions[0][SHOWN];
    const { a, d } = linkage.closure;
    const [width, height] = [2 * ATLAS.width + 8, 2 * ATLAS.height + 40];
    const view = new View(boxOf([a, b, c, d, ...curves.flatMap(({ points }) => points)]), width, height + SCALE_ROOM, 14);
    const line = (points) => pathThrough(points.map((p) => view.screen(p)));
    this.lines = new Map(curves.map(({ row, points }) => [row, svg("path", { d: `${line(points)}Z`, style: `stroke:${paint.of(row)}` })]));
    const at = curves.map(({ points }) => view.screen(points[SHOWN]));
    this.root = svg("svg", { class: "overview", viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": say("atlas.overview") }, ...this.lines.values(),
      svg("path", { class: "links", d: line([a, b, c, d]) }), ...at.map(([x, y]) => svg("circle", { class: "place", cx: round(x), cy: round(y), r: 1.8 })),
      ...[a, b, c, d].map((p) => view.screen(p)).map(([x, y]) => svg("circle", { class: "pin", cx: round(x), cy: round(y), r: 3 })));
  }

  // Brings the curve of a row to the fore.
  lift(row, lifted) { this.lines.get(row).classList.toggle("lifted", lifted); }
}

// Lists on pages of about `most` entries; long ones are cut.
function pagesOf(groups, most) {
  const pages = [[]];
  let room = most;
  for (const group of groups) {
    for (let i = 0; i < group.length; i += most) {
      const part = group.slice(i, i + most);
      if (part.length > room) { pages.push([]); room = most; }
      pages.at(-1).push(part);
      room -= part.length;
    }
  }
  return pages;
}

// The buttons of a card that turn its pages.
export class Pager {
  constructor(card, turn) {
    this.buttons = [...card.querySelectorAll("[data-step]")];
    this.where = card.querySelector("[data-where]");
    for (const button of this.buttons) button.addEventListener("click", () => turn(this.page + Number(button.dataset.step)));
  }

  show(page, pages) {
    this.page = page;
    for (const button of this.buttons) button.disabled = !(page + Number(button.dataset.step) in Array(pages).fill(0));
    this.where.textContent = pages > 1 ? say("pages.where", { page: page + 1, pages }) : "";
  }
}
