// What all report pages have in common: how the picture is looked at, its extra layers, one
// cursor, tables, keys, paper, contrast, size.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";
import { after, before } from "node:test";
import { distance, launch, visit as visitReport, withoutPlots } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());
const still = { motion: "reduce" };
const visit = (name, steps, options = still) => visitReport(browser, name, options, steps);

const KINDS = ["ellipse", "exact-motion", "library-crank-rocker", "cam-translating-roller", "gear-pair", "study-grid"];
const scaleOf = (page) => page.locator("#picture > svg .scale-line").first().evaluate((line) => line.getBBox().width);
const box = (page, selector) => page.locator(selector).first().evaluate((part) => { const b = part.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; });
const toggle = (page, name) => page.locator(`[data-extra=${name}]`).click();
const turnTo = (page, value) => page.locator("#crank, #drive").evaluate((input, at) => { input.value = at; input.dispatchEvent(new Event("input")); }, value);
const frame = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

for (const name of some(KINDS)) {
  test(`${name}: the picture is first, steps, grows and shrinks`, () => visit(name, async (page) => {
    const first = await page.locator("#main > :not([hidden])").first().evaluate((part) => part.querySelector("#picture") !== null);
    assert.ok(first, "the picture is not first");
    const drive = () => page.locator("#crank, #drive").evaluate((input) => Number(input.value));
    const at = await drive();
    await page.locator("[data-step-by='1']").click();
    const on = await drive();
    assert.ok(Math.abs(on - at) > 0.5, `${at} → ${on}`);
    await page.locator("[data-step-by='-1']").click();
    assert.ok(Math.abs(await drive() - at) < 1e-6);

    const ground = "#picture > svg .ground, #picture > svg .hub";
    const [x, y] = await box(page, ground);
    const picture = await page.locator("#picture").boundingBox();
    const middle = [picture.x + picture.width / 2, picture.y + picture.height / 2 - 11];
    await page.keyboard.press("+");
    await frame(page);
    const near = await box(page, ground);
    // Its sign keeps its size: its foot is what goes outward from the middle.
    const share = distance(near, middle) / distance([x, y], middle);
    assert.ok(share > 1.25 && share < 1.55, `${share}`);
    await page.keyboard.press("0");
    await frame(page);
    assert.ok(distance(await box(page, ground), [x, y]) < 0.5);

    await page.keyboard.press("f");
    await frame(page);
    const large = await page.locator("#picture").boundingBox();
    assert.ok(large.width > 1300 && large.height > 550, `${large.width} × ${large.height}`);
    assert.equal(await page.locator(".page-foot").evaluate((foot) => foot.inert || foot.closest("[inert]") !== null), true);
    await page.keyboard.press("Escape");
    await frame(page);
    assert.ok((await page.locator("#picture").boundingBox()).width < 1100);
    assert.equal(await page.locator("[inert]").count(), 0);
  }));
}

for (const name of some([...KINDS, "machine-press"])) {
  test(`${name}: what plays the motion is in the first screen of a laptop`, () => visit(name, async (page) => {
    const [picture, play, slider] = [await page.locator("#picture").boundingBox(), await page.locator("#play").boundingBox(), await page.locator("#crank, #drive").boundingBox()];
    assert.ok(picture.height >= 250, `a picture of ${picture.height} pixels`);
    for (const part of [play, slider]) assert.ok(part.y + part.height <= 720, `down to ${part.y + part.height}`);
  }, { ...still, size: "laptop" }));
}

