// What is brought along to a sketch: a curve out of an SVG file, or a picture to draw over.

import { byId, svg } from "../dom.js";
import { number } from "../format.js";
import { boxOf, diagonal } from "../view.js";
import { say } from "../words.js";
import { SHEET } from "./scene.js";

const SHEET_SHARE = 0.7;      // of the sheet that a curve or a picture takes
const PLACES = 400;
const MOST_SHAPES = 2000;
const GEOMETRY = ["d", "points", "cx", "cy", "r", "rx", "ry"];
const SHAPES = "path, polyline, polygon, circle, ellipse";
const UNSEEN = "defs, clipPath, symbol, marker, pattern, mask";

// The first stroke of a path: `d` up to its second move.
const firstStroke = (d) => /^\s*[Mm][^Mm]*/.exec(d)?.[0] ?? "";

// A copy that holds the shape's geometry and nothing else of its file, inside the transforms about it.
function copyOf(shape, stage) {
  const known = GEOMETRY.filter((name) => shape.hasAttribute(name)).map((name) => [name, shape.getAttribute(name)]);
  const copy = svg(shape.localName, Object.fromEntries(known));
  if (shape.localName === "path") copy.setAttribute("d", firstStroke(shape.getAttribute("d") ?? ""));
  let outer = copy;
  for (let around = shape; around; around = around.parentElement) {
    outer = svg("g", around.hasAttribute("transform") ? { transform: around.getAttribute("transform") } : {}, outer);
  }
  stage.append(outer);
  return copy;
}

function pointsAlong(copy) {
  const length = copy.getTotalLength(), placed = copy.getCTM();
  return Array.from({ length: PLACES + 1 }, (_, i) => copy.getPointAtLength((length * i) / PLACES).matrixTransform(placed)).map(({ x, y }) => [x, -y]);
}

// In the middle of the sheet, as large as suits it.
function fitted(points) {
  const box = boxOf(points);
  const scale = SHEET_SHARE * Math.min((SHEET.x1 - SHEET.x0) / (box.x1 - box.x0), (SHEET.y1 - SHEET.y0) / (box.y1 - box.y0));
  return points.map(([x, y]) => [scale * (x - (box.x0 + box.x1) / 2), scale * (y - (box.y0 + box.y1) / 2)]);
}

// The longest line of an SVG file as points of the sheet; null where it has none.
function curveIn(text) {
  const file = new DOMParser().parseFromString(text, "image/svg+xml");
  const stage = svg("svg", { class: "off-stage", "aria-hidden": "true" });
  document.body.append(stage);
  try {
    const shapes = [...file.querySelectorAll(SHAPES)].filter((shape) => !shape.closest(UNSEEN)).slice(0, MOST_SHAPES);
    const lines = shapes.map((shape) => pointsAlong(copyOf(shape, stage))).filter((points) => points.flat().every(Number.isFinite));
    const sizes = lines.map((points) => diagonal(boxOf(points)));
    const largest = Math.max(0, ...sizes);
    return largest > 0 ? fitted(lines[sizes.indexOf(largest)]) : null;
  } catch {
    return null;
  } finally {
    stage.remove();
  }
}

// A picture {address, share}, of its height to its width.
async function pictureIn(file) {
  const address = await new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result);
    reader.onerror = reject;
    reader.readAsDataURL(file);
  });
  const image = new Image();
  image.src = address;
  await image.decode();
  return { address, share: image.naturalHeight / image.naturalWidth };
}

const isDrawing = ({ type, name }) => type === "image/svg+xml" || /\.svg$/i.test(name);

export class Bringings {
  // `on.curve(points)`, `on.picture({address, share, width} or null)`, `on.fault(text)`.
  constructor(stage, on) {
    Object.assign(this, { on, picture: null });
    const input = byId("bring-file"), width = byId("picture-width");
    byId("bring").addEventListener("click", () => input.click());
    input.addEventListener("change", () => { this.#take(input.files[0]); input.value = ""; });
    width.addEventListener("input", () => this.#show({ ...this.picture, width: width.valueAsNumber }));
    byId("picture-away").addEventListener("click", () => this.#show(null));
    stage.addEventListener("dragover", (event) => event.preventDefault());
    stage.addEventListener("drop", (event) => { event.preventDefault(); this.#take(event.dataTransfer.files[0]); });
    this.#show(null);
  }

  async #take(file) {
    if (!file) return;
    if (isDrawing(file)) {
      const points = curveIn(await file.text());
      if (points) this.on.curve(points); else this.on.fault(say("sketch.no_curve"));
      return;
    }
    try {
      const picture = await pictureIn(file);
      this.#show({ ...picture, width: Math.round(SHEET_SHARE * Math.min(SHEET.x1 - SHEET.x0, (SHEET.y1 - SHEET.y0) / picture.share)) });
    } catch {
      this.on.fault(say("sketch.no_picture"));
    }
  }

  #show(picture) {
    this.picture = picture;
    byId("picture-controls").hidden = !picture;
    if (picture) {
      byId("picture-width").value = picture.width;
      byId("picture-width-value").textContent = say("sketch.units", { value: number(picture.width) });
    }
    this.on.picture(picture);
  }
}
