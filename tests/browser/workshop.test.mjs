// Layers and the bill of material in their pages: the figures of the program's result, of the design that is chosen.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { assertFits, launch, LOOKS, visit } from "./browser.mjs";
import { some } from "./thinned.mjs";

const still = { motion: "reduce" };
const NAMES = ["library-klann-leg", "ellipse-in-two-layers"];
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const dataOf = (page) => page.evaluate(() => JSON.parse(document.getElementById("data").textContent));
const cells = (page, rows) => page.locator(`${rows} tr`).evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
const numbers = (row) => row.map((text) => Number(text.replace("−", "-").replaceAll(",", "")));

// A row of the card: how many, and its lengths; what it does not have is no number.
async function assertBill(page, bill) {
  const shown = await cells(page, "#bill-rows");
  assert.equal(shown.length, bill.rows.length);
  for (const [i, row] of bill.rows.entries()) {
    const own = ["length", "width", "thickness", "outside", "bore", "stroke"].map((name) => row[name]).filter((length) => length !== undefined);
    const read = numbers(shown[i].slice(4)).filter(Number.isFinite);
    assert.equal(Number(shown[i][2]), row.quantity);
    assert.deepEqual(shown[i][3].split("–").map(Number), [...new Set([row.layers[0], row.layers.at(-1)])]);
    assert.equal(read.length, own.length);
    for (const [k, length] of own.entries()) assert.ok(Math.abs(read[k] - length) <= 1e-5 * length, `${row.name}: ${read[k]} and ${length}`);
  }
}

async function assertLayers(page, { count, links }) {
  const shown = await cells(page, "#layers-rows");
  assert.equal(shown.length, count + 1);
  for (const [layer, names] of shown.slice(0, -1)) {
    assert.equal(names.split(", ").length, links.filter((link) => link.layer === Number(layer)).length);
  }
}

for (const { size, scheme } of LOOKS) {
  for (const name of some(NAMES)) {
    test(`${name} shows its workshop on a ${size} in ${scheme} colours`, () => visit(browser, name, { size, scheme, ...still }, async (page) => {
      const { result, bill, designs } = await dataOf(page);
      await assertFits(page);
      await assertBill(page, bill ?? designs[0].bill);
      await assertLayers(page, result.designs[0].layers);
    }));
  }
}

test("the design that is chosen has its own bill and layers", () => visit(browser, "ellipse-in-two-layers", still, async (page) => {
  const { result, designs } = await dataOf(page);
  assert.ok(designs.length > 1);
  for (const [i, design] of designs.entries()) {
    await page.locator("#designs tbody").nth(i).locator(".origin").click();
    await assertBill(page, design.bill);
    await assertLayers(page, result.designs[i].layers);
  }
}));

test("in Chinese both cards are Chinese", () => visit(browser, "library-klann-leg", { ...still, hash: "#zh" }, async (page) => {
  assert.equal(await page.locator("#bill-title").textContent(), "材料清单");
  assert.ok((await cells(page, "#bill-rows")).every(([item]) => /^[板销隔套]+$/.test(item)));
}));

test("a page without layers has neither card", () => visit(browser, "library-toleranced-rocker", still, async (page) => {
  for (const id of ["bill", "layers"]) assert.ok(await page.locator(`#${id}`).isHidden());
}));