// Lines that a text takes, by the places of its characters.
for (const name of some(["exact-motion", "library-four-bar-forces", "cam-translating-roller"])) {
  test(`${name}: on a phone no number is broken across lines`, () => visit(name, async (page) => {
    for (const fold of await page.locator(".more summary").all()) await fold.click();
    const [count, broken] = await page.evaluate(() => {
      const numbers = /[−-]?\d[\d,]*(?:\.\d+)?(?:×10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?/g;
      const walker = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
      const found = [];
      let all = 0;
      for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        if (!node.parentElement.closest("dd, td, .notes, .summary") || node.parentElement.closest("pre, code")) continue;
        for (const match of node.data.matchAll(numbers)) {
          const range = document.createRange();
          range.setStart(node, match.index);
          range.setEnd(node, match.index + match[0].length);
          const tops = new Set([...range.getClientRects()].map((rect) => Math.round(rect.top)));
          all += tops.size > 0;
          if (tops.size > 1) found.push(match[0]);
        }
      }
      return [all, found];
    });
    assert.ok(count > 20, `${count} numbers`);
    assert.deepEqual(broken, []);
  }, { ...still, size: "phone" }));
}

test("the picture is saved as SVG that needs no style sheet, and in motion", () => visit("ellipse", async (page) => {
  const [picture] = await Promise.all([page.waitForEvent("download"), page.locator("[data-save=picture]").click()]);
  const text = readFileSync(await picture.path(), "utf8");
  assert.match(text, /^<svg xmlns="http:\/\/www.w3.org\/2000\/svg" viewBox/);
  assert.doesNotMatch(text, /class=|style=|var\(|NaN/);
  assert.ok(text.match(/<path /g).length > 10);
  const ink = await page.evaluate(async (source) => {
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(source)}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height).getContext("2d");
    canvas.drawImage(image, 0, 0);
    const { data } = canvas.getImageData(0, 0, image.width, image.height);
    return new Set(Array.from({ length: data.length / 4 }, (_, i) => `${data[4 * i]} ${data[4 * i + 1]} ${data[4 * i + 2]}`)).size;
  }, text);
  assert.ok(ink > 20, `${ink} colours`);
  const [film] = await Promise.all([page.waitForEvent("download", { timeout: 120000 }), page.locator("[data-save=film]").click()]);
  const bytes = readFileSync(await film.path());
  assert.ok(bytes.length > 4000, `${bytes.length} bytes`);  // a slow machine records few frames
  // EBML, the container of WebM.
  assert.equal(bytes.subarray(0, 4).toString("hex"), "1a45dfa3");
}));

test("a click on a body traces a point of it, and its coordinates are shown", () => visit("library-crank-rocker", async (page) => {
  await turnTo(page, 50);
  const at = await page.locator('[data-body="3"] path').first().evaluate((path) => {
    const p = path.getPointAtLength(0.1);
    const box = path.getBBox();
    const q = path.ownerSVGElement.createSVGPoint();
    Object.assign(q, { x: box.x + box.width / 2, y: box.y + box.height / 2 });
    const s = q.matrixTransform(path.getScreenCTM());
    return [s.x, s.y, p.x];
  });
  await page.mouse.click(at[0], at[1]);
  assert.match(await page.locator("#ghosts").textContent(), /Point of the rocker at u .* v /);
  const length = await page.locator(".traced-path").evaluate((path) => path.getTotalLength());
  assert.ok(length > 100, `${length} pixels`);
  const [x, y] = await circleAt(page, ".traced-point");
  const picture = await page.locator("#picture").boundingBox();
  assert.ok(distance([picture.x + x, picture.y + y], at) < 1.5);
  await page.locator("#ghosts .link").click();
  assert.equal(await page.locator(".traced-path:visible").count(), 0);
}));

test("a pinned design stays in the picture, its values beside those of another", () => visit("ellipse", async (page) => {
  const crank = () => page.locator("#dimensions-list dt", { hasText: "Crank" }).locator("+ dd");
  const first = await crank().textContent();
  await page.locator("#pin").click();
  await page.locator("#design-1").check();
  assert.ok(await page.locator(".pinned-line").evaluate((line) => line.getTotalLength() > 100));
  assert.equal(await crank().textContent(), `${first}8.2`);
  await page.locator("#pin").click();
  assert.equal(await crank().textContent(), "8.2");
  assert.equal(await page.locator(".pinned-line:visible").count(), 0);
}));

