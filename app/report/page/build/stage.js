// Where the mechanism stands, and what plays its motion.

import { Controls } from "../controls.js";
import { byId, set } from "../dom.js";
import { filmed } from "../saves.js";
import { driveText } from "./lacks.js";

const PACE = 90, ALONG = 3;   // degrees in a second; seconds along the way of a slider

export class Stage {
  // `on`: moved() after the picture has changed, reached(drive) where the mechanism has come.
  constructor(scene, on) {
    // `isHeld`: whether it is where it is drawn, while a hand works.
    Object.assign(this, { scene, on, motion: null, drive: 0, start: 0, isHeld: false });
    this.controls = new Controls((seconds) => this.#advance(seconds), (sense, large) => this.goTo(this.drive + sense * (large ? 10 : 1) * this.#step, true));
  }

  // Another motion, from where it is drawn.
  begin(motion) {
    const { mechanism: { from, to }, start, isTurning } = motion;
    Object.assign(this, { drive: start, start });
    set(byId("drive"), { min: from, max: to });
    this.controls.player.pace = isTurning ? PACE : (to - from) / ALONG;
  }

  // The same motion, known better.
  refine(desk, motion) {
    const { drive, isHeld } = this;
    this.take(desk, motion);
    if (!isHeld) this.goTo(drive);
  }

  // A state with what is chosen of it, and its motion, if any.
  take({ state, chosen }, motion) {
    this.motion = motion ?? null;
    this.scene.take(state, this.motion, chosen);
    this.draw();
  }

  #advance(seconds) {
    if (!this.motion || this.isHeld) return;
    const { from, to, round } = this.motion.mechanism;
    this.goTo(this.controls.player.next(this.drive, [from, to, round], seconds));
  }

  get #step() {
    const { isTurning, mechanism: { from, to } } = this.motion ?? { isTurning: true, mechanism: {} };
    return isTurning ? 1 : (to - from) / 360;
  }

  goTo(drive, byHand = false) {
    if (byHand) {
      this.controls.play(false);
      this.isHeld = false;
    }
    if (!this.motion) return;
    this.drive = this.motion.mechanism.within(drive);
    this.#move();
    this.on.reached(this.drive);
    const { isTurning } = this.motion, slider = byId("drive");
    slider.value = this.drive;
    slider.setAttribute("aria-valuetext", driveText(this.drive, isTurning, 0));
    byId("drive-value").textContent = driveText(this.drive, isTurning, 1);
  }

  // To a share of a film: once round, or to and fro.
  film(share) {
    const { from, to, round } = this.motion?.mechanism ?? {};
    this.goTo(filmed([from, to, round], share), true);
  }

  // All where it stands, or where it is drawn.
  #move() {
    this.scene.move(this.isHeld || !this.motion ? null : this.drive);
    this.on.moved();
  }

  hold() {
    this.isHeld = true;
    this.#move();
  }

  release() {
    this.isHeld = false;
    this.#move();
  }

  draw() {
    this.scene.build();
    this.#move();
  }
}
