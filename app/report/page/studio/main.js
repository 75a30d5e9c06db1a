// The page of a studio: a problem is written on the left, what the program finds for it is seen on the right.

import { followTheme } from "../appearance.js";
import { saveText } from "../controls.js";
import { byId, element } from "../dom.js";
import { embedded } from "../embedded.js";
import { duration, number, sentence } from "../format.js";
import { knows, language, say, term } from "../words.js";
import { broughtText } from "./drawn.js";
import { ask } from "./server.js";
import { Taking } from "./taking.js";
import { TextEditor } from "./text_editor.js";
import { addressWithToken, TOKEN } from "./token.js";

const CHECK_AFTER = 300;   // ms without a key
const POLL_AFTER = 100;    // ms between two answers of the program while it solves
const RETRY_AFTER = 2000;  // ms, of a program that does not answer
const DRAWING_PAGES = ["sketch", "mechanism"];

const DATA = JSON.parse(embedded("data"));
const KEPT = `cognate-studio ${TOKEN}`;
const editor = new TextEditor(edited);
const taking = new Taking(DATA.taking, () => fileName().replace(/\.toml$/, "") || "problem");
// The version of the file that is edited, and its text.
let version = DATA.version, saved = DATA.text;
let checks = 0, timer = 0, shownReport = 0, solving = false, sound = false;

const wait = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });
const isDirty = () => editor.text !== saved;
const fileName = () => (DATA.file ?? "").split(/[\\/]/).pop();

// The text

function edited() {
  showDirty();
  clearTimeout(timer);
  timer = setTimeout(check, CHECK_AFTER);
}

function showDirty() {
  byId("dirty").hidden = !isDirty();
  document.title = `${isDirty() ? "● " : ""}${fileName() || say("studio.untitled")} – Cognate`;
}

function take(text) {
  editor.text = text;
  showDirty();
  check();
}

// Faults of the text; an answer that comes after the text has changed again is for nobody.
async function check() {
  const own = ++checks;
  const { status, body } = await ask("/check", { text: editor.text });
  if (own !== checks) return;
  if (status !== 200) { showVerdict(status === 0 ? say("studio.gone") : body.error, false); return; }
  showFaults(body);
  if (sound && byId("live").checked) solve();
}

function showFaults({ valid, problem, faults }) {
  sound = valid;
  editor.show(faults);
  showVerdict(valid ? sentence(problem) : say("studio.faults", { n: faults.length }), valid, valid);
}

function showVerdict(text, good, isEnglish = false) {
  const mark = byId("verdict");
  mark.textContent = `${good ? "✓" : "✗"} ${text}`;
  mark.lang = isEnglish ? "en" : "";
  mark.className = `mark ${good ? "yes" : "no"}`;
}

// The computation

async function solve() {
  checks += 1;
  clearTimeout(timer);
  const { status, body } = await ask("/solve", { text: editor.text });
  if (body.faults) showFaults(body);
  else if (status !== 200) showRun(status === 0 ? say("studio.gone") : body.error);
}

function showRun(text) { byId("run-state").textContent = text; }

function followRun(state) {
  const { phase, share, part, best, seconds, status, message, report } = state;
  solving = phase === "solving";
  byId("stop").disabled = !solving;
  byId("progress").value = phase === "done" ? 1 : share;
  const time = duration(seconds);
  if (phase === "solving") showRun([say("studio.solving", { share: Math.round(100 * share), seconds: Math.floor(seconds) }), ...partTexts(part), ...(best === null ? [] : [say("studio.best", { best: number(best, 3) })])].join(" · "));
  if (phase === "done") showRun(`${say(knows(`status.${status}`) ? `status.${status}` : "status.done")} · ${time}`);
  if (phase === "failed") showRun(message);
  if (report !== shownReport) showReport(report);
  taking.follow(state);
}