test("the wheel with Ctrl keeps what it points at, a drag moves the picture", () => visit("ellipse", async (page) => {
  const target = () => box(page, "#picture circle.target");
  const [x, y] = await target();
  await page.mouse.move(x, y);
  await page.keyboard.down("Control");
  for (let i = 0; i < 4; ++i) await page.mouse.wheel(0, -200);
  await page.keyboard.up("Control");
  await frame(page);
  // The mouse stands at whole pixels, and what is beside it goes away from it.
  const held = await target();
  assert.ok(distance(held, [x, y]) < 4, `${held} from ${[x, y]}`);
  const picture = await page.locator("#picture").boundingBox();
  const empty = [picture.x + 40, picture.y + 60];
  await page.mouse.move(...empty);
  await page.mouse.down();
  await page.mouse.move(empty[0] + 50, empty[1] + 30);
  await page.mouse.up();
  await frame(page);
  assert.ok(distance(await target(), [held[0] + 50, held[1] + 30]) < 1.5);
}));

// Corners of a path without curves.
const corners = (page, selector) => page.locator(selector).first().evaluate((line) => line.getAttribute("d").split(/[ML]/).slice(1).map((pair) => pair.split(" ").map(Number.parseFloat)));
const arrowOf = async (page, kind, index) => {
  const d = await page.locator(`.arrow.${kind} path:not(.halo)`).nth(index).getAttribute("d");
  const [from, to] = d.split(/[ML]/).slice(1, 3).map((pair) => pair.split(" ").map(Number));
  return [to[0] - from[0], to[1] - from[1]];
};
const circleAt = (page, selector) => page.locator(selector).evaluate((c) => ["cx", "cy"].map((key) => Number(c.getAttribute(key))));

// Against differences of the places that the kernel sampled.
const P = '.layer-pins [data-name="P"]';
for (const [name, point, of, drives] of some([["ellipse", "#coupler-point", "extra", [40, 130, 200, 290]], ["library-crank-rocker", P, "layer", [20, 60, 300, 330]],
  ["library-coupler-curve", P, "extra", [20, 100, 190, 260]]])) {
  test(`${name}: arrows of velocity and acceleration are the changes of the coupler point`, () => visit(name, async (page) => {
    for (const kind of ["velocity", "acceleration"]) await page.locator(`[data-${of}=${kind}]`).click();
    const sizes = { velocity: [], acceleration: [] };
    for (const at of drives) {
      const places = [];
      for (const step of [-6, 0, 6]) {
        await turnTo(page, at + step);
        places.push(await circleAt(page, point));
      }
      await turnTo(page, at);
      const differences = { velocity: [0, 1].map((k) => (places[2][k] - places[0][k]) / 2), acceleration: [0, 1].map((k) => places[2][k] - 2 * places[1][k] + places[0][k]) };
      for (const kind of ["velocity", "acceleration"]) {
        const arrows = await page.locator(`.arrow.${kind} path:not(.halo)`).evaluateAll((all, here) => all.findIndex((p) => {
          const [x, y] = p.getAttribute("d").split(/[ML]/)[1]?.split(" ").map(Number) ?? [NaN, NaN];
          return Math.hypot(x - here[0], y - here[1]) < 0.1;
        }), places[1]);
        const arrow = await arrowOf(page, kind, arrows);
        const wanted = differences[kind];
        const turned = Math.atan2(wanted[0] * arrow[1] - wanted[1] * arrow[0], wanted[0] * arrow[0] + wanted[1] * arrow[1]) * 180 / Math.PI;
        assert.ok(Math.abs(turned) < (kind === "velocity" ? 2 : 6), `${kind} at ${at}: ${turned}° off`);
        sizes[kind].push(Math.hypot(...arrow) / Math.hypot(...wanted));
      }
    }
    // One scale for all of a kind; the longest may be cut.
    for (const [kind, all] of Object.entries(sizes)) assert.ok(Math.max(...all) / Math.min(...all) < (kind === "velocity" ? 1.03 : 1.12), `${kind}: ${all}`);
  }));
}

