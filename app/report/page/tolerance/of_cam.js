// What moves a follower within the tolerances of its cam: the kernel of cams in the page.

import { ProblemKernel } from "../edit/problem_kernel.js";
import { RADIANS } from "../sampling.js";

// In the order in which the kernel takes them.
const DIMENSIONS = ["base_radius", "offset", "roller_radius", "centre_distance", "arm", "face_offset"];

export class CamMover {
  // `problem`: of a file that gives the whole cam. The kernel does not know its tolerances.
  constructor(problem) { this.problem = { ...problem, tolerance: null }; }

  knows(name) { return DIMENSIONS.includes(name); }

  measures() { return true; }

  // The changes as the kernel takes them; null where the cam is none.
  async changed(changes) {
    CamMover.kernel ??= await ProblemKernel.load();
    if (CamMover.taken !== this && CamMover.kernel.ask("cam_take", this.problem).faults.length) return null;
    CamMover.taken = this;
    const by = new Map(changes);
    return DIMENSIONS.map((name) => by.get(name) ?? 0);
  }

  deviation(state, { unit }, drive) {
    CamMover.kernel.put([...state, drive * RADIANS]);
    CamMover.kernel.calls.cam_misplaced(1);
    const off = CamMover.kernel.numbers[DIMENSIONS.length];
    if (Number.isNaN(off)) return null;
    return unit === "deg" ? off / RADIANS : off;
  }
}
