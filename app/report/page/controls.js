// The controls of every moving report: play, pause, speed, one step on or back, print, save.

import { byId, element, svg } from "./dom.js";
import { Help, shortcut, TAKES_KEYS } from "./keys.js";
import { Live } from "./live.js";
import { Player } from "./player.js";
import { say } from "./words.js";

const ICONS = { play: "M7 4l13 8-13 8z", pause: "M6 4h4v16H6zM14 4h4v16h-4z", back: "M5 4h3v16H5zM20 4v16L9 12z", on: "M16 4h3v16h-3zM4 4v16l11-8z" };
const icon = (name) => svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: ICONS[name] }));

export class Controls {
  // `advance(seconds)` moves on while playing; `step(sense, large)` answers an arrow key.
  constructor(advance, step) {
    this.player = new Player(advance);
    this.step = step;
    this.live = new Live();
    this.help = new Help();
    shortcut([" "], say("keys.space"), "motion.play_or_pause");
    shortcut(["ArrowLeft", "ArrowRight"], "← →", "keys.step");
    shortcut(["ArrowLeft", "ArrowRight"], "Shift+← Shift+→", "keys.leap");
    shortcut([",", "<"], ",", "motion.slower", () => this.faster(-1));
    shortcut([".", ">"], ".", "motion.faster", () => this.faster(1));
    this.#offerSteps();
  }

  // Buttons beside that which plays: one step back, one step on.
  #offerSteps() {
    const button = (sense, name) => {
      const made = element("button", { type: "button", class: "step", "data-step-by": sense, "aria-label": say(`motion.${name}`), title: say(`motion.${name}`) }, icon(name));
      made.addEventListener("click", (event) => this.step(sense, event.shiftKey));
      return made;
    };
    const [play, group] = [byId("play"), element("div", { class: "plays" })];
    play.replaceWith(group);
    group.append(button(-1, "back"), play, button(1, "on"));
  }

  // What a screen reader speaks once the picture rests: the drive, by its own slider.
  describe = () => {
    const slider = byId("play").closest(".controls").querySelector("input[type=range]");
    return [slider.getAttribute("aria-label"), slider.getAttribute("aria-valuetext"), byId("readout")?.textContent].filter(Boolean).join(" · ");
  };

  faster(by) {
    const slider = byId("speed");
    slider.value = Number(slider.value) + by;
    this.setSpeed(Number(slider.value));
  }

  get playing() { return this.player.playing; }

  play(playing) {
    this.player.toggle(playing);
    const button = byId("play");
    button.setAttribute("aria-label", say(playing ? "motion.pause" : "motion.play"));
    button.replaceChildren(icon(playing ? "pause" : "play"));
    if (playing) this.live.hush(); else this.live.announce(this.describe);
  }

  setSpeed(step) {
    this.player.speed = 2 ** step;
    byId("speed-value").textContent = `×${2 ** step}`;
    byId("speed").setAttribute("aria-valuetext", `×${2 ** step}`);
  }

  listen() {
    byId("play").addEventListener("click", () => this.play(!this.playing));
    byId("speed").addEventListener("input", (event) => this.setSpeed(Number(event.target.value)));
    document.addEventListener("keydown", (event) => {
      const sense = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      // Arrows choose in fields, the space bar presses what it is on.
      const taken = sense ? `${TAKES_KEYS}, input` : "input, button, a, select, summary, textarea";
      if (event.altKey || event.ctrlKey || event.metaKey || event.target.closest?.(taken) || document.querySelector("dialog[open]")) return;
      if (event.key === " ") this.play(!this.playing);
      else if (sense) this.step(sense, event.shiftKey);
      else return;
      event.preventDefault();
    });
  }

  // Plays from the start, unless the system is set to reduced motion.
  start() {
    this.setSpeed(0);
    this.listen();
    this.play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  }
}

// Lets the reader save `text` as a file.
export function saveFile(name, type, text) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

// The same under the report's title and `ending`.
export const saveText = (title, ending, type, text) => saveFile(`${(title || "cognate").replace(/[^\w-]+/g, "-").slice(0, 60)}.${ending}`, type, text);

export const saveResult = (result) => saveText(result.problem?.title, "result.json", "application/json", `${JSON.stringify(result, null, 2)}\n`);