test("the other assembly and the cognates are linkages, and cognates carry the coupler point", () => visit("ellipse", async (page) => {
  for (const kind of ["assembly", "cognate2", "cognate3"]) await toggle(page, kind);
  const lengths = {};
  for (const at of [10, 100, 190, 280]) {
    await turnTo(page, at);
    const p = await circleAt(page, "#coupler-point");
    for (const kind of ["assembly", "cognate2", "cognate3"]) {
      const joints = await corners(page, `.${kind} .ghost-links`);
      const plate = await corners(page, `.${kind} .ghost-plate`);
      const sides = [...joints.slice(1).map((q, i) => distance(q, joints[i])), distance(plate[2], plate[0]), distance(plate[2], plate[1])];
      (lengths[kind] ??= []).push(sides);
      if (kind !== "assembly") assert.ok(distance(plate[2], p) < 0.05, kind);
    }
  }
  for (const [kind, all] of Object.entries(lengths)) {
    for (const sides of all) sides.forEach((side, i) => assert.ok(Math.abs(side - all[0][i]) < 0.06, `${kind}: link ${i} is ${side} and ${all[0][i]}`));
  }
  assert.equal(await page.locator("#ghosts li").count(), 3);
  // Lengths of the cognate on A as multiples of those of the linkage: its first link is as long as
  // the coupler point is from B.
  const [, shown] = /links ([\d.]+)/.exec(await page.locator("#ghosts li").nth(1).textContent());
  assert.ok(Math.abs(Number(shown) - Math.hypot(10.6372, 2.29018)) < 1e-4, shown);
  await toggle(page, "assembly");
  assert.equal(await page.locator("#ghosts li").count(), 2);
}));

test("the other assembly of a slider-crank stands on the same slide, and is in the picture", () => visit("library-slider-crank-offset", async (page) => {
  await toggle(page, "assembly");
  for (const at of [20, 110, 200]) {
    await turnTo(page, at);
    const [b, c] = await Promise.all(["B", "C"].map((name) => circleAt(page, `.layer-pins [data-name="${name}"]`)));
    const other = (await corners(page, ".assembly .ghost-links")).at(-1);
    assert.ok(Math.abs(distance(b, other) - distance(b, c)) < 0.05 && Math.abs(other[1] - c[1]) < 0.05);
    assert.ok(distance(other, c) > 50 && other[0] > 40, `${other} beside ${c}`);
  }
  const near = distance(...await Promise.all(["A", "B"].map((name) => circleAt(page, `.layer-pins [data-name="${name}"]`))));
  await toggle(page, "assembly");
  assert.ok(distance(...await Promise.all(["A", "B"].map((name) => circleAt(page, `.layer-pins [data-name="${name}"]`)))) > 1.2 * near);
}));

test("the point leaves a trace", () => visit("ellipse", async (page) => {
  await toggle(page, "trace");
  for (let at = 10; at <= 60; at += 2) await turnTo(page, at);
  const trace = await corners(page, ".trace .old");
  assert.ok(trace.length >= 20);
  assert.ok(distance(trace.at(-1), await circleAt(page, "#coupler-point")) < 0.1);
  assert.equal(await page.locator("[data-extra=trace]").getAttribute("aria-pressed"), "true");
}));

