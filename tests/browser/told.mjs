// What a page says in its cards, to be compared with another page, and reports of files by the program. COGNATE: the program.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";

// The report of a file's text in `folder`. A design that misses a limit is an answer too.
export function reported(folder, name, text, command = "solve") {
  const file = path.join(folder, `${name}.toml`);
  fs.writeFileSync(file, text);
  const { stderr } = spawnSync(process.env.COGNATE, [command, "--quiet", "--out", folder, file], { encoding: "utf8" });
  assert.equal(stderr, "");
  return path.join(folder, `${name}.report.html`);
}

// The texts of the cards `ids` that are shown, but for what is folded away.
export const textsOf = (page, ids) => page.evaluate((names) => Object.fromEntries(names.map((id) => [id, document.getElementById(id)]).filter(([, card]) => card && !card.hidden).map(([id, card]) => {
  const texts = document.createTreeWalker(card, NodeFilter.SHOW_TEXT, (node) => (node.parentElement.closest("[hidden], #table td.wide, .more") ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT));
  const all = [];
  while (texts.nextNode()) all.push(texts.currentNode.data.trim());
  return [id, all.filter(Boolean).join(" ")];
})), ids);

// What the last decimal of a text stands for; 0 where it has none.
const lastDecimal = (text) => (text.includes(".") ? 10 ** (text.indexOf(".") + 1 - text.length) : 0);

// Words are the same, and numbers to what is left by rounding twice: pages of the program have seven digits, and the last decimal
// shown may be rounded to either side. `least`: what is left of numbers near zero.
const PARTS = /-?\d+(?:\.\d+)?/g;
export function sameTold(shown, wanted, what, least = 0.11) {
  assert.equal(shown.replace(PARTS, "#"), wanted.replace(PARTS, "#"), `${what}: words`);
  const [numbers, others] = [shown.match(PARTS) ?? [], wanted.match(PARTS) ?? []];
  numbers.forEach((text, i) => {
    const [x, other] = [Number(text), Number(others[i])], unit = 1.01 * Math.max(lastDecimal(text), lastDecimal(others[i]));
    assert.ok(Math.abs(x - other) <= Math.max(least, unit, 2e-5 * Math.abs(other)), `${what}: ${x} and ${other}`);
  });
}
