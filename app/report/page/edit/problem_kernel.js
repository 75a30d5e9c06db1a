// The program's own reader and evaluator of a kind of problem: a problem as results hold it comes back as
// the data that its page is drawn from.

import { encoded } from "../encoded.js";
import { Kernel } from "../kernel.js";

const written = new TextEncoder();
const read = new TextDecoder();

export class ProblemKernel extends Kernel {
  // What `call` of the kernel answers of a problem; {faults: sentences} of what the program would refuse.
  ask(call, problem, ...more) {
    const numbers = [];
    const text = written.encode(encoded(problem, numbers));
    const at = this.calls.room(text.length);
    this.put(numbers);
    new Uint8Array(this.calls.memory.buffer, at, text.length).set(text);
    const length = this.calls[call](...more);
    return JSON.parse(read.decode(new Uint8Array(this.calls.memory.buffer, this.calls.text(), length)));
  }
}
