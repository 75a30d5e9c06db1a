// The card of tolerances: what each dimension makes of the error, the band of deviations over the drive, how the samples
// are spread, and sliders that move the dimensions within their tolerances.

import { markOriginal } from "../original.js";
import { Curves, padded, TURN_STEPS } from "../curves.js";
import { byId, element, fact } from "../dom.js";
import { degreesShort, engineeringExponent, number, powerOfTen, sentence } from "../format.js";
import { lengthText } from "../fact_text.js";
import { RADIANS } from "../sampling.js";
import { keyword, LENGTH_UNIT, say, sentenceOf, term, withUnit } from "../words.js";
import { contributionBars, Histogram } from "./histogram.js";
import { roundedTimes } from "./layer.js";
import { isDistance, isTransmission } from "./quantity.js";

// Within so many standard deviations of the mean lie 99 % of a normal distribution.
const SIGMAS_OF_99 = 2.5758;

// Positions more than this are a curve, fewer are single points.
const FEW_POSITIONS = 40;

// Share of the picture's size that the greatest change takes.
const SHOWN_SHARE = 0.05;

const unitOf = (quantity) => (quantity.unit === "deg" ? "°" : LENGTH_UNIT ?? "");
const valueText = (value, quantity) => (quantity.unit === "deg" ? degreesShort(value, 4) : `${number(value, 4)} ${LENGTH_UNIT ?? ""}`.trim());

// "coupler_point.u" and "C transmission" in the reader's words.
function dimensionText(name) {
  const [of, axis] = name.split(".");
  const words = keyword(of) ?? term(of.replaceAll("_", " "));
  if (axis !== undefined) return `${words} ${axis}`;
  return isTransmission({ name }) ? say("tolerance.transmission_at", { joint: name.split(" ")[0] }) : words;
}

export class ToleranceCard {
  // `after`: the card before this one. `page`: goTo(drive), redraw() of the picture's layers, unit limits.
  constructor(after, page) {
    this.page = page;
    this.facts = element("dl", { id: "tolerance-facts" });
    this.choice = element("div", { class: "parts", id: "tolerance-quantities", role: "group", "aria-label": say("tolerance.quantity") });
    this.bars = element("div", { class: "plot" });
    this.band = element("div", {});
    this.spread = element("div", { id: "tolerance-histogram" });
    this.sliders = element("div", { class: "tolerance-sliders" });
    this.note = element("div", { class: "muted tolerance-notes" });
    this.root = element("section", { class: "card", id: "tolerances", "aria-labelledby": "tolerances-title", hidden: "" },
      element("div", { class: "card-head" }, element("h2", { id: "tolerances-title" }, say("tolerance.title")), this.choice), this.facts,
      element("div", { class: "plots" }, this.bars, this.band, element("div", { class: "plot", id: "tolerance-spread" }, element("h3", {}, say("tolerance.histogram")), this.spread)), this.sliders, this.note);
    after.after(this.root);
    this.curves = new Curves(this.band, (drive) => drive !== null && page.goTo(drive));
    this.histogram = new Histogram(this.spread);
  }

