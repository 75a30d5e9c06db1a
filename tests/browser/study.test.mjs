// The page of a study as a reader meets it, and its closure against the analysis kernel.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { after, before } from "node:test";
import { Closure } from "../../app/report/page/study/closure.js";
import { RowLinkage } from "../../app/report/page/study/linkage.js";
import { assertFits, launch, LOOKS, visit as visitReport } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

const hasPlots = process.env.HAS_CURVES !== "0";
const plotted = { skip: !hasPlots && "made without d3" };
const still = { motion: "reduce" };
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());
const visit = (name, options, steps) => visitReport(browser, `study-${name}`, options, steps);

const shownCount = async (page) => Number((await page.locator("#count").textContent()).split(" ")[0].replaceAll(",", ""));
const dataOf = (page) => page.evaluate(() => JSON.parse(document.getElementById("data").textContent));
const values = (column) => column.values ?? column.index.map((i) => (i < 0 ? null : column.levels[i]));
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const inkOf = (page, selector) => page.locator(selector).evaluate((canvas) => {
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  let ink = 0;
  for (let i = 3; i < data.length; i += 4) ink += data[i] > 0;
  return ink;
});

// Of lengths of a few units. Every tenth linkage all but folds flat, where places lose digits.
test("the page's closure is the kernel's", () => {
  let open = 0;
  for (const [n, { linkage, angles, points }] of JSON.parse(readFileSync(path.join(process.env.REPORTS, "poses.json"), "utf8")).entries()) {
    const tolerance = n % 10 === 0 ? 1e-9 : 1e-12;
    const closure = new Closure(linkage);
    angles.forEach((angle, i) => {
      const pose = closure.at(angle - closure.frameAngle);
      if (points[i] === null || pose === null) return assert.equal(pose, points[i]);
      [...pose.b, ...pose.c, ...pose.p].forEach((x, k) => assert.ok(Math.abs(x - points[i][k]) < tolerance, `${x} for ${points[i][k]}`));
      open += 1;
    });
  }
  assert.ok(open > 3000, `${open} poses compared`);
});

// A double-rocker's coupler point runs through its whole circuit and back to where it was.
test("a crank that does not turn fully goes on in the other assembly", () => {
  const linkage = new RowLinkage({ fixed_pivots: [[0, 0], [4, 0]], crank: 3, coupler: 1.5, rocker: 3.2, assembly: "open", coupler_point: [1, 1] });
  assert.equal(linkage.fullTurn, false);
  const poses = linkage.poses(4000);
  assert.equal(poses.length, 4001);
  for (let i = 1; i < poses.length; ++i) {
    assert.ok(Math.hypot(poses[i].p[0] - poses[i - 1].p[0], poses[i].p[1] - poses[i - 1].p[1]) < 0.02);
    assert.ok(Math.abs(Math.hypot(poses[i].c[0] - 4, poses[i].c[1]) - 3.2) < 1e-9);
  }
});

// As circuit_at has it, whose test has the same linkage: the coupler is the shortest link.
test("of two circuits the one that the drive starts on is drawn, or reaches first", () => {
  const links = { fixed_pivots: [[0, 0], [1.6, 0]], crank: 2, coupler: 1, rocker: 1.9, assembly: "open" };
  const isUpper = (start) => new RowLinkage({ ...links, start }).poses(100).every(({ b }) => b[1] > 0);
  const upper = new RowLinkage({ ...links, start: 0 });
  const middle = (upper.from + upper.to) / 2;
  for (const [start, expected] of [[middle, true], [-middle, false], [2 * Math.PI + middle, true], [0, true], [Math.PI, false]]) {
    assert.equal(isUpper(start), expected, `from ${start}`);
  }
});

for (const { size, scheme } of LOOKS) {
  for (const name of some(["grid", "sobol", "atlas", "hostile", "empty"])) {
    test(`${name} fits a ${size} in ${scheme} colours`, () => visit(name, { size, scheme, ...still }, async (page) => {
      await assertFits(page);
      if (hasPlots && name !== "empty") {
        for (const canvas of ["#axes canvas:nth-of-type(2)", "#scatter-plane canvas", "#contour-plane canvas"]) assert.ok(await inkOf(page, canvas) > 300, canvas);
      }
      assert.doesNotMatch(await page.locator("main").innerHTML(), /NaN|undefined|Infinity/);
    }));
  }
}

