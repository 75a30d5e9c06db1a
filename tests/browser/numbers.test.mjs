// How the pages write numbers, and which errors they take for rounding: the modules alone, without a browser.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { number, writtenOut } from "../../app/report/page/format.js";

const words = readFileSync(new URL("../../app/report/page/words/en.json", import.meta.url), "utf8");
// What the module of words asks of a page.
Object.assign(globalThis, { location: { hash: "#en" }, navigator: { languages: [] },
  document: { getElementById: () => ({ textContent: `{"en":${words}}` }), documentElement: { dataset: {} }, querySelectorAll: () => [] } });
const { errorText, isNoError, takeGiven, withoutRounding } = await import("../../app/report/page/rounding.js");

test("numbers inside sentences are written as the page writes numbers, names are left alone", () => {
  const forms = { "it is -78.79 of 1.3e+04": "it is −78.79 of 1.3×10⁴", "1e-07 or -2.5": "1×10⁻⁷ or −2.5", "pins A-3 and no-solution": "pins A-3 and no-solution",
    "B2 at 5,-6": "B2 at 5,−6", "linkage-4bar 12": "linkage-4bar 12", "version 1.2.3": "version 1.2.3", "[-1, 2e3]": "[−1, 2×10³]", "": "" };
  for (const [text, written] of Object.entries(forms)) assert.equal(writtenOut(text), written);
});

test("numbers have a true minus, and powers of ten where they are long", () => {
  const forms = [[-1.5, "−1.5"], [1234567, "1.2346×10⁶"], [-0.00012345678, "−1.2346×10⁻⁴"], [0, "0"], [NaN, "–"], [999999, "999999"], [1e-3, "0.001"]];
  for (const [x, written] of forms) assert.equal(number(x, x === 999999 ? 6 : 5), written);
});

test("an error within the last place of targets of ten digits or more is none, of shorter ones it is", () => {
  const points = (places) => [[-1.23456789012345, 2.5], [0.98765432109876, -3.5]].map((p) => p.map((x) => Number(x.toFixed(places))));
  takeGiven({ points: points(10) });
  assert.ok(isNoError(0.5e-10, 4));
  assert.ok(!isNoError(2e-10, 4));
  takeGiven({ points: points(6) });
  assert.ok(!isNoError(0.5e-6, 4));
  assert.ok(isNoError(1e-12, 4));
  takeGiven({ pairs_deg: [[12.3456789012, 100], [45.1, 200]] });
  assert.ok(isNoError(0.9e-10, 200));
  // Numbers with exponents have their own last place, whole ones none.
  takeGiven({ points: [[1.5e-12, 2e-12]] });
  assert.ok(!isNoError(1e-13, 1e-12));
  takeGiven({ points: [[100, 2000000000000]] });
  assert.ok(!isNoError(100, 2e12));
  takeGiven({});
  assert.ok(!isNoError(1e-9, 1));
  assert.equal(errorText(1e-13, 1, String), "exact (to rounding)");
});

test("copied numbers have twelve digits of the largest beside them", () => {
  assert.equal(withoutRounding(0.1 + 0.2, 1), 0.3);
  assert.equal(withoutRounding(-1e-14, 1), 0);
  assert.equal(withoutRounding(123456.7890123456, 123456), 123456.789012);
  assert.equal(withoutRounding(3e-200, 3e-200), 3e-200);
});