test("the magnifier shows the errors of the result at a scale that is shown", () => visit("ellipse", async (page) => {
  await page.keyboard.press("m");
  const errors = await page.evaluate(() => {
    const { designs, target } = JSON.parse(document.getElementById("data").textContent);
    return target.points.map(([x, y], i) => Math.hypot(designs[0].reached[i][0] - x, designs[0].reached[i][1] - y));
  });
  const lens = page.locator(".lens");
  const worst = errors.indexOf(Math.max(...errors));
  assert.match(await lens.locator("p").textContent(), new RegExp(`^Target ${worst + 1}: `));
  const drawn = async () => {
    const [from, to] = await Promise.all([".lens .target", ".lens .coupler-point"].map((one) => circleAt(page, one)));
    const bar = await lens.locator(".scale-line").evaluate((line) => line.getBBox().width);
    const unit = (await lens.locator(".scale-text").textContent()).replace("−", "-");
    const [, mantissa, power] = /^([\d.]+)(?:×10(\S+))?/.exec(unit);
    const digits = { "⁻": "-", "⁰": 0, "¹": 1, "²": 2, "³": 3, "⁴": 4, "⁵": 5, "⁶": 6 };
    return (distance(from, to) / bar) * Number(mantissa) * 10 ** Number([...(power ?? "⁰")].map((c) => digits[c]).join(""));
  };
  assert.ok(Math.abs(await drawn() / errors[worst] - 1) < 0.01);
  // The exact curve leads through the point reached, to a pixel at this scale.
  const curve = await corners(page, ".lens path.path");
  const reached = await circleAt(page, ".lens .coupler-point");
  assert.ok(Math.min(...curve.map((p) => distance(p, reached))) < 1);
  await lens.focus();
  await page.keyboard.press("ArrowRight");
  const next = (worst + 1) % errors.length;
  assert.match(await lens.locator("p").textContent(), new RegExp(`^Target ${next + 1}: `));
  assert.ok(Math.abs(await drawn() / errors[next] - 1) < 0.01);
  const before = await lens.locator("p").textContent();
  await page.keyboard.press("ArrowUp");
  assert.notEqual(await lens.locator("p").textContent(), before);
  const third = await page.locator("#picture > svg circle.target").nth(2).boundingBox();
  await page.mouse.move(third.x + 6, third.y + 6);
  assert.match(await lens.locator("p").textContent(), /^Target 3: /);
}));

test("plots share a cursor that shows values and the place", { skip: withoutPlots }, () => visit("library-crank-rocker", async (page) => {
  const plot = page.locator("#plots .u-over").nth(1);
  await plot.scrollIntoViewIfNeeded();
  const area = await plot.boundingBox();
  await page.mouse.move(area.x + area.width / 4, area.y + area.height / 2);
  const cursors = await page.locator("#plots .hover-line:not([hidden])").evaluateAll((lines) => lines.map((l) => new DOMMatrix(getComputedStyle(l).transform).m41 / l.parentElement.clientWidth));
  assert.equal(cursors.length, await page.locator("#plots .u-over").count());
  for (const share of cursors) assert.ok(Math.abs(share - 0.25) < 0.01);
  assert.equal(Number.parseFloat(await page.locator("#drive-value").textContent()), 0);
  const hint = await circleAt(page, ".hint .ring >> nth=0");
  await page.mouse.move(5, 5);
  assert.equal(await page.locator("#plots .hover-line:not([hidden])").count(), 0);
  await turnTo(page, 90);
  assert.ok(distance(hint, await circleAt(page, '.layer-pins [data-name="P"]')) < 1.5);
}));

