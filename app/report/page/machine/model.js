// The motions of a machine: tables over time, in which the drive turns at a speed of its own.

import { interpolate, locate, lookUp } from "../sampling.js";

// How long a period of the steady motion, and a start or a stop, is to take on the page, in seconds.
const SHOWN_SECONDS = { steady: 4, start: 8, stop: 8 };

export class Motion {
  constructor({ task, rows, columns }) {
    Object.assign(this, { task, rows, columns: new Map(columns.map((column) => [column.name, column.values])) });
    this.times = this.values("time_s");
    this.angles = this.values("crank_deg");
    this.length = this.times.length > 1 ? this.times.at(-1) : 0;
  }

  // The values under `name`, null where there are none.
  values(name) { return this.columns.get(name) ?? []; }

  get steady() { return this.task === "steady"; }

  // Seconds of the machine in one of the page's.
  get pace() { return this.length / SHOWN_SECONDS[this.task]; }

  // Within the motion, which begins anew where it ends.
  within(time) {
    if (!(this.length > 0)) return 0;
    return time === this.length ? time : time - this.length * Math.floor(time / this.length);
  }

  at(values, time) { return values.length ? interpolate(values, locate(this.times, time)) : null; }

  angle(time) { return this.at(this.angles, time) ?? 0; }

  // When the drive is at `angle`, in any turn, next to where it is at `present`.
  timeAt(angle, present) {
    const now = this.angle(present);
    const wanted = now + angle - now - 360 * Math.round((angle - now) / 360);
    const turn = [0, -360, 360].map((more) => lookUp(wanted + more, this.angles, this.times)).find((time) => time !== null);
    return turn ?? present;
  }
}

// Where a file gives no mechanism, a crank stands for the drive.
export const DRIVE_ALONE = {
  drive: Array.from({ length: 73 }, (_, i) => 5 * i), output: 1, points: [],
  bodies: [{ name: "frame", x: 0, y: 0, deg: 0, outline: [], rails: [], block: false },
    { name: "drive", x: 0, y: 0, deg: Array.from({ length: 73 }, (_, i) => 5 * i), outline: [[0, 0], [1, 0]], rails: [], block: false }],
  pins: [{ body: 0, at: [0, 0], fixed: true }, { body: 1, at: [1, 0], fixed: false }],
};