  // `tolerance` of a result; `model`: xOf(drive), range, xLabel, size of what is drawn, and mover, or null where the page has nothing to move with.
  show(tolerance, model) {
    Object.assign(this, { tolerance, model, changes: new Map(), state: null, quantity: 0 });
    this.shown = Boolean(tolerance?.quantities?.length);
    this.root.hidden = !this.shown;
    if (!this.shown) return;
    this.dimensions = tolerance.dimensions.filter(({ name }) => model.mover?.knows(name));
    const [widest] = [...tolerance.dimensions].map(({ plus, minus: less }) => Math.max(plus, less)).sort((a, b) => b - a);
    this.times = roundedTimes(SHOWN_SHARE * model.size / Math.max(widest, this.#judged().unit === "deg" ? (model.size / 3) * (this.#judged().linear ?? 0) * RADIANS : this.#judged().linear ?? 0));
    this.#buildChoice();
    this.#buildSliders();
    this.#choose(tolerance.quantities.indexOf(this.#judged()));
  }

  get adjustable() { return this.dimensions.length > 0; }

  markEdited(on) { if (this.shown) markOriginal(["tolerances"], on); }

  #judged() { return this.tolerance.quantities.find(({ judged }) => judged) ?? this.tolerance.quantities[0]; }

  #buildChoice() {
    const { quantities } = this.tolerance;
    this.choice.hidden = quantities.length < 2;
    this.choice.replaceChildren(...quantities.map(({ name }, i) => {
      const button = element("button", { type: "button", "data-quantity": name }, sentence(dimensionText(name)));
      button.addEventListener("click", () => this.#choose(i));
      return button;
    }));
  }

  #choose(index) {
    this.quantity = index;
    const quantity = this.tolerance.quantities[index];
    for (const [i, button] of [...this.choice.children].entries()) button.setAttribute("aria-pressed", String(i === index));
    this.#showFacts(quantity);
    this.bars.replaceChildren(element("h3", {}, say("tolerance.contributions")), element("p", {}, say(this.tolerance.allocation && quantity.judged ? "tolerance.contributions_bought" : "tolerance.contributions_note", { place: this.#placeText(quantity.linear_at) })),
      contributionBars(quantity, this.tolerance.dimensions, quantity.judged ? this.tolerance.allocation?.tolerances ?? [] : [], (amount) => valueText(amount, quantity), dimensionText));
    byId("tolerance-spread").hidden = !quantity.histogram;
    if (quantity.histogram) this.histogram.show(quantity, unitOf(quantity), quantity.judged ? this.model.limit : undefined);
    this.#buildBand(quantity);
    this.worst.hidden = !this.adjustable || !this.#cornerOf(quantity);
  }

  #placeText(at) { return at === null ? "–" : this.tolerance.slide ? number(at, 5) : degreesShort(at, 5); }

  #showFacts(quantity) {
    const { tolerance } = this;
    const at = (value, place) => say("fact.at", { value, place: this.#placeText(place) });
    const q99 = quantity.quantiles?.find(({ share }) => share === 0.99);
    const rows = [["tolerance.linear", at(`±${valueText(quantity.linear, quantity)}`, quantity.linear_at)],
      ...(quantity.exact ? [["tolerance.exact", at(`${valueText(quantity.exact[0], quantity)} … ${valueText(quantity.exact[1], quantity)}`, quantity.exact_at)]] : []),
      ["tolerance.rss", valueText(quantity.rss, quantity)],
      ...(q99 && q99.error !== null ? [[isTransmission(quantity) ? "tolerance.q99_transmission" : "tolerance.q99", valueText(q99.error, quantity)]] : []),
      ...(quantity.judged && tolerance.yield !== undefined ? [["tolerance.yield", say("tolerance.percent", { value: number(100 * tolerance.yield, 4) })]] : []),
      ...(quantity.judged && tolerance.clearance_linear !== undefined ? [["tolerance.clearance", valueText(tolerance.clearance_linear, quantity)]] : []),
      ...(tolerance.samples ? [["tolerance.samples", say("tolerance.assembled", { n: tolerance.samples, assembled: tolerance.assembled.toLocaleString() })]] : [])];
    this.facts.replaceChildren(...rows.map(([key, value]) => element("div", {}, ...fact(say(key), value))));
    const notes = [...(tolerance.refused ? [tolerance.refused] : []), ...(tolerance.notes ?? [])];
    this.note.replaceChildren(...notes.map((text) => element("p", {}, sentence(sentenceOf(text)))));
  }

  // The positions in the order of the drive.
  #order() {
    const places = (this.tolerance.crank_deg ?? this.tolerance.slide).map((drive) => this.model.xOf(drive));
    const order = places.map((_, i) => i).sort((i, j) => places[i] - places[j]);
    this.order = order;
    return { order, x: order.map((i) => places[i]) };
  }

  #buildBand(quantity) {
    const { order, x } = this.#order();
    const of = (list) => list && order.map((i) => list[i]);
    const { linear, low: least, high: greatest, mean, sigma } = Object.fromEntries(Object.entries(quantity.positions).map(([key, list]) => [key, of(list)]));
    const unsigned = isDistance(quantity);
    const worst = least ? [least, greatest] : [linear.map((v) => (v === null ? null : unsigned ? 0 : -v)), linear];
    const inner = mean ? [-1, 1].map((side) => mean.map((m, i) => (m === null || sigma[i] === null ? null : Math.max(unsigned ? 0 : -Infinity, m + side * SIGMAS_OF_99 * sigma[i])))) : [];
    const known = [...worst, ...inner].flat().filter((v) => v !== null);
    const exponent = engineeringExponent(Math.max(0, ...known.map(Math.abs)));
    const [factor, unit] = [10 ** -exponent, exponent ? `${powerOfTen(exponent)} ${unitOf(quantity)}`.trim() : unitOf(quantity)];
    const times = (list) => list.map((v) => (v === null ? null : v * factor));
    const few = x.length < FEW_POSITIONS;
    const line = (list, more) => ({ y: times(list), ends: few, show: (v) => (v === null ? "" : number(v, 3)), ...more });
    this.set = this.adjustable && this.model.mover.measures(quantity) ? line(x.map(() => null), { colour: "--tolerance", label: say("tolerance.set"), ends: false, dots: few, dash: few ? undefined : [5, 3] }) : null;
    this.factor = factor;
    const lines = [line(worst[0], { colour: "--tolerance-worst" }), line(worst[1], { colour: "--tolerance-worst", label: say(least ? "tolerance.band_exact" : "tolerance.band_linear") }),
      ...(inner.length ? [line(inner[0], { colour: "--tolerance-99" }), line(inner[1], { colour: "--tolerance-99", label: say("tolerance.band_99") })] : []), ...(this.set ? [this.set] : [])];
    const all = [0, ...times(known)];
    const pairs = [[0, 1, 1.5], ...(inner.length ? [[2, 3, 5]] : [])];
    this.sheet = { title: withUnit(say("tolerance.deviation", { name: dimensionText(quantity.name) }), unit), x, xRange: this.model.range, xLabel: this.model.xLabel, xSteps: this.tolerance.slide ? undefined : TURN_STEPS,
      xAt: (drive) => this.model.xOf(drive), driveAt: (at) => at, hover: !few, summary: say("range.at_most_unit", { value: number(Math.max(...all.map(Math.abs)), 4), unit }),
      lines, bands: few ? [] : pairs.map(([low, high]) => ({ low, high, colour: `${lines[low].colour}-soft` })), whiskers: few ? pairs : [], yRange: padded(Math.min(...all), Math.max(...all)) };
    this.drives = order.map((i) => (this.tolerance.crank_deg ?? this.tolerance.slide)[i]);
    this.curves.build([this.sheet]);
    this.#refill();
  }

  // The deviations of the dimensions as they are set.
  #refill() {
    if (this.set) {
      const quantity = this.tolerance.quantities[this.quantity];
      this.set.y = this.drives.map((drive, k) => { const value = this.state && this.model.mover.deviation(this.state, quantity, drive, this.order[k]); return value === null || value === undefined ? null : this.factor * value; });
      this.curves.refill();
    }
    if (this.drive !== undefined) this.curves.move(this.drive);
  }

  move(drive) {
    this.drive = drive;
    if (this.shown) this.curves.move(drive);
  }

  redraw() { if (this.shown) this.curves.redraw(); }

  #buildSliders() {
    const button = (key, act) => { const made = element("button", { type: "button", "data-set": key, title: say(`tolerance.${key}_title`) }, say(`tolerance.${key}`)); made.addEventListener("click", act); return made; };
    this.worst = button("worst", () => { this.#setAll(this.#cornerOf(this.tolerance.quantities[this.quantity])); this.page.goTo(this.tolerance.quantities[this.quantity].linear_at); });
    this.inputs = new Map(this.dimensions.map((one) => [one.name, this.#slider(one)]));
    this.sliders.hidden = !this.adjustable;
    this.sliders.replaceChildren(element("div", { class: "card-head" }, element("h3", {}, say("tolerance.move")), element("div", { class: "segments" }, button("nominal", () => this.#setAll(new Map())), this.worst)),
      element("p", { class: "muted" }, this.#moveHint()), element("div", { class: "slider-grid" }, ...[...this.inputs.values()].map(({ label }) => label)));
  }

  #moveHint() {
    if (!this.model.mover?.outlines) return say("tolerance.move_hint_plot");
    return say("tolerance.move_hint", { times: `×${this.times.toLocaleString()}` });
  }

  #slider({ name, nominal, plus, minus: less }) {
    const input = element("input", { type: "range", min: -less, max: plus, step: "any", value: 0, "data-dimension": name });
    const output = element("output", {});
    const label = element("label", {}, element("span", {}, dimensionText(name), " ", output), input);
    const tell = () => {
      const text = `${number(nominal, 6)} ${input.valueAsNumber < 0 ? "−" : "+"} ${lengthText(Math.abs(input.valueAsNumber), 3)}`;
      output.textContent = text;
      input.setAttribute("aria-valuetext", text);
    };
    input.addEventListener("input", () => { this.changes.set(name, input.valueAsNumber); tell(); this.#apply(); });
    tell();
    return { input, label, tell };
  }

  // Every dimension at the end of its tolerance that leads to the worst case; null where that is no corner of signs.
  #cornerOf(quantity) {
    if (isTransmission(quantity) || !this.model.mover?.measures(quantity) || isDistance(quantity)) return null;
    const signed = quantity.contributions.map(({ dimension, sensitivity }) => [this.tolerance.dimensions.find(({ name }) => name === dimension), Math.sign(sensitivity)]);
    const reach = (side) => signed.reduce((sum, [{ plus, minus: less }, sign], i) => sum + Math.abs(quantity.contributions[i].sensitivity) * (side * sign > 0 ? plus : less), 0);
    const side = reach(1) >= reach(-1) ? 1 : -1;
    return new Map(signed.map(([{ name, plus, minus: less }, sign]) => [name, side * sign > 0 ? plus : -less]));
  }

  #setAll(changes) {
    this.changes = new Map(changes);
    for (const [name, { input, tell }] of this.inputs) { input.value = this.changes.get(name) ?? 0; tell(); }
    return this.#apply();
  }

  // Only the last of what was asked while the kernel was away is answered.
  async #apply() {
    const [changes, model] = [[...this.changes].filter(([name, by]) => by !== 0 && this.inputs.has(name)), this.model];
    this.asked = changes;
    const state = changes.length ? await model.mover.changed(changes) : null;
    if (this.asked !== changes || this.model !== model) return;
    this.state = state;
    this.root.classList.toggle("set", state !== null);
    this.page.redraw(state !== null);
    this.#refill();
  }

  // The lines and the curve of the mechanism, each [nominal, as set]; null while nothing is set.
  outlines(drive) { return this.state && this.model.mover.outlines(this.state, drive); }

  // How far the point may be off across its path: [{at, normal, low, high, inner}].
  whiskers() {
    if (!this.shown || !this.model.acrossAt) return [];
    const { positions } = this.#judged();
    return this.drivesOf().flatMap((drive, i) => {
      const across = positions.low?.[i] !== null && this.model.acrossAt(drive, i);
      const spread = positions.mean && SIGMAS_OF_99 * positions.sigma[i];
      return across ? [{ ...across, low: positions.low?.[i] ?? -positions.linear[i], high: positions.high?.[i] ?? positions.linear[i], inner: spread ? [positions.mean[i] - spread, positions.mean[i] + spread] : null }] : [];
    });
  }

  drivesOf() { return this.tolerance.crank_deg ?? this.tolerance.slide; }
}
