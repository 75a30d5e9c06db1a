// The kernel of analyses.

import { ProblemKernel } from "./problem_kernel.js";

export class AnalysisKernel extends ProblemKernel {
  // The mechanism's motion and its facts, for what changes as fast as a pointer.
  motion(problem) { return this.#ask(problem, 0); }

  // The motion alone.
  bareMotion(problem) { return this.#ask(problem, 2); }

  // Everything that the page shows.
  whole(problem) { return this.#ask(problem, 1); }

  // The kernel does not know tolerances and layers.
  #ask(problem, depth) { return this.ask("analysis", { ...problem, tolerance: null, layers: null }, depth); }
}
