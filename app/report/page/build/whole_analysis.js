// All that the kernel says of a mechanism, asked of a worker, so that the page goes on meanwhile.

import { encoded } from "../encoded.js";
import { moduleBytes } from "../kernel.js";
import { say } from "../words.js";

// All that the worker does; it runs from this function's text and that of `encoded`. It is sent {module} first, then {id, problem}, each
// answered by {id, answer} or {id, failure}.
function analysisWorker() {
  const EVERYTHING = 1;
  let ready;
  const load = async (module) => {
    const { exports } = await WebAssembly.instantiate(module);
    exports._initialize?.();
    return exports;
  };
  const answerOf = (calls, problem) => {
    const numbers = [];
    const text = new TextEncoder().encode(encoded(problem, numbers));
    const at = calls.room(text.length);
    new Float64Array(calls.memory.buffer, calls.numbers(), 65536).set(numbers);
    new Uint8Array(calls.memory.buffer, at, text.length).set(text);
    const length = calls.analysis(EVERYTHING);
    return JSON.parse(new TextDecoder().decode(new Uint8Array(calls.memory.buffer, calls.text(), length)));
  };
  self.onmessage = async ({ data }) => {
    if (data.module) { ready = load(data.module); return; }
    try {
      self.postMessage({ id: data.id, answer: answerOf(await ready, data.problem) });
    } catch (error) {
      self.postMessage({ id: data.id, failure: String(error) });
    }
  };
}

export class WholeAnalysis {
  constructor() {
    Object.assign(this, { last: 0, asked: null });
    this.url = URL.createObjectURL(new Blob([[encoded, `(${analysisWorker})();`].join("\n")], { type: "text/javascript" }));
    this.module = moduleBytes().then((bytes) => WebAssembly.compile(bytes));
    this.worker = this.#fresh();
  }

  #fresh() {
    const worker = new Worker(this.url);
    worker.onmessage = ({ data }) => this.#take(worker, data);
    this.module.then((module) => worker.postMessage({ module }), () => {});
    return worker;
  }

  // onAnswer(data or {faults}), unless it is cancelled before.
  async ask(problem, onAnswer) {
    this.cancel();
    const asked = { id: ++this.last, onAnswer };
    this.asked = asked;
    await this.module;
    if (asked === this.asked) this.worker.postMessage({ id: asked.id, problem });
  }

  // What is still asked ends with its worker.
  cancel() {
    if (!this.asked) return;
    this.asked = null;
    this.worker.terminate();
    this.worker = this.#fresh();
  }

  #take(worker, { id, answer, failure }) {
    const { asked } = this;
    if (worker !== this.worker || asked?.id !== id) return;
    this.asked = null;
    asked.onAnswer(failure ? { faults: [say("edit.failed")] } : answer);
    if (!failure) return;
    worker.terminate();
    this.worker = this.#fresh();
  }
}
