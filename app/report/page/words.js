// The texts of the page in the reader's language, of those of the files of page/words.

import { embedded } from "./embedded.js";
import { writtenOut } from "./format.js";

export const WORDS = JSON.parse(embedded("words"));
export const LANGUAGES = Object.keys(WORDS);

// What the reader chose on this or another report; empty where nothing was chosen or can be kept.
export const remembered = (name) => { try { return localStorage.getItem(`cognate-${name}`) ?? ""; } catch { return ""; } };
export const remember = (name, value) => { try { localStorage.setItem(`cognate-${name}`, value); } catch { /* for this page alone */ } };

// By a part of the end of the address (#zh, #zh&…), the reader's choice, or the languages of the browser.
export const language = [...location.hash.slice(1).split("&"), remembered("language"), ...navigator.languages.map((tag) => tag.slice(0, 2)), "en"]
  .find((tag) => LANGUAGES.includes(tag));

const WRITTEN = WORDS[language].words;

// The unit of the file's lengths; undefined where it gives none.
export const LENGTH_UNIT = document.documentElement.dataset.lengthUnit;

// What any text may name in addition to its own values: the unit of lengths, of one and of several, and what
// forces hold for where it is not known.
const OF_LENGTHS = LENGTH_UNIT ? { length_unit: LENGTH_UNIT, lengths: LENGTH_UNIT, for_metres: "" }
  : { length_unit: WRITTEN["unit.of_problem"], lengths: WRITTEN["unit.of_problem_many"], for_metres: WRITTEN["unit.for_metres"] };

// The text named `key`. {name} stands for a value of that name; of "one|many" the part that suits
// `values.n` is taken.
export function say(key, own = {}) {
  const text = WRITTEN[key];
  if (text === undefined) throw new Error(`no words for ${key}`);
  const values = { ...OF_LENGTHS, ...own };
  const parts = text.split("|");
  const part = "n" in values && parts.length > 1 && values.n !== 1 ? parts[1] : parts[0];
  return part.replace(/\{(\w+)\}/g, (_, name) => (name === "n" && typeof values.n === "number" ? values.n.toLocaleString(language) : String(values[name])));
}

// A quantity's name with its unit, where it has one.
export const withUnit = (name, unit) => (unit ? say("unit.axis", { name, unit }) : name);

// Whether there are words for a key.
export const knows = (key) => Object.hasOwn(WORDS[language].words, key);

// A word or a name that the result holds in English, such as the class of a linkage.
export function term(text) {
  if (Object.hasOwn(WORDS[language].terms ?? {}, text)) return WORDS[language].terms[text];
  const [, pin] = /^slider-([A-Z]\w*)$/.exec(text) ?? [];
  return pin ? say("part.slider_of", { pin }) : text;
}

// A key of problem files, or one of the words that may stand under it; undefined where it has no
// translation.
export const keyword = (text) => WORDS[language].keys?.[text] ?? WORDS[language].terms?.[text];

// A sentence that the result holds in English, translated where it has the form of one that is known;
// {0}, {1}, … stand for its numbers, names and parts that are sentences of their own.
export const sentenceOf = (text) => writtenOut(translated(text));

function translated(text) {
  for (const { form, forms } of SENTENCES) {
    const found = form.exec(text);
    if (found) return forms.replace(/\{(\d+)\}/g, (_, i) => translated(found[Number(i) + 1]));
  }
  return term(text);
}

// The longest form is tried first: it says most of what the sentence is.
const SENTENCES = Object.entries(WORDS[language].sentences ?? {}).sort(([a], [b]) => b.length - a.length).map(([form, forms]) => ({
  form: new RegExp(`^${form.split(/\{\d+\}/).map((part) => part.replace(/[\\^$.*+?()[\]{}|]/g, "\\$&")).join("(.+?)")}$`), forms }));

// Fills the elements that name their text: data-say what they hold, data-say-label what a screen
// reader calls them, data-say-title what appears beside the pointer.
function sayAll(root) {
  for (const part of root.querySelectorAll("[data-say]")) part.textContent = say(part.dataset.say);
  for (const part of root.querySelectorAll("[data-say-label]")) part.setAttribute("aria-label", say(part.dataset.sayLabel));
  for (const part of root.querySelectorAll("[data-say-title]")) part.title = say(part.dataset.sayTitle);
}

document.documentElement.lang = language === "zh" ? "zh-Hans" : language;
sayAll(document);
