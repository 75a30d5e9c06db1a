// The mechanism that is built, its history, and what a hand does to it with the tool it has.

import { History } from "../edit/history.js";
import { mergeJoints, moveJoint, moveLink, placeOfSpot, removeJoint, removeLink, removeLoad, setLoad } from "./edits.js";
import { FORCE_SCALE, spotAt } from "./hits.js";
import { isSound, jointOf, linkOf, loadOf } from "./model.js";
import { TOOLS } from "./tools.js";

export class Desk {
  // `page`: spot(place, reach) of what is seen, snap(place), hold() before a hand does something, show() of a state that a hand still
  // changes, settle() of one that stays, preview(from, to) from a place to a spot, or null, pan(pixels), refuse(tool or "field") of what cannot be done.
  constructor(first, page) {
    Object.assign(this, { page, steps: new History(first), tool: "move", chosen: null, pending: null, from: null });
    this.state = first;
  }

  choose(tool) {
    if (this.pending) this.cancel();
    this.tool = tool;
  }

  // Another state that can be undone; null: there is none.
  change(next, chosen = this.chosen, why = this.tool) {
    if (!next || !isSound(next)) {
      this.state = this.steps.present;
      this.page.refuse(why);
      this.page.settle();
      return;
    }
    this.steps.push(next);
    this.#stand(chosen);
  }

  step(sense) {
    this.steps[sense]();
    this.#stand(this.chosen);
  }

  #stand(chosen) {
    this.state = this.steps.present;
    this.chosen = this.isThere(chosen) ? chosen : null;
    this.#forgetGone();
    this.page.settle();
  }

  // What began at a joint, link or load that is no more ends.
  #forgetGone() {
    const isGone = (spot) => spot && [[jointOf, spot.joint], [linkOf, spot.link], [loadOf, spot.load]].some(([of, name]) => name !== undefined && of(this.state, name) === undefined);
    if (!isGone(this.pending) && !isGone(this.from)) return;
    Object.assign(this, { pending: null, from: null });
    this.page.preview(null);
  }

  isThere(one) {
    if (!one) return false;
    const [list, name] = one.link !== undefined ? [linkOf, one.link] : one.joint !== undefined ? [jointOf, one.joint] : [loadOf, one.load];
    return list(this.state, name) !== undefined;
  }

  press(place, reach) {
    this.from = this.page.spot(place, reach);
    this.began = place;
    this.page.hold();
  }

  // While a hand drags: the mechanism follows, or a line shows what will be.
  move(place, reach, pixels) {
    if (!this.from) return;   // cancelled
    if (this.tool === "move") this.#carry(place, pixels);
    else if (TOOLS[this.tool].drag) this.page.preview(this.#placeOf(this.from), this.page.spot(place, reach));
  }

  #placeOf(spot) { return spot.joint !== undefined || spot.at ? placeOfSpot(this.state, spot) : jointOf(this.state, loadOf(this.state, spot.load)?.on)?.at ?? this.began; }

  // A torque goes with its link.
  #carry(place, pixels) {
    if (this.from.load !== undefined && this.from.link !== undefined) this.from = { link: this.from.link, at: this.from.at };
    const { joint, link, load } = this.from, now = this.steps.present;
    if (joint !== undefined) this.state = moveJoint(now, joint, this.page.snap(place));
    else if (load !== undefined) this.state = setLoad(now, load, this.page.snap(place).map((x, k) => Math.round(FORCE_SCALE * (x - jointOf(now, loadOf(now, load).on).at[k])))) ?? now;
    else if (link !== undefined) this.state = moveLink(now, link, this.page.snap(place.map((x, k) => x - this.began[k])));
    else { this.page.pan(pixels); return; }
    this.page.show();
  }

  // A drag has ended there; or it was a click.
  lift(place, reach, moved) {
    const { from } = this;
    if (!from) return;
    this.page.preview(null);
    this.from = null;
    if (!moved) this.click(place, reach, from);
    else if (this.tool === "move") this.#drop(from, place, reach);
    else this.#act(from, this.page.spot(place, reach));
  }

  // A joint let go on another becomes one with it.
  #drop(from, place, reach) {
    if (from.joint === undefined && from.link === undefined && from.load === undefined) { this.page.settle(); return; }
    const others = { ...this.state, joints: this.state.joints.filter(({ name }) => name !== from.joint) };
    const target = from.joint === undefined ? undefined : spotAt({ ...others, sliders: [], links: [], loads: [] }, place, reach).joint;
    this.change((target && mergeJoints(this.state, from.joint, target)) || this.state, target ? { joint: target } : from);
  }

  #act(from, to) {
    const { drag } = TOOLS[this.tool];
    this.pending = null;
    if (drag) this.change(drag(this.state, from, to)); else this.click(null, 0, from);
  }

  // A click at a spot; of some tools two of them are a drag.
  click(place, reach, spot = this.page.spot(place, reach)) {
    const { tool, pending } = this, { click, ends } = TOOLS[tool];
    if (tool === "move") { this.select(spot); return; }
    if (pending) { this.page.preview(null); this.#act(pending, spot); return; }
    const next = click?.(this.state, spot) ?? null;
    if (next || !ends) this.change(next); else this.#begin(spot);
  }

  #begin(spot) {
    this.pending = spot;
    this.page.preview(this.#placeOf(spot), spot);
    this.page.show();
  }

  // A cross or a pointer that is only moved.
  hover(place, reach) { if (this.pending) this.page.preview(this.#placeOf(this.pending), this.page.spot(place, reach)); }

  // Ends the drag that has begun, as if it had not.
  abandon() {
    Object.assign(this, { from: null, state: this.steps.present });
    this.page.preview(this.pending && this.#placeOf(this.pending), this.pending ?? undefined);
    this.page.settle();
  }

  // Ends what has begun, or selects nothing; false where there was neither.
  cancel() {
    const isBusy = Boolean(this.pending || this.from || this.chosen);
    Object.assign(this, { pending: null, chosen: this.pending || this.from ? this.chosen : null, from: null, state: this.steps.present });
    this.page.preview(null);
    this.page.settle();
    return isBusy;
  }

  select(spot) {
    const [kind] = ["joint", "load", "link"].filter((one) => spot?.[one] !== undefined);
    this.chosen = kind ? { [kind]: spot[kind] } : null;
    this.page.settle();
  }

  // Moves what is selected by a way.
  carry(way) {
    const { joint, link, load } = this.chosen, { state } = this, plus = (place, scale = 1) => place.map((x, k) => Number((x + scale * way[k]).toPrecision(9)));
    if (joint !== undefined) this.change(moveJoint(state, joint, plus(jointOf(state, joint).at)));
    else if (link !== undefined) this.change(moveLink(state, link, way));
    else if (loadOf(state, load).force) this.change(setLoad(state, load, plus(loadOf(state, load).force, FORCE_SCALE)));
  }

  remove(one = this.chosen) {
    if (!this.isThere(one)) return;
    const { joint, link, load } = one;
    this.change(joint !== undefined ? removeJoint(this.state, joint) : link !== undefined ? removeLink(this.state, link) : removeLoad(this.state, load), null);
  }
}
