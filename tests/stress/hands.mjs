// What random hands of all pages have in common.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { randomNumbers } from "../bench/report/drawings.mjs";
import { launch, open, SIZES } from "../browser/browser.mjs";

const BLOCK = 100, BLOCKS_TO_REST = 5;
const PATIENCE = 300000;   // a machine that does much else may take a minute over a few keys
const SENT = { move: ["mouseMoved", 0], down: ["mousePressed", 1], drag: ["mouseMoved", 1], up: ["mouseReleased", 0] };

// PROGRAM [ACTIONS [SEED]] of the command line, and from which act on and on which address it begins (--first, --address).
export function asked() {
  const { positionals: [program, actions = "1000", seed = "1"], values } = parseArgs({ allowPositionals: true, options: { first: { type: "string", default: "1" }, address: { type: "string", default: "" } } });
  return { program, actions: Number(actions), seed: Number(seed), first: Number(values.first), address: values.address };
}

// Numbers in [0, 1) and choices of lists, for a seed and an act of it: `begin(act)` comes first.
export function hands(seed) {
  let next = null;
  const random = () => next();
  const begin = (act) => {
    next = randomNumbers((2654435769 ^ (seed * 40503) ^ (act * 69069)) || 1);
    for (let i = 0; i < 20; ++i) next();
  };
  return { begin, random, pick: (list) => list[Math.floor(random() * list.length)] };
}

const sessions = new WeakMap();
const sessionOf = async (page) => sessions.get(page) ?? sessions.set(page, await page.context().newCDPSession(page)).get(page);

// The mouse from place to place, in pixels, its button held: sent in one go, as fast as the page takes it.
export async function through(page, places) {
  const session = await sessionOf(page), last = places.at(-1);
  const send = (what, [x, y]) => session.send("Input.dispatchMouseEvent", { type: SENT[what][0], buttons: SENT[what][1], button: what === "move" ? "none" : "left", clickCount: what === "move" ? 0 : 1, x, y });
  await Promise.all([send("move", places[0]), send("down", places[0]), ...places.slice(1).map((place) => send("drag", place)), send("up", last)]);
}

// The same of a click.
export const clicked = (page, place) => through(page, [place]);

// Fails where a page does not answer to what `what()` says.
function within(answer, what) {
  let timer;
  const late = new Promise((_, failed) => { timer = setTimeout(() => failed(new Error(`no answer to ${what()} in ${PATIENCE / 1000} s`)), PATIENCE); });
  return Promise.race([answer, late]).finally(() => clearTimeout(timer));
}

// What no page says to its reader.
const NO_WORDS = /\b(NaN|undefined|Infinity|null|\[object \w+\])\b|\{\w+\}/;
async function assertWorded(page) {
  const text = await page.evaluate(() => document.body.innerText), found = NO_WORDS.exec(text);
  if (found) throw new Error(`the page says “${text.slice(Math.max(0, found.index - 80), found.index + 80)}”`);
}

// One run: how often each act was done, and what went wrong.
class Run {
  constructor(asked, { options, hand, does, rests, ready }) {
    Object.assign(this, asked, { options, hand, does, rests, ready, done: {}, lately: [], folder: fs.mkdtempSync(path.join(os.tmpdir(), "cognate-hands-")) });
    this.file = path.join(this.folder, "page.html");
    execFileSync(this.program, ["sketch", ...this.options, "--out", this.file], { stdio: "ignore" });
  }

  // What a block of acts begins with can be gone to again: every second begins with an empty sheet.
  async #beginBlock(act) {
    const address = act % (2 * BLOCK) === 1 ? "" : new URL(this.page.url()).hash;
    this.block = { act, address: act === this.first ? this.address : address };
    await this.page.setViewportSize(SIZES.desktop);
    await this.page.goto("about:blank");
    await this.page.goto(pathToFileURL(this.file).href + this.block.address);
    await this.ready(this.page);
  }

  async #endBlock(act) {
    await assertWorded(this.page);
    if ((act / BLOCK) % BLOCKS_TO_REST && act !== this.first + this.actions - 1) return;
    await this.rests(this.page);
    console.error(`${act} acts`);
  }

  async #act(act) {
    this.hand.begin(act);
    const name = this.hand.pick(Object.keys(this.does)), box = await this.page.locator("#sheet").boundingBox();
    this.done[name] = (this.done[name] ?? 0) + 1;
    this.lately = [...this.lately.slice(-15), name];
    await this.does[name](this.page, ([x, y]) => [box.x + x * box.width, box.y + y * box.height], this.file);
  }

  async #acts() {
    for (let act = this.first; act < this.first + this.actions && !this.faults.length; ++act) {
      this.at = act;
      if (act === this.first || act % BLOCK === 1) await within(this.#beginBlock(act), () => "its address");
      await within(this.#act(act), () => this.lately.at(-1));
      if (act % BLOCK === 0 || act === this.first + this.actions - 1) await within(this.#endBlock(act), () => "rest");
    }
  }

  get again() {
    const { at, block, program, seed, lately } = this;
    return `act ${at}, after ${lately.join(", ")}\nagain: node ${path.relative(".", process.argv[1])} ${program} ${at - block.act + 1} ${seed} --first ${block.act} --address '${block.address}'`;
  }

  async go() {
    const browser = await launch();
    Object.assign(this, await open(browser, this.file, { hash: this.address }));
    const { faults } = this;
    this.page.setDefaultTimeout(PATIENCE);
    await this.#acts().catch((error) => faults.push(String(error.stack ?? error)));
    if (faults.length) faults.push(this.again);
    await browser.close();
    fs.rmSync(this.folder, { recursive: true });
    return { said: Object.entries(this.done).map(([name, count]) => `${count} ${name}`).join(", "), faults };
  }
}

// Opens the page that `program sketch` writes with `options`, and lets `does[name](page, at, file)` act on it, `at` from shares of the
// sheet to pixels, one after another in an order of `hand`. Every hundred acts the page is opened anew by its address (`ready(page)`), every
// five hundred `rests(page)` must come true. Returns how often each did something, and what went wrong with how to have it again.
export const act = (asked, does) => new Run(asked, does).go();
