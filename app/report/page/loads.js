// What acts on a mechanism from outside: loads, weights, and what drives it, in the scale of the forces
// in its joints. Pointed at, an arrow says what it is, on which body, and how much.

import { set, svg } from "./dom.js";
import { number } from "./format.js";
import { Mechanism } from "./mechanism.js";
import { locate, quantile } from "./sampling.js";
import { arcPath, arrowPath, legendItem, round } from "./shapes.js";
import { say, term } from "./words.js";

// A force that nearly fills the part of the picture that arrows take.
const usualForce = (scene) => quantile([...scene.table.loads.filter((load) => load.force).map(({ force }) => Math.hypot(...force)),
  ...scene.table.loads.filter((load) => load.direction).flatMap(({ column }) => scene.table.columns[column].values),
  ...scene.arrows.filter(({ quantity }) => quantity === "reactions").map(({ size }) => size)], 1);

export class Loads {
  constructor() {
    Object.assign(this, { name: "loads", words: "extras.loads", key: "l", root: svg("g", { class: "loads" }) });
  }

  available(scene) { return Boolean(scene.view) && scene.table.loads.length > 0; }

  build(scene) {
    const reach = 0.24 * Math.min(scene.view.width, scene.view.height);
    const most = usualForce(scene);
    // Joint forces and these have one scale, so that they can be compared.
    this.scale = scene.arrows.find(({ quantity }) => quantity === "reactions") ? reach / scene.arrows.find(({ quantity }) => quantity === "reactions").size : most > 0 ? reach / most : 0;
    this.reach = 1.7 * reach;
    this.parts = scene.table.loads.map((load) => {
      const [title, lines] = [svg("title", {}), [svg("path", { class: "halo" }), svg("path", {})]];
      const root = svg("g", { class: `arrow ${load.kind}` }, title, ...lines);
      return { load, root, title, lines };
    });
    this.root.replaceChildren(...this.parts.map(({ root }) => root), ...this.#bar(scene));
  }

  // A round force in the scale of the arrows.
  #bar({ view: { width, height } }) {
    if (!(this.scale > 0)) return [];
    const wanted = 90 / this.scale;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const force = [5, 2, 1].map((k) => k * power).find((f) => f <= wanted) ?? power;
    const [x, y] = [width - 16 - force * this.scale, height - 14];
    return [svg("path", { class: "scale-line", d: `M${round(x)} ${y - 4}v4H${width - 16}v-4` }), svg("text", { class: "scale-text", x: width - 18, y: y - 4, "text-anchor": "end" }, `${number(force)} N`)];
  }

  move(scene, drive) {
    const { table, mechanism, view } = scene;
    const places = mechanism.places(drive);
    for (const part of this.parts) {
      const { load } = part;
      const place = places[load.body];
      const { force, torque } = place && table.drive.length ? loadAt(load, table, drive, place) : {};
      const at = place && view.screen(Mechanism.point(place, load.at));
      const long = force ? this.scale * Math.hypot(...force) : 0;
      const k = long > this.reach ? (this.scale * this.reach) / long : this.scale;
      const d = at ? (force ? arrowPath(at, [k * force[0], -k * force[1]]) : "") + arcPath(at, torque) : "";
      for (const line of part.lines) set(line, { d });
      part.title.textContent = d ? loadText(load, mechanism, force, torque) : "";
    }
  }

  legend() {
    const kinds = [...new Set(this.parts?.map(({ load }) => load.kind))];
    return kinds.map((kind) => legendItem(`load-${kind}`, "line", say(`loads.${kind}`)));
  }
}

// The force and the torque of a load where the drive stands; the direction may turn with its body.
function loadAt({ column, direction, turns, force, torque, acts }, table, drive, place) {
  if (column !== undefined) {
    const value = table.at(table.columns[column], drive);
    const along = turns ? Mechanism.point([0, 0, place[2], place[3]], direction) : direction;
    return value === null ? {} : along ? { force: along.map((x) => value * x) } : { torque: value };
  }
  const [i, t] = locate(table.drive, drive);
  return acts && !acts[Math.min(acts.length - 1, t < 0.5 ? i : i + 1)] ? {} : { force, torque };
}

function loadText({ kind, body }, mechanism, force, torque) {
  const values = [...(force && Math.hypot(...force) > 0 ? [say("loads.force", { value: number(Math.hypot(...force), 5), x: number(force[0], 4), y: number(force[1], 4) })] : []),
    ...(torque ? [say("loads.torque", { value: number(torque, 5) })] : [])];
  return say("loads.on", { kind: say(`loads.${kind}`), body: term(mechanism.bodies[body].name), value: values.join(say("list.comma")) });
}
