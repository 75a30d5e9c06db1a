// The program's own reader and evaluator of analyses: a problem as results hold it comes back as the
// data that its page is drawn from.

import { encoded } from "../encoded.js";
import { Kernel } from "../kernel.js";

const written = new TextEncoder();
const read = new TextDecoder();

export class AnalysisKernel extends Kernel {
  // The mechanism's motion and its facts, for what changes as fast as a pointer.
  motion(problem) { return this.#ask(problem, 0); }

  // Everything that the page shows.
  whole(problem) { return this.#ask(problem, 1); }

  // {faults: sentences} of what the program would refuse. The kernel does not know tolerances and layers.
  #ask(problem, whole) {
    const numbers = [];
    const text = written.encode(encoded({ ...problem, tolerance: null, layers: null }, numbers));
    const at = this.calls.room(text.length);
    this.put(numbers);
    new Uint8Array(this.calls.memory.buffer, at, text.length).set(text);
    const length = this.calls.analysis(whole);
    return JSON.parse(read.decode(new Uint8Array(this.calls.memory.buffer, this.calls.text(), length)));
  }
}
