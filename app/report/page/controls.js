// What every moving report can be told: play, pause, speed, one step on or back, print, save.

const ICONS = { play: "M7 4l13 8-13 8z", pause: "M6 4h4v16H6zM14 4h4v16h-4z" };

class Controls {
  // `advance(seconds)` moves on while playing; `step(sense, large)` answers an arrow key.
  constructor(advance, step) {
    this.player = new Player(advance);
    this.step = step;
  }

  get playing() { return this.player.playing; }

  play(playing) {
    this.player.toggle(playing);
    const button = byId("play");
    button.setAttribute("aria-label", say(playing ? "motion.pause" : "motion.play"));
    button.replaceChildren(svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: playing ? ICONS.pause : ICONS.play })));
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
      if (event.altKey || event.ctrlKey || event.metaKey || event.target.closest("input, button, a, select, summary")) return;
      const sense = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (event.key === " ") this.play(!this.playing);
      else if (sense) this.step(sense, event.shiftKey);
      else return;
      event.preventDefault();
    });
  }

  // Plays from the start, unless the reader asked for less motion.
  start() {
    this.setSpeed(0);
    this.listen();
    this.play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  }
}

// Lets the reader save `text` under the report's title and `ending`.
function saveText(title, ending, type, text) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const name = (title || "cognate").replace(/[^\w-]+/g, "-").slice(0, 60);
  element("a", { href: url, download: `${name}.${ending}` }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

const saveResult = (result) => saveText(result.problem?.title, "result.json", "application/json", `${JSON.stringify(result, null, 2)}\n`);