test("a plot turns into a table and back", { skip: withoutPlots }, () => visit("library-crank-rocker", async (page) => {
  const plot = page.locator("#plots .plot").first();
  await plot.locator(".as-table").click();
  const rows = await plot.locator("tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => Number(cell.textContent.replace("−", "-")))));
  const known = await page.evaluate(() => {
    const { table } = JSON.parse(document.getElementById("data").textContent);
    return { drive: table.drive, columns: table.columns.map((column) => column.values) };
  });
  assert.equal(rows.length, 37);
  for (const [at, ...values] of rows) {
    const i = known.drive.findIndex((drive) => Math.abs(drive - at) < 1e-6);
    for (const v of values) assert.ok(known.columns.some((column) => Math.abs(column[i] - v) < 1e-4 * Math.abs(v) + 1e-9), `${v} at ${at}`);
  }
  assert.equal(await plot.locator("canvas").isVisible(), false);
  await plot.locator(".as-table").click();
  assert.equal(await plot.locator("table").count(), 0);
}));

test("tables sort by any column, also by key, and hold their order when rewritten", () => visit("hundred", async (page) => {
  const values = () => page.locator("#designs tbody .main td:nth-child(2)").evaluateAll((cells) => cells.map((cell) => Number(cell.textContent.replace(/×10(.*)/, (_, p) => `e${[...p].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c)).map((k) => (k ? k - 1 : "-")).join("")}`))));
  const head = page.locator("#designs th").nth(1);
  const asWritten = await values();
  await head.locator("button").focus();
  await page.keyboard.press("Enter");
  const up = await values();
  assert.deepEqual(up, [...asWritten].sort((a, b) => a - b));
  assert.notDeepEqual(up, asWritten);
  assert.equal(await head.getAttribute("aria-sort"), "ascending");
  await page.keyboard.press("Enter");
  assert.deepEqual(await values(), [...asWritten].sort((a, b) => b - a));
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  await page.keyboard.press("Enter");
  assert.deepEqual(await values(), asWritten);
  assert.equal(await head.getAttribute("aria-sort"), null);

  const names = () => page.locator("#checks td:first-child").evaluateAll((cells) => cells.map((cell) => cell.textContent));
  await page.locator(".checks th button").first().click();
  const sorted = await names();
  assert.deepEqual(sorted, [...sorted].sort(new Intl.Collator("en", { numeric: true }).compare));
  await page.locator("#design-4").check();
  const others = await names();
  assert.deepEqual(others, [...others].sort(new Intl.Collator("en", { numeric: true }).compare));
  assert.equal(await page.locator(".checks th").first().getAttribute("aria-sort"), "ascending");
}));

test("the keys are listed, and letters can be switched off", () => visit("ellipse", async (page) => {
  await page.keyboard.press("?");
  assert.ok(await page.locator("dialog kbd").count() > 15);
  await page.locator("#help-letters").uncheck();
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("dialog[open]").count(), 0);
  await page.keyboard.press("m");
  assert.equal(await page.locator(".lens").isVisible(), false);
  await page.keyboard.press("?");
  await page.locator("#help-letters").check();
  await page.locator("dialog button").click();
  await page.keyboard.press("m");
  assert.equal(await page.locator(".lens").isVisible(), true);
}));

test("a screen reader speaks the position at which the picture stops, and every control has a name and shows its focus", () => visit("library-crank-rocker", async (page) => {
  await turnTo(page, 120);
  await page.waitForFunction(() => /120/.test(document.getElementById("live").textContent));
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, [tabindex='0']")].filter((part) => part.checkVisibility())
    .filter((part) => !(part.getAttribute("aria-label") || part.textContent.trim() || part.labels?.length || part.getAttribute("aria-labelledby"))).map((part) => part.outerHTML.slice(0, 80)));
  assert.deepEqual(nameless, []);
  // Through the whole page with the tabulator, each stop once, and out of it again.
  const stops = await page.evaluate(() => [...document.querySelectorAll("button, input, select, a[href], summary, [tabindex='0']")].filter((part) => part.checkVisibility() && !part.disabled).length);
  await page.locator("#language").focus();
  let seen = 1;
  for (; seen < stops + 5; ++seen) {
    await page.keyboard.press("Tab");
    const now = await page.evaluate(() => ({ out: document.activeElement === document.body, ring: getComputedStyle(document.activeElement).outlineStyle }));
    if (now.out) break;
    assert.notEqual(now.ring, "none");
  }
  assert.ok(seen <= stops + 2 && seen > 10, `${seen} of ${stops}`);
}));

