// What can be taken away of the picture: as it stands, as SVG that any program reads, or for CAD; and in motion, as
// a film that the browser records.

import { saveText } from "./controls.js";
import { element, svg } from "./dom.js";
import { say } from "./words.js";

// What style sheets say of a drawing and other programs would not know.
const DRAWN = ["fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin", "opacity", "font-family", "font-size", "font-weight",
  "text-anchor", "dominant-baseline", "paint-order"];

const NOT_DRAWN = ".handle, .edit-handle, title, [hidden]";

// The drawings in `frame`, one on another, with every style of theirs in themselves.
function standalone(frame) {
  const parts = [...frame.querySelectorAll(":scope > svg")].filter((root) => !root.closest("[hidden]"));
  const { clientWidth: width, clientHeight: height } = frame;
  const whole = svg("svg", { xmlns: "http://www.w3.org/2000/svg", viewBox: `0 0 ${width} ${height}`, width, height },
    svg("rect", { width, height, fill: getComputedStyle(frame).backgroundColor }));
  for (const part of parts) whole.append(styled(part));
  return whole;
}

function styled(root) {
  const copy = root.cloneNode(true);
  const [shown, copies] = [root, copy].map((top) => [...top.querySelectorAll("*")]);
  shown.forEach((part, i) => {
    const style = getComputedStyle(part);
    for (const name of DRAWN) if (style.getPropertyValue(name)) copies[i].setAttribute(name, style.getPropertyValue(name));
    for (const name of ["class", "style", "id", "data-name", "data-body", "tabindex", "role"]) copies[i].removeAttribute(name);
  });
  for (const part of shown.map((from, i) => (from.matches(NOT_DRAWN) || getComputedStyle(from).display === "none" ? copies[i] : null))) part?.remove();
  return svg("g", {}, ...copy.childNodes);
}

// Where a motion from `from` to `to` stands at a share of a film: once round, or to and fro.
export const filmed = ([from, to, round], share) => from + (to - from) * (round ? share : 1 - Math.abs(2 * share - 1));

const asText = (drawing) => new XMLSerializer().serializeToString(drawing);

const FILM = { seconds: 4, rate: 25, type: "video/webm", bits: 5e6 };

export class Saves {
  // `motion`: title() of the files; go(share), which moves to a share of the motion; back(), where it stood. `drawing()` of
  // pages that have one: a text for CAD, null while there is nothing to draw.
  constructor(stage, frame, motion, drawing = null) {
    Object.assign(this, { frame, motion, drawing });
    const button = (words, act) => { const made = element("button", { type: "button", class: "link", "data-save": words }, say(`save.${words}`)); made.addEventListener("click", () => act(made)); return made; };
    const films = typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported(FILM.type);
    stage.append(element("p", { class: "saves muted" }, button("picture", () => this.picture()), ...(drawing ? [" · ", button("drawing", () => this.draw())] : []), ...(films ? [" · ", button("film", (made) => this.film(made))] : [])));
  }

  picture() { saveText(this.motion.title(), "svg", "image/svg+xml", `${asText(standalone(this.frame))}\n`); }

  draw() {
    const text = this.drawing();
    if (text) saveText(this.motion.title(), "dxf", "image/vnd.dxf", text);
  }

  // One revolution, or to and fro: all pictures first, however long they take, then as fast as they are seen.
  async film(button) {
    button.disabled = true;
    const count = FILM.seconds * FILM.rate;
    const pictures = [];
    for (let i = 0; i < count; ++i) {
      this.motion.go(i / count);
      pictures.push(await pictureOf(asText(standalone(this.frame))));
      button.textContent = say("save.filming", { share: Math.round((100 * (i + 1)) / count) });
    }
    this.motion.back();
    saveText(this.motion.title(), "webm", FILM.type, await recorded(pictures, this.frame.clientWidth, this.frame.clientHeight));
    for (const picture of pictures) picture.close();
    Object.assign(button, { disabled: false, textContent: say("save.film") });
  }
}

async function pictureOf(text) {
  const image = new Image();
  const loaded = new Promise((done, failed) => { image.onload = done; image.onerror = failed; });
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await loaded;
  return createImageBitmap(image);
}

async function recorded(pictures, width, height) {
  const canvas = element("canvas", { width, height });
  const brush = canvas.getContext("2d");
  const stream = canvas.captureStream(FILM.rate);
  const recorder = new MediaRecorder(stream, { mimeType: FILM.type, videoBitsPerSecond: FILM.bits });
  const pieces = [];
  recorder.addEventListener("dataavailable", ({ data }) => pieces.push(data));
  const ended = new Promise((done) => recorder.addEventListener("stop", done));
  recorder.start();
  const begun = performance.now();
  for (let i = 0; i < pictures.length; ++i) {
    brush.drawImage(pictures[i], 0, 0, width, height);
    await new Promise((done) => setTimeout(done, Math.max(0, begun + (1000 * (i + 1)) / FILM.rate - performance.now())));
  }
  recorder.stop();
  await ended;
  return new Blob(pieces, { type: FILM.type });
}
