// The clock that moves the drive: round and round, or to and fro where it cannot turn fully. `pace`
// is how far it moves in a second, in degrees or length.

export class Player {
  constructor(onStep) {
    Object.assign(this, { onStep, playing: false, speed: 1, pace: 60, sense: 1, last: null });
  }

  toggle(playing = !this.playing) {
    if (playing && !this.playing) requestAnimationFrame((now) => { this.last = now; this.#tick(now); });
    this.playing = playing;
  }

  // The drive coordinate after `seconds`, within [from, to].
  next(crank, [from, to, round], seconds) {
    const turned = crank + (round ? 1 : this.sense) * this.pace * this.speed * seconds;
    if (round) return turned;
    if (turned >= to) this.sense = -1;
    if (turned <= from) this.sense = 1;
    return Math.min(to, Math.max(from, turned));
  }

  #tick(now) {
    if (!this.playing) return;
    this.onStep(Math.min(0.1, (now - this.last) / 1000));
    this.last = now;
    requestAnimationFrame((later) => this.#tick(later));
  }
}
