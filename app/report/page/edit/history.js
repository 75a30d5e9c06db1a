// The states that a reader went through, to go back and forth in. A state is a plain value.

export class History {
  constructor(first) {
    this.states = [first];
    this.at = 0;
  }

  get present() { return this.states[this.at]; }
  get canUndo() { return this.at > 0; }
  get canRedo() { return this.at + 1 < this.states.length; }
  get changed() { return JSON.stringify(this.present) !== JSON.stringify(this.states[0]); }

  // A new state; what was undone before is forgotten. One that is no other adds nothing.
  push(state) {
    if (JSON.stringify(state) === JSON.stringify(this.present)) return;
    this.states.splice(this.at + 1, Infinity, state);
    this.at += 1;
  }

  // The present one with other parts, which is no step.
  amend(parts) { this.states[this.at] = { ...this.present, ...parts }; }

  undo() { this.at -= this.canUndo ? 1 : 0; }
  redo() { this.at += this.canRedo ? 1 : 0; }
}
