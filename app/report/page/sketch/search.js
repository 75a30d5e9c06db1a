// Searches that follow one another: a new one ends that before it. A spare worker is ready, so that none has to be waited for: it
// is made once the one before it has answered, or is ended, and does not take time from the first answer.

import { ask } from "./worker.js";

// A question of several problems as one for each; the answer to the last of them holds what was found for all.
const oneByOne = ({ others = [], ...question }) => [...others.map((other) => ({ ...other, isPart: true, live: question.live })), question];

const joined = (before, answer = {}) => ({ ...before, ...answer, ...(before.designs ? { designs: [...before.designs, ...(answer.designs ?? [])] } : {}) });

export class Search {
  // `onAnswer(answer, asked)`: of each question; where the kernel fails `workers` are told.
  constructor(workers, onAnswer) {
    Object.assign(this, { workers, onAnswer, waiting: [], found: {}, next: null, last: 0 });
    this.spare = this.#worker();
  }

  get busy() { return this.waiting.length > 0; }

  #worker() { return this.workers.make((worker, data) => this.#take(worker, data)); }

  // Answers the questions [{problem, known, others, …}] in turn, `known` being designs to begin with, if any, `others` further problems
  // {problem, known} that are answered with it; what was asked before is given up.
  ask(questions) {
    this.cancel();
    this.waiting = questions.flatMap(oneByOne).map((question) => ({ ...question, id: ++this.last }));
    this.worker ??= this.#takeSpare();
    for (const question of this.waiting) ask(this.worker, question);
  }

  // The same of one question while a drawing is dragged: one like it that is being answered is not given up, and of those
  // that come meanwhile only the last is asked.
  askNewest(question) {
    if (this.waiting[0]?.live) this.next = question; else this.ask([question]);
  }

  #takeSpare() {
    const worker = this.spare ?? this.#worker();
    this.spare = null;
    return worker;
  }

  cancel() {
    Object.assign(this, { next: null, found: {} });
    if (!this.busy) return;
    this.worker?.terminate();
    Object.assign(this, { worker: null, waiting: [] });
    this.spare ??= this.#worker();
  }

  #take(worker, { id, answer, failure }) {
    const [asked] = this.waiting;
    if (worker !== this.worker || asked?.id !== id) return;
    this.waiting.shift();
    const found = joined(this.found, answer);
    this.found = asked.isPart ? found : {};
    // The next is searched for while the page draws the answer.
    if (this.next && !asked.isPart) this.ask([this.next]);
    if (failure) this.workers.onFailure(failure); else if (!asked.isPart) this.onAnswer(found, asked);
    this.spare ??= this.#worker();
  }
}
