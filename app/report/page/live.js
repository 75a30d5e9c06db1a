// What a screen reader speaks about the picture once it rests.

import { element } from "./dom.js";

const REST = 600;

export class Live {
  constructor() {
    this.region = element("p", { class: "unseen", id: "live", role: "status", "aria-live": "polite" });
    document.body.append(this.region);
  }

  // `text()` is called once nothing has been announced for a while.
  announce(text) {
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => { this.region.textContent = text(); }, REST);
  }

  hush() { clearTimeout(this.waiting); }
}