// Relative luminance and contrast by WCAG 2.2.
const luminance = (rgb) => {
  const [r, g, b] = rgb.map((v) => v / 255).map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const contrast = (p, q) => {
  const [a, b] = [luminance(p), luminance(q)].sort((x, y) => y - x);
  return (a + 0.05) / (b + 0.05);
};
const TEXTS = [["--ink", "--card"], ["--ink", "--page"], ["--soft", "--card"], ["--soft", "--page"], ["--accent", "--card"], ["--accent", "--page"], ["--accent", "--accent-soft"],
  ["--ink", "--accent-soft"], ["--soft", "--accent-soft"], ["--good", "--good-soft"], ["--warn", "--warn-soft"], ["--bad", "--bad-soft"], ["--ink", "--bad-soft"], ["--good", "--card"], ["--bad", "--card"], ["--target", "--page"]];
const SIGNS = ["--crank", "--coupler", "--rocker", "--ground", "--curve", "--target", "--error", "--velocity", "--acceleration", "--ghost-assembly", "--ghost-cognate2", "--ghost-cognate3", "--accent"];
for (const scheme of ["light", "dark"]) {
  test(`texts and signs stand out in ${scheme} colours`, () => visit("ellipse", async (page) => {
    const rgb = await page.evaluate((names) => {
      const probe = document.body.appendChild(document.createElement("i"));
      return Object.fromEntries(names.map((name) => { probe.style.color = `var(${name})`; return [name, getComputedStyle(probe).color.match(/\d+/g).slice(0, 3).map(Number)]; }));
    }, [...new Set([...TEXTS.flat(), ...SIGNS])]);
    for (const [text, ground] of TEXTS) assert.ok(contrast(rgb[text], rgb[ground]) >= 4.5, `${text} on ${ground}: ${contrast(rgb[text], rgb[ground]).toFixed(2)}`);
    for (const sign of SIGNS) assert.ok(contrast(rgb[sign], rgb["--page"]) >= 3, `${sign}: ${contrast(rgb[sign], rgb["--page"]).toFixed(2)}`);
  }, { ...still, scheme }));
}

// Pages of a PDF and how much is drawn on each: the lengths of their content streams.
for (const name of some(["ellipse", "cam-translating-roller", "gear-pair"])) {
  test(`${name} on paper: as wide as the page, no page empty`, () => visit(name, async (page) => {
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    await page.emulateMedia({ media: "print" });
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "light");
    const room = await page.evaluate(() => {
      const body = document.body.getBoundingClientRect();
      const outside = [...document.querySelectorAll("svg, canvas, table, dl, p")].filter((part) => part.checkVisibility() && !part.closest(".unseen, .u-over") && part.getBoundingClientRect().right > body.right + 1);
      return { width: body.width, outside: outside.map((part) => part.className.baseVal ?? part.className ?? part.tagName), buttons: [...document.querySelectorAll(".controls, .picture-tools, .parts, .pin-toggle, .edit-toggle")].filter((part) => part.checkVisibility()).length };
    });
    assert.ok(Math.abs(room.width - (182 / 25.4) * 96) < 1, `${room.width}`);
    assert.deepEqual(room.outside, []);
    assert.equal(room.buttons, 0);
    // No value is broken between its letters for want of room.
    const lines = await page.evaluate(() => [...document.querySelectorAll(".facts dd")].filter((part) => part.checkVisibility() && part.textContent.length < 32).map((part) => part.getBoundingClientRect().height / parseFloat(getComputedStyle(part).lineHeight)));
    assert.ok(Math.max(...lines) < 3.5, `${Math.max(...lines)} lines`);
    const height = (297 - 26) / 25.4 * 96;
    // The table of two gears is overleaf.
    const first = name === "gear-pair" ? ["#picture", "#legend"] : ["#picture", "#dimensions", "#legend"];
    const ends = await page.evaluate((parts) => parts.map((part) => document.querySelector(part).getBoundingClientRect().bottom), first);
    assert.ok(Math.max(...ends) < height, `${ends} do not fit the first page of ${height}`);
    const pdf = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
    const sheets = pdf.match(/\/Type\s*\/Page\b/g).length;
    const tall = await page.evaluate(() => document.body.scrollHeight);
    // Cards are not split, and leave room at the foot of a page.
    assert.ok(sheets <= 2 * Math.ceil(tall / height), `${sheets} pages of ${tall} pixels`);
  }, { ...still, scheme: "dark" }));
}

test("pages stay below 1.6 MB", () => {
  const pages = readdirSync(process.env.REPORTS).filter((name) => name.endsWith(".html"));
  assert.ok(KINDS.every((name) => pages.includes(`${name}.html`)));
  for (const name of pages) {
    const { size } = statSync(path.join(process.env.REPORTS, name));
    assert.ok(size < 1.6e6, `${name}: ${size} bytes`);
  }
});
