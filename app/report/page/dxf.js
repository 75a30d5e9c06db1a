// Drawings as DXF of release 12, which every program for CAD reads, on the layers of `cognate export`.

// By AutoCAD's index.
const DXF_LAYERS = { FRAME: 8, GUIDES: 8, LINKS: 7, JOINTS: 7, POINTS: 7, PATHS: 30, TARGET: 1, LABELS: 3 };

const groups = (...all) => all.map(([code, value]) => `${code}\n${value}\n`).join("");
const real = (x) => (Number.isInteger(x) ? x.toFixed(1) : String(x));
const coordinates = ([x, y]) => [[10, real(x)], [20, real(y)], [30, "0.0"]];

// Names may have any letters, DXF of this release those of ASCII.
const inAscii = (text) => text.replace(/[^ -~]/g, (letter) => `\\U+${letter.codePointAt(0).toString(16).toUpperCase().padStart(4, "0")}`);

const dxfSection = (name, content) => groups([0, "SECTION"], [2, name]) + content + groups([0, "ENDSEC"]);

const layerTable = () => groups([0, "TABLE"], [2, "LAYER"], [70, Object.keys(DXF_LAYERS).length]) +
  Object.entries(DXF_LAYERS).map(([name, colour]) => groups([0, "LAYER"], [2, name], [70, 0], [62, colour], [6, "CONTINUOUS"])).join("") + groups([0, "ENDTAB"]);

const dxfPolyline = ({ layer, points, closed = false }) => groups([0, "POLYLINE"], [8, layer], [66, 1], ...coordinates([0, 0]), [70, closed ? 1 : 0]) +
  points.map((at) => groups([0, "VERTEX"], [8, layer], ...coordinates(at))).join("") + groups([0, "SEQEND"], [8, layer]);
const dxfCircle = ({ layer, at, radius }) => groups([0, "CIRCLE"], [8, layer], ...coordinates(at), [40, real(radius)]);
const dxfLabel = ({ layer, at, height, text }) => groups([0, "TEXT"], [8, layer], ...coordinates(at), [40, real(height)], [1, inAscii(text)]);

// Of lines {layer, points, closed}, circles {layer, at, radius} and labels {layer, at, height, text}.
export const dxfText = ({ lines, circles, labels }) => dxfSection("HEADER", groups([9, "$ACADVER"], [1, "AC1009"])) + dxfSection("TABLES", layerTable()) +
  dxfSection("ENTITIES", [...lines.filter(({ points }) => points.length > 1).map(dxfPolyline), ...circles.map(dxfCircle), ...labels.map(dxfLabel)].join("")) + groups([0, "EOF"]);

// The signs of a linkage as large as suits a drawing of `size`: as shares of it.
const SIGN_SHARES = { joint: 0.01, point: 0.0065, target: 0.013, text: 0.025, ground: 0.04, block: 0.03 };

export class DxfSigns {
  constructor(size) { for (const [name, share] of Object.entries(SIGN_SHARES)) this[name] = share * size; }

  jointAt(at) { return { layer: "JOINTS", at, radius: this.joint }; }

  pointAt(at) { return { layer: "POINTS", at, radius: this.point }; }

  targetAt(at) { return { layer: "TARGET", at, radius: this.target }; }

  nameAt([x, y], text) { return { layer: "LABELS", at: [x + 1.5 * this.joint, y + 1.5 * this.joint], height: this.text, text }; }

  groundAt([x, y]) { return { layer: "FRAME", points: [[x, y], [x - 0.7 * this.ground, y - this.ground], [x + 0.7 * this.ground, y - this.ground]], closed: true }; }

  // A block at a place that slides in the direction [c, s].
  blockAt([x, y], [c, s]) {
    const a = this.block, b = 0.6 * a;
    return { layer: "LINKS", points: [[-a, -b], [a, -b], [a, b], [-a, b]].map(([u, v]) => [x + u * c - v * s, y + u * s + v * c]), closed: true };
  }
}