// The part of the run, and how long it still takes; where nobody knows, how long it has taken.
function partTexts({ name, seconds, left, is_last: isLast }) {
  const time = (s) => { const whole = Math.ceil(s); return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`; };
  return [...(name ? [term(name)] : []), ...(left === null ? seconds < 2 ? [] : [say("studio.so_far", { time: time(seconds) })] : [say(isLast ? "studio.left" : "studio.left_of_part", { time: time(left) })])];
}

function showReport(report) {
  shownReport = report;
  byId("no-result").hidden = true;
  byId("report").hidden = false;
  byId("report").src = `${addressWithToken("/report")}&run=${report}#${language}`;
}

// A page that nobody sees waits for nothing: a browser has few connections for all its pages.
const seen = () => new Promise((resolve) => {
  if (document.hidden) document.addEventListener("visibilitychange", () => resolve(seen()), { once: true });
  else resolve();
});

// Aborts once the page is hidden.
function hidden() {
  const end = new AbortController();
  document.addEventListener("visibilitychange", () => end.abort(), { once: true });
  return end;
}

// Waits for changes of the computation and of the file, as long as the page is open.
async function follow() {
  let change = null;
  while (true) {
    await seen();
    const { status, body } = await ask(change === null ? "/state" : `/state?after=${change}`, null, hidden().signal);
    if (status === 0 && document.hidden) continue;
    if (status === 200) {
      ({ change } = body);
      followRun(body);
      if (DATA.file && body.file_version !== version) await fileChanged();
      hideNotice("gone");
    } else {
      if (status !== 503) notice("gone", say("studio.gone"));
      change = null;
    }
    await wait(status === 200 ? POLL_AFTER : RETRY_AFTER);
  }
}

// The clock goes on between two answers.
function tick() {
  if (solving) ask("/state").then(({ status, body }) => { if (status === 200) followRun(body); });
}

// The file

async function fileChanged() {
  const { status, body } = await ask("/file");
  if (status !== 200 || body.version === version) return;
  const load = () => { keep(); take(body.text); };
  const isOwn = body.text === editor.text, wasDirty = isDirty();
  const keep = () => { version = body.version; saved = body.text; hideNotice("file"); showDirty(); };
  if (isOwn) keep();
  else if (!wasDirty) load();
  else notice("file", say("studio.changed", { file: fileName() }), [["studio.load", load], ["studio.keep", keep]]);
}

async function save() {
  const text = editor.text;
  if (!DATA.file) { saveText(titleIn(text), "toml", "application/toml", text); saved = text; showDirty(); return; }
  const { status, body } = await ask("/save", { text, version });
  if (status === 200) { ({ version } = body); saved = text; hideNotice("save"); showDirty(); return; }
  if (status === 409) await fileChanged();
  else notice("save", status === 0 ? say("studio.gone") : body.error);
}

const titleIn = (text) => /^title *= *"([^"]*)"/m.exec(text)?.[1] || "problem";

async function begin() {
  const name = byId("template").value;
  byId("template").value = "";
  if (DRAWING_PAGES.includes(name)) { open(`${addressWithToken(`/${name}`)}#${language}`, "_blank", "noopener"); return; }
  const { status, body } = await ask(`/template?name=${encodeURIComponent(name)}`);
  if (status !== 200) return;
  const before = editor.text, wasDirty = isDirty();
  take(body.text);
  if (wasDirty) notice("begin", say("studio.replaced"), [["studio.back", () => { hideNotice("begin"); take(before); }]]);
}

// What is to be answered, one at a time; `what` tells them apart.
function notice(what, text, actions = []) {
  const box = byId("notice");
  if (box.dataset.what === what && !box.hidden) return;
  box.dataset.what = what;
  byId("notice-text").textContent = text;
  byId("notice-actions").replaceChildren(...actions.map(([words, act]) => {
    const button = element("button", { type: "button", class: "chip", "data-action": words.split(".")[1] }, say(words));
    button.addEventListener("click", act);
    return button;
  }));
  box.hidden = false;
}

function hideNotice(what) { if (byId("notice").dataset.what === what) byId("notice").hidden = true; }

// The page

function offerTemplates() {
  const kindOf = (name) => name.replace("new/", "");
  const kinds = DATA.templates.filter(({ name }) => name.startsWith("new/")), worked = DATA.templates.filter(({ name }) => !name.startsWith("new/"));
  const group = (words, list) => element("optgroup", { label: say(words) }, ...list.map(([value, text, attributes = {}]) => element("option", { value, ...attributes }, text)));
  byId("template").append(element("option", { value: "", disabled: "", selected: "" }, say("studio.begin")),
    group("studio.kinds", [...kinds.map(({ name }) => [name, knows(`studio.kind.${kindOf(name)}`) ? say(`studio.kind.${kindOf(name)}`) : kindOf(name)]), ...DRAWING_PAGES.map((name) => [name, say(`studio.${name}`)])]),
    group("studio.worked", worked.map(({ name, title }) => [name, title || name, { lang: "en", title: name }])));
}

function listen() {
  byId("solve").addEventListener("click", solve);
  byId("stop").addEventListener("click", () => ask("/stop", {}));
  byId("save-text").addEventListener("click", save);
  byId("template").addEventListener("change", begin);
  byId("report").addEventListener("load", hideChoices);
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const act = { s: save, Enter: solve }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
  addEventListener("beforeunload", (event) => {
    if (isDirty()) event.preventDefault();
    keepText();
  });
  setInterval(tick, 1000);
}

// The choices of the studio are those of the report.
function hideChoices() {
  for (const choice of byId("report").contentDocument.querySelectorAll(".page-tools label")) choice.hidden = true;
}

function paintReport() {
  const chosen = byId("report").contentDocument?.getElementById("theme");
  if (!chosen) return;
  chosen.value = byId("theme").value;
  chosen.dispatchEvent(new Event("change"));
}

// What was not saved comes back where the page is loaded anew, as for another language.
function keepText() { try { sessionStorage.setItem(KEPT, JSON.stringify({ version, text: editor.text })); } catch { /* it is lost */ } }

function keptText() {
  try {
    const kept = JSON.parse(sessionStorage.getItem(KEPT));
    return kept?.version === version ? kept.text : DATA.text;
  } catch { return DATA.text; }
}

document.body.classList.add("studio");
byId("work").remove();
byId("title").textContent = say("studio.title");
byId("file-name").textContent = fileName() || say("studio.untitled");
byId("file-name").title = DATA.file ?? "";
byId("status").remove();
if (!DATA.file) byId("save-text").textContent = say("studio.download");
offerTemplates();
followTheme(paintReport);
listen();
take(broughtText() ?? keptText());
follow();
