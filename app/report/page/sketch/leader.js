// The design chosen, while a hand drags: fitted alone, in a worker of its own, it follows before the others are found.

import { ask } from "./worker.js";

export class Leader {
  // `onAnswer(answer, asked)`: of each question that is not forgotten.
  constructor(workers, onAnswer) { Object.assign(this, { workers, onAnswer, worker: null, asked: null, next: null, id: 0 }); }

  // Makes its worker, which takes a while.
  prepare() { this.worker ??= this.workers.make((_, data) => this.#take(data)); }

  // Of the questions {problem, known, …} that come while one is answered the last alone is asked.
  ask(question) {
    this.prepare();
    this.next = { ...question, id: ++this.id };
    if (!this.asked) this.#begin();
  }

  #begin() {
    Object.assign(this, { asked: this.next, next: null });
    if (this.asked) ask(this.worker, this.asked);
  }

  // What is being answered is no longer of use.
  forget() {
    this.next = null;
    if (this.asked) this.asked.forgotten = true;
  }

  #take({ answer }) {
    const { asked } = this;
    this.#begin();
    if (answer && !asked.forgotten) this.onAnswer(answer, asked);
  }
}
