// Single keys that the page answers to, and the dialog that lists them all.

import { element } from "./dom.js";
import { remember, remembered, say } from "./words.js";

const SHORTCUTS = [];

// `keys`: as KeyboardEvent names them; `shown`: as the dialog writes them; `words`: key of the text
// that says what they do; without `act` another part of the page answers them.
export function shortcut(keys, shown, words, act = null) { SHORTCUTS.push({ keys, shown, words, act }); }

// Fields in which a key is text, or chooses by itself.
export const TAKES_KEYS = "input:not([type=range]):not([type=radio]):not([type=checkbox]), select, textarea, [contenteditable]";

// Ctrl+Z and Ctrl+Shift+Z or Ctrl+Y: `step` takes "undo" or "redo".
export function listenToUndo(step) {
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.closest?.("textarea, input[type=text], input[type=number]")) return;
    const sense = { z: event.shiftKey ? "redo" : "undo", y: "redo" }[event.key.toLowerCase()];
    if (!sense) return;
    event.preventDefault();
    step(sense);
  });
}

export class Help {
  constructor() {
    this.off = remembered("keys") === "off";
    const open = element("button", { type: "button", class: "link", id: "help", "aria-haspopup": "dialog" }, say("keys.title"));
    open.addEventListener("click", () => this.show());
    document.querySelector(".page-tools").append(open);
    shortcut(["?"], "?", "keys.help", () => this.show());
    document.addEventListener("keydown", (event) => this.#answer(event));
  }

  #answer(event) {
    if (event.altKey || event.ctrlKey || event.metaKey || event.target.closest?.(TAKES_KEYS) || document.querySelector("dialog[open]")) return;
    const found = SHORTCUTS.find(({ keys, act }) => act && keys.includes(event.key));
    if (!found || (this.off && event.key !== "?" && event.key.length === 1) || found.act(event) === false) return;
    event.preventDefault();
  }

  show() {
    this.dialog ??= this.#make();
    this.dialog.showModal();
  }

  #make() {
    const title = element("h2", { id: "help-title" }, say("keys.title"));
    const rows = SHORTCUTS.flatMap(({ shown, words }) => [element("dt", {}, ...shown.split(" ").map((key) => element("kbd", {}, key))), element("dd", {}, say(words))]);
    const letters = element("input", { type: "checkbox", id: "help-letters" });
    letters.checked = !this.off;
    letters.addEventListener("change", () => { this.off = !letters.checked; remember("keys", this.off ? "off" : ""); });
    const close = element("button", { type: "button", class: "chip" }, say("keys.close"));
    const dialog = element("dialog", { "aria-labelledby": "help-title" }, title, element("dl", { class: "key-list" }, ...rows),
      element("p", {}, element("label", {}, letters, " ", say("keys.letters"))), close);
    close.addEventListener("click", () => dialog.close());
    document.body.append(dialog);
    return dialog;
  }
}
