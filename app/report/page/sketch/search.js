// Searches that follow one another: a new one ends that before it. A spare worker is always ready, so that
// none has to be waited for.

import { moduleBytes } from "../kernel.js";
import { WORKER_TEXT } from "./worker.js";

const SEED = 1;

export class Search {
  // `onAnswer(answer, asked)`: of each question; `onFailure(text)` where the kernel fails.
  constructor(onAnswer, onFailure) {
    Object.assign(this, { onAnswer, onFailure, waiting: [], next: null, last: 0 });
    this.url = URL.createObjectURL(new Blob([WORKER_TEXT], { type: "text/javascript" }));
    this.module = moduleBytes().then((bytes) => WebAssembly.compile(bytes));
    this.spare = this.#worker();
  }

  get busy() { return this.waiting.length > 0; }

  #worker() {
    const worker = new Worker(this.url);
    worker.onmessage = ({ data }) => this.#take(worker, data);
    this.module.then((module) => worker.postMessage({ module }), (error) => this.onFailure(String(error)));
    return worker;
  }

  // Answers the questions [{problem, known, …}] in turn, `known` being designs to begin with, if any; what was asked before
  // is given up.
  async ask(questions) {
    this.cancel();
    this.waiting = questions.map((question) => ({ ...question, id: ++this.last }));
    await this.#begin();
  }

  // The same of one question while a drawing is dragged: one like it that is being answered is not given up, and of those
  // that come meanwhile only the last is asked.
  async askNewest(question) {
    if (this.waiting[0]?.live) this.next = question; else await this.ask([question]);
  }

  async #begin() {
    const { waiting } = this;
    this.worker ??= this.#takeSpare();
    const { worker } = this;
    await this.module;
    if (waiting !== this.waiting) return;
    for (const { id, problem, known = [] } of waiting) worker.postMessage({ id, problem, known, seed: SEED });
  }

  #takeSpare() {
    const worker = this.spare;
    this.spare = this.#worker();
    return worker;
  }

  cancel() {
    this.next = null;
    if (!this.busy) return;
    this.worker?.terminate();
    Object.assign(this, { worker: null, waiting: [] });
  }

  #take(worker, { id, answer, failure }) {
    const [asked] = this.waiting;
    if (worker !== this.worker || asked?.id !== id) return;
    this.waiting.shift();
    if (failure) this.onFailure(failure); else this.onAnswer(answer, asked);
    if (this.busy || !this.next) return;
    const { next } = this;
    this.ask([next]);
  }
}
