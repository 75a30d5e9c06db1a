// The search, in workers of their own.

import { encoded } from "../encoded.js";
import { moduleBytes } from "../kernel.js";

const SEED = 1;

// All that the worker does; it runs from this function's text and that of `encoded`. It is sent {module} and any number of
// {id, problem, known, seed}, in any order, each of these answered by {id, answer} or {id, failure}.
function searchWorker() {
  let begin;
  const ready = new Promise((resolve) => { begin = resolve; });
  const load = async (module) => {
    const { exports } = await WebAssembly.instantiate(module);
    exports._initialize?.();
    return exports;
  };
  const answerOf = (calls, { problem, known, seed }) => {
    const numbers = [];
    const text = new TextEncoder().encode(encoded(known.length ? { ...problem, known } : problem, numbers));
    const at = calls.room(text.length);
    new Float64Array(calls.memory.buffer, calls.numbers(), 65536).set(numbers);
    new Uint8Array(calls.memory.buffer, at, text.length).set(text);
    const length = calls.sketch(seed);
    return JSON.parse(new TextDecoder().decode(new Uint8Array(calls.memory.buffer, calls.text(), length)));
  };
  self.onmessage = async ({ data }) => {
    if (data.module) { begin(load(data.module)); return; }
    try {
      self.postMessage({ id: data.id, answer: answerOf(await ready, data) });
    } catch (error) {
      self.postMessage({ id: data.id, failure: String(error) });
    }
  };
}

// Makes workers of one module.
export class Workers {
  // `onFailure(text)`: where it cannot be compiled.
  constructor(onFailure) {
    this.onFailure = onFailure;
    this.url = URL.createObjectURL(new Blob([[encoded, `(${searchWorker})();`].join("\n")], { type: "text/javascript" }));
    this.module = moduleBytes().then((bytes) => WebAssembly.compile(bytes));
  }

  // `onData(worker, {id, answer, failure})`.
  make(onData) {
    const worker = new Worker(this.url);
    worker.onmessage = ({ data }) => onData(worker, data);
    this.module.then((module) => worker.postMessage({ module }), (error) => this.onFailure(String(error)));
    return worker;
  }
}

export const ask = (worker, { id, problem, known = [] }) => worker.postMessage({ id, problem, known, seed: SEED });