test("five thousand rows open quickly and are all there", () => visit("sobol", still, async (page) => {
  assert.equal(await shownCount(page), 5000);
  const { size, opened } = await page.evaluate(() => ({ size: document.documentElement.outerHTML.length, opened: performance.getEntriesByType("navigation")[0].loadEventEnd }));
  assert.ok(size < 1.6e6, `${size} characters`);
  assert.ok(opened > 0);
}));

test("a range of a column filters the page", () => visit("grid", still, async (page) => {
  const data = await dataOf(page);
  const size = values(data.columns.find((c) => c.name === "size"));
  await page.locator("#columns summary").click();
  await page.getByLabel("Maximum size").fill("300");
  await page.getByLabel("Maximum size").press("Tab");
  await settled(page);
  const expected = size.filter((v) => v <= 300).length;
  assert.ok(expected > 10 && expected < size.length);
  assert.equal(await shownCount(page), expected);
  await page.locator("#rows th button", { hasText: "Size" }).click();
  await page.locator("#rows th button", { hasText: "Size" }).click();
  assert.equal(await page.locator("#rows-rows tr").first().locator("td").last().textContent(), String(Math.max(...size.filter((v) => v <= 300))));
  await page.locator("#clear").click();
  assert.equal(await shownCount(page), size.length);
}));

test("a brush on an axis filters, with two brushes what passes both", plotted, () => visit("sobol", still, async (page) => {
  const data = await dataOf(page);
  const columns = data.columns.slice(1, 3).map(values);
  const ranges = [];
  await page.locator("#axes").scrollIntoViewIfNeeded();
  for (const i of [1, 2]) {
    const box = await page.locator(".brush .overlay").nth(i).boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y];
    await page.mouse.move(x, y + 0.2 * box.height);
    await page.mouse.down();
    await page.mouse.move(x, y + 0.4 * box.height, { steps: 4 });
    await page.mouse.move(x, y + 0.5 * box.height, { steps: 4 });
    await page.mouse.up();
    await settled(page);
    const [least, greatest] = [Math.min(...columns[i - 1]), Math.max(...columns[i - 1])];
    const room = 0.01 * (greatest - least);
    const at = (share) => greatest + room - share * (greatest - least + 2 * room);
    ranges.push([at(0.5), at(0.2)]);
  }
  const expected = columns[0].filter((_, row) => columns.every((column, i) => column[row] >= ranges[i][0] && column[row] <= ranges[i][1])).length;
  // A pixel more or less.
  assert.ok(Math.abs(await shownCount(page) - expected) < 0.06 * expected + 3, `${await shownCount(page)} for ${expected}`);
  await page.locator("#clear").click();
  await settled(page);
  assert.equal(await shownCount(page), 5000);
  assert.equal(await page.locator(".brush .selection:visible").count(), 0);
}));

test("columns are named in words, and the best rows come first", () => visit("grid", { ...still, locale: "zh-CN" }, async (page) => {
  const heads = await page.locator("#rows th").allTextContents();
  for (const word of ["连杆", "摇杆", "曲柄"]) assert.ok(heads.includes(word), `${heads}`);
  const data = await dataOf(page);
  const stars = await page.locator("#rows-rows tr").evaluateAll((rows) => rows.map((row) => row.textContent.includes("★")));
  assert.ok(data.best.length > 0);
  assert.deepEqual(stars, stars.map((_, i) => i < data.best.length));
}));

test("words filter too", () => visit("sobol", still, async (page) => {
  const data = await dataOf(page);
  const type = data.columns.find((c) => c.name === "type");
  await page.locator("#columns summary").click();
  for (const end of ["First", "Last"]) await page.getByLabel(`${end} type`).selectOption({ label: "crank-rocker" });
  await settled(page);
  assert.equal(await shownCount(page), values(type).filter((v) => v === "crank-rocker").length);
}));

