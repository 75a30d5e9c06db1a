// The axial section of two bevel gears: their cones, whose apex is common.

import { svg } from "../dom.js";
import { pathThrough, round } from "../shapes.js";
import { boxOf, View } from "../view.js";
import { say } from "../words.js";
import { polar } from "./model.js";

export function bevelSection({ shaft_angle: shaft, cone_distance: far, face_width: face, gears }) {
  const near = Math.max(0, far - face);
  // Points at `reach` along the pitch cone's line, on the cone that stands at `angle` to the axis.
  const place = (axis, sense, cone, angle, reach) => polar(reach / Math.cos(angle - cone), axis + sense * angle);
  const parts = [];
  const everything = [[0, 0]];
  gears.forEach(({ cone_angle: cone, tip_angle: tip, root_angle: root }, i) => {
    const axis = i ? shaft : 0;
    for (const sense of i ? [-1, 1] : [1, -1]) {
      const corners = [place(axis, sense, cone, root, far), place(axis, sense, cone, tip, far), place(axis, sense, cone, tip, near), place(axis, sense, cone, root, near)];
      const foot = ([x, y]) => { const along = x * Math.cos(axis) + y * Math.sin(axis); return polar(along, axis); };
      parts.push({ name: `section-body ${i ? "wheel" : "pinion"}`, points: [corners[0], foot(corners[0]), foot(corners[3]), corners[3]], closed: true });
      parts.push({ name: `section-tooth ${i ? "wheel" : "pinion"}`, points: corners, closed: true });
      parts.push({ name: "section-pitch", points: [[0, 0], polar(1.06 * far, axis + sense * cone)] });
      everything.push(...corners);
    }
    parts.push({ name: "section-axis", points: [polar(-0.12 * far, axis), polar(1.16 * far, axis)] });
    everything.push(polar(-0.12 * far, axis), polar(1.16 * far, axis));
  });
  const box = boxOf(everything);
  const [width, height] = [640, Math.max(200, Math.min(520, (640 * (box.y1 - box.y0)) / (box.x1 - box.x0)))];
  const view = new View(box, width, height, 14);
  return svg("svg", { viewBox: `0 0 ${width} ${round(height)}`, role: "img", "aria-label": say("picture.bevel_section") },
    ...parts.map(({ name, points, closed }) => svg("path", { class: name, d: pathThrough(points.map((p) => view.screen(p))) + (closed ? "Z" : "") })),
    svg("circle", { class: "action-mark", r: 3, cx: round(view.screen([0, 0])[0]), cy: round(view.screen([0, 0])[1]) }));
}
