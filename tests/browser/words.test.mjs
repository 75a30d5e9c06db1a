// The pages in Chinese: nothing that a reader sees or hears is left in English but what is marked as
// such, keys of files, and what the user has named.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { assertFits, launch, visit as visitReport } from "./browser.mjs";
import { some } from "./thinned.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const visit = (name, options, steps) => visitReport(browser, name, { motion: "reduce", ...options }, steps);

// Texts with an English word of four letters or more.
const leftInEnglish = (page) => page.evaluate(() => {
  const { result, study, columns = [] } = JSON.parse(document.getElementById("data").textContent);
  const limits = (result.designs ?? []).flatMap(({ constraints = [] }) => constraints.map(({ name }) => name));
  const own = [result.problem?.title, study?.title, study?.base, ...limits, ...columns.flatMap(({ name }) => [name, name.replace("mechanism.", "")])].filter(Boolean)
    .sort((a, b) => b.length - a.length);
  const names = /\b(?:[Cc]ognate export --parts --bill|[Cc]ognate|WebM|JSON|TOML|Shift|Ctrl|Delete|Sobol|Halton|Delaunay|English)\b/g;
  const keys = /\b\w+(?:[._][\w[\]]+)+/g;
  const isEnglish = (text) => /[A-Za-z]{4}/.test(own.reduce((rest, name) => rest.replaceAll(name, ""), text).replace(keys, "").replace(names, ""));
  for (const part of document.querySelectorAll("wbr")) part.remove();
  document.body.normalize();
  const found = [];
  for (const part of document.body.querySelectorAll("*")) {
    if (part.closest("script, style, noscript, body [lang=en], code, pre")) continue;
    for (const name of ["aria-label", "title", "placeholder", "aria-valuetext"]) if (isEnglish(part.getAttribute(name) ?? "")) found.push(`${name}: ${part.getAttribute(name)}`);
    for (const node of part.childNodes) if (node.nodeType === Node.TEXT_NODE && isEnglish(node.data)) found.push(node.data.trim());
  }
  return found;
});

for (const name of some(["ellipse", "exact-quick-return", "analysis-shaper", "cam-translating-roller", "gear-pair", "gear-undercut", "train-planetary", "machine-compressor", "study-grid",
  "library-toleranced-rocker", "toleranced-ellipse", "toleranced-roller", "ellipse-on-half-units"])) {
  test(`${name} is translated into Chinese`, () => visit(name, { size: "phone", locale: "zh-CN" }, async (page) => {
    assert.equal(await page.evaluate(() => document.documentElement.lang), "zh-Hans");
    await assertFits(page);
    assert.deepEqual(await leftInEnglish(page), []);
    assert.match(await page.locator("#status").textContent(), /^\p{Script=Han}+$/u);
  }));
}

test("the language is chosen, and kept", () => visit("ellipse", {}, async (page) => {
  const language = () => page.evaluate(() => document.documentElement.lang);
  const url = page.url();
  assert.equal(await language(), "en");
  assert.ok((await leftInEnglish(page)).length > 20);
  await page.locator("#language").selectOption("zh");
  await page.waitForFunction(() => document.documentElement.lang === "zh-Hans");
  await page.goto("about:blank");
  await page.goto(url);
  assert.equal(await language(), "zh-Hans");
}));