test("a click on a point opens its design, with its file and its command", plotted, () => visit("grid", still, async (page) => {
  await page.locator("#rows-rows tr").nth(3).locator("button").click();
  const shown = () => page.locator("#design-values dd").evaluateAll((list) => list.slice(3).map((dd) => dd.textContent));
  const chosen = await shown();
  const circle = await page.locator("#scatter-plane .chosen").evaluate((c) => [Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))]);
  await page.locator("#next").click();
  assert.notDeepEqual(await shown(), chosen);
  await page.locator("#scatter-plane svg").click({ position: { x: circle[0], y: circle[1] } });
  // Coupler and rocker exchanged give the same size and transmission angle.
  const now = await shown();
  for (const i of [0, 2]) assert.equal(now[i], chosen[i]);
  const id = (await page.locator("#design-title").textContent()).match(/\d+/)[0];
  assert.match(await page.locator("#design-command").textContent(), new RegExp(`--row ${id}$`));
  const data = await dataOf(page);
  const row = data.ids.indexOf(Number(id));
  const text = await page.locator("#design-text").textContent();
  for (const [key, column] of [["coupler", 0], ["rocker", 1], ["crank", 2]]) assert.match(text, new RegExp(`^${key} = ${values(data.columns[column])[row]}$`, "m"));
}));

test("the linkage drawn has the lengths of its row", () => visit("grid", still, async (page) => {
  const data = await dataOf(page);
  const row = data.ids.indexOf(Number((await page.locator("#design-title").textContent()).match(/\d+/)[0]));
  await page.locator("#drive").evaluate((input) => { input.value = 70; input.dispatchEvent(new Event("input")); });
  const pins = await page.locator("#picture .pin").evaluateAll((circles) => circles.map((c) => [Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))]));
  const [a, d, b, c] = pins;
  const length = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]) / (Math.hypot(a[0] - d[0], a[1] - d[1]) / 100);
  const [coupler, rocker, crank] = data.columns.slice(0, 3).map((column) => values(column)[row]);
  for (const [drawn, wanted] of [[length(a, b), crank], [length(b, c), coupler], [length(d, c), rocker]]) assert.ok(Math.abs(drawn - wanted) < 0.05, `${drawn} for ${wanted}`);
  const angle = Math.atan2(a[1] - b[1], b[0] - a[0]) * 180 / Math.PI;
  assert.ok(Math.abs(angle - 70) < 0.1, String(angle));
}));

test("the linkage moves by itself", () => visit("sobol", {}, async (page) => {
  const from = Number(await page.locator("#drive").inputValue());
  await page.waitForFunction((start) => Math.abs(Number(document.getElementById("drive").value) - start) > 5, from);
}));

// Between the nodes of a grid the level lines of a sum of two columns are straight.
test("the map of a grid shows its levels, and the other columns are held", plotted, () => visit("grid", still, async (page) => {
  await page.locator("#contour [data-choice=z]").selectOption({ label: "Size" });
  const before = await inkOf(page, "#contour-plane canvas");
  assert.ok(before > 20000);
  assert.equal(await page.locator("#methods button").count(), 3);
  assert.equal(await page.locator("[data-method=grid]").getAttribute("aria-pressed"), "true");
  const tone = (x, y) => page.locator("#contour-plane canvas").evaluate((canvas, [u, v]) => {
    const ratio = canvas.width / canvas.clientWidth;
    const pixel = new OffscreenCanvas(1, 1).getContext("2d");
    pixel.drawImage(canvas, -Math.round(u * ratio), -Math.round(v * ratio));
    return [...pixel.getImageData(0, 0, 1, 1).data].join(" ");
  }, [x, y]);
  const ticks = await page.locator("#contour-plane .tick-text").evaluateAll((texts) => texts.map((t) => [Number(t.textContent), Number(t.getAttribute("x")), Number(t.getAttribute("y")), t.getAttribute("text-anchor")]));
  const along = (anchor, axis) => { const [p, q] = ticks.filter((t) => t[3] === anchor).slice(1, 3); return (v) => p[axis] + (v - p[0]) / (q[0] - p[0]) * (q[axis] - p[axis]) - (axis === 2 ? 4 : 0); };
  const [px, py] = [along("middle", 1), along("end", 2)];
  // coupler + rocker = 172 on a line, within one band of ten.
  const first = await tone(px(86.5), py(85.5));
  for (const [x, y] of [[91.5, 80.5], [96.5, 75.5]]) assert.equal(await tone(px(x), py(y)), first);
  assert.notEqual(await tone(px(106.5), py(95.5)), first);
  await page.getByLabel("mechanism.crank held at").selectOption({ label: "35" });
  assert.notEqual(await tone(px(86.5), py(85.5)), first);
  for (const method of ["triangles", "bins"]) {
    await page.locator(`[data-method=${method}]`).click();
    assert.ok(await inkOf(page, "#contour-plane canvas") > 10000, method);
  }
}));

