// Exported facets as a picture: seen obliquely from above, the solids drawn upwards.
import { readFileSync } from "node:fs";

const WIDTH = 720, MARGIN = 20;
const TURN = -0.35, TILT = 0.75;  // of the view, radians
const COLOURS = { frame: [214, 216, 219], pin: [90, 96, 105] };
const LINKS = [[86, 140, 207], [104, 176, 140], [222, 165, 84], [190, 118, 170], [120, 130, 200], [200, 110, 100]];
const LIGHT = [0.35, -0.45, 0.82];

function facetsOf(text) {
  const corners = [...text.matchAll(/^vertex (\S+) (\S+) (\S+)$/gmu)].map(([, ...p]) => p.map(Number));
  return Array.from({ length: corners.length / 3 }, (_, i) => corners.slice(3 * i, 3 * i + 3));
}

// In the assembly; an STL lies on z = 0. Of a slice the heights are those of its own.
function placed([x, y, z], { solid, low, high }, millimetres) {
  const turn = (solid.turned_deg * Math.PI) / 180, c = Math.cos(turn), s = Math.sin(turn);
  const height = low + (z / millimetres) * ((high - low) / (solid.high - solid.low));
  return [c * x - s * y + millimetres * solid.at[0], s * x + c * y + millimetres * solid.at[1], millimetres * height];
}

const isPin = (solid) => solid.name.startsWith("pin ");

// What is drawn one over the other: of each layer the walls of the pins in it, its plates, and the ends of pins.
function slicesOf(solids) {
  const layers = [...new Map(solids.filter((solid) => !isPin(solid)).map(({ low, high }) => [low.toFixed(9), [low, high]])).values()];
  const within = (pin) => layers.filter(([low, high]) => low > pin.low - 1e-9 && high < pin.high + 1e-9);
  const slices = solids.flatMap((solid) => isPin(solid)
    ? [...within(solid).map(([low, high]) => ({ solid, low, high, order: 0 })), { solid, low: solid.low, high: solid.high, order: 2 }]
    : [{ solid, low: solid.low, high: solid.high, order: 1 }]);
  const shown = (slice, upwards) => slice.order === 1 || (slice.order === 2) === upwards > 0.5;
  return slices.map((slice) => ({ ...slice, shown: (normal) => shown(slice, normal[2]) }))
    .sort((p, q) => Math.abs(p.high - q.high) > 1e-9 ? p.high - q.high : p.order - q.order);
}

// To the right, up, and towards the eye.
function seen([x, y, z]) {
  const u = Math.cos(TURN) * x - Math.sin(TURN) * y, v = Math.sin(TURN) * x + Math.cos(TURN) * y;
  return [u, Math.cos(TILT) * v + Math.sin(TILT) * z, Math.cos(TILT) * z - Math.sin(TILT) * v];
}

function normalOf([a, b, c]) {
  const p = b.map((x, i) => x - a[i]), q = c.map((x, i) => x - a[i]);
  const n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  const length = Math.hypot(...n);
  return n.map((x) => x / length);
}

function colourOf(name, link) {
  return COLOURS[name.split(" ")[0]] ?? LINKS[link % LINKS.length];
}

// The SVG of the solids that `made`, the document of an export to STL, names; `millimetres` are those of a length.
export function solidsPicture(made, millimetres) {
  const solids = made.solids.map((solid, i) => ({ ...solid, index: i, text: readFileSync(made.files[i], "utf8") }));
  const shapes = slicesOf(solids).flatMap((slice) => facetsOf(slice.solid.text)
    .map((facet) => facet.map((corner) => placed(corner, slice, millimetres)))
    .map((facet) => ({ corners: facet.map(seen), normal: normalOf(facet), colour: colourOf(slice.solid.name, slice.solid.index) }))
    .filter(({ corners: [a, b, c], normal }) => slice.shown(normal) && (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0)
    .sort((p, q) => p.normal[2] - q.normal[2]));
  const all = shapes.flatMap(({ corners }) => corners);
  const low = [0, 1].map((k) => all.reduce((least, p) => Math.min(least, p[k]), Infinity));
  const high = [0, 1].map((k) => all.reduce((most, p) => Math.max(most, p[k]), -Infinity));
  const scale = (WIDTH - 2 * MARGIN) / (high[0] - low[0]), height = 2 * MARGIN + scale * (high[1] - low[1]);
  const at = (p) => `${(MARGIN + scale * (p[0] - low[0])).toFixed(1)},${(height - MARGIN - scale * (p[1] - low[1])).toFixed(1)}`;
  const painted = shapes.map(({ corners, normal, colour }) => {
    const shade = 0.55 + 0.45 * Math.max(0, normal.reduce((sum, x, i) => sum + x * LIGHT[i], 0));
    const fill = `#${colour.map((c) => Math.round(c * shade).toString(16).padStart(2, "0")).join("")}`;
    return `<path d="M${corners.map(at).join("L")}Z" fill="${fill}" stroke="${fill}"/>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${height.toFixed(0)}" width="${WIDTH}" stroke-width="0.6" stroke-linejoin="round">\n${painted.join("\n")}\n</svg>\n`;
}