test("axes are moved, turned over and hidden by keys", plotted, () => visit("grid", still, async (page) => {
  const names = () => page.locator(".axis-names button").evaluateAll((buttons) => buttons.map((b) => b.dataset.column));
  assert.deepEqual(await names(), ["0", "1", "2", "3", "4", "5"]);
  await page.locator(".axis-names button").first().focus();
  await page.keyboard.press("ArrowRight");
  assert.deepEqual(await names(), ["1", "0", "2", "3", "4", "5"]);
  const ticks = () => page.locator("#axes g").nth(1).locator(".tick-text").evaluateAll((texts) => texts.map((t) => Number(t.getAttribute("y"))));
  const before = await page.locator("#axes .tick-text").first().getAttribute("y");
  await page.locator(".axis-names button").first().press("Enter");
  assert.notEqual(await page.locator("#axes .tick-text").first().getAttribute("y"), before);
  assert.ok((await ticks()).every(Number.isFinite));
  await page.locator(".axis-names button").nth(1).press("Delete");
  assert.deepEqual(await names(), ["1", "2", "3", "4", "5"]);
  await page.locator("#columns summary").click();
  await page.getByLabel("Show mechanism.coupler", { exact: true }).check();
  assert.equal((await names()).length, 6);
}));

test("arrow keys step through the points, zoom keeps the row", plotted, () => visit("grid", still, async (page) => {
  const before = await page.locator("#design-title").textContent();
  await page.locator("#scatter-plane svg").focus();
  await page.keyboard.press("ArrowRight");
  const after = await page.locator("#design-title").textContent();
  assert.notEqual(after, before);
  await page.locator("#zoom-in").click();
  await settled(page);
  assert.equal(await page.locator("#design-title").textContent(), after);
}));

test("pointing at a point shows its values", plotted, () => visit("grid", still, async (page) => {
  const at = await page.locator("#scatter-plane .chosen").evaluate((c) => [Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))]);
  await page.locator("#scatter-plane svg").hover({ position: { x: at[0], y: at[1] } });
  assert.match(await page.locator("#scatter-plane .tip").textContent(), /Design .*Size: /);
}));

test("the rows that pass are saved as CSV", () => visit("grid", still, async (page) => {
  await page.locator("#columns summary").click();
  await page.getByLabel("Maximum size").fill("280");
  await page.getByLabel("Maximum size").press("Tab");
  await settled(page);
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#save-rows").click()]);
  const lines = readFileSync(await download.path(), "utf8").trim().split("\n");
  assert.equal(lines[0].split(",")[1], "mechanism.coupler");
  assert.equal(lines.length - 1, await shownCount(page));
  assert.ok(lines.slice(1).every((line) => Number(line.split(",").at(-1)) <= 280));
}));

test("the curves of one linkage stand together, and each opens its design", plotted, () => visit("atlas", still, async (page) => {
  assert.equal(await page.locator("#curves-of-linkages h3").count(), 2);
  assert.equal(await page.locator(".curves-of-one").first().locator("button").count(), 25);
  await page.locator("#atlas [data-step='1']").click();
  assert.match(await page.locator("#curves-of-linkages h3").first().textContent(), /coupler 4 · rocker 2\.5 · frame 3\.333/);
  await page.locator(".curves-of-one button").nth(7).click();
  assert.match(await page.locator("#curves-of-linkages [aria-pressed=true]").getAttribute("aria-label"), new RegExp(`${(await page.locator("#design-title").textContent()).match(/\d+/)[0]}$`));
}));

test("text stays text, and an interrupted study says how far it came", () => visit("hostile", still, async (page) => {
  assert.doesNotMatch(await page.title(), /^injected$/);
  assert.match(await page.locator("#title").textContent(), /<\/script>/);
  assert.equal(await page.locator("main img").count(), 0);
  assert.equal(await page.locator("#status").textContent(), "Interrupted");
  assert.match(await page.locator("#summary").textContent(), /45 of 90 designs evaluated so far/);
  assert.equal(await page.locator("#linkage").isVisible(), false);
}));

test("a study without rows says so", () => visit("empty", still, async (page) => {
  assert.match(await page.locator("#axes").textContent(), /No row was kept|without d3/);
  assert.equal(await page.locator("#design-none").isVisible(), true);
}));
