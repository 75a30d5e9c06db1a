// The page of `cognate studio`, served by the program COGNATE.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { assertFits, launch, LOOKS, SIZES } from "./browser.mjs";

const PROBLEM = 'kind = "quick-return"\ntitle = "Slow out, quick back"\n\n[target]\ntime_ratio = 1.25\n[mechanism]\nrocker = 290\nswing_deg = 34\n';
const ENDLESS = 'kind = "path-generation"\n[target]\npoints = [[0, 0], [1, 0.3], [2, 0.1], [3, 1], [2, 2], [1, 1.5], [0.5, 1]]\n[constraints]\nclass = "crank-rocker"\npeak_acceleration_max = 1\n[solve]\nstarts = 10000\n';

let browser, folder, file, studio;
before(async () => { browser = await launch(); });
after(() => browser?.close());
beforeEach(() => {
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-studio-"));
  file = path.join(folder, "rocker.toml");
  fs.writeFileSync(file, PROBLEM);
});
afterEach(async () => {
  if (studio?.exitCode === null) {
    studio.kill("SIGINT");
    await new Promise((resolve) => studio.once("exit", resolve));
  }
  fs.rmSync(folder, { recursive: true });
});

// The address at which the program serves `named`.
function serve(...named) {
  studio = spawn(process.env.COGNATE, ["studio", ...named, "--no-open"], { stdio: ["ignore", "pipe", "inherit"] });
  return new Promise((resolve) => studio.stdout.once("data", (text) => resolve(String(text).split("\n")[0])));
}

// A page of `address`, whose own origin is all that it asks; messages of the console are faults.
async function visit(address, { size = "desktop", scheme = "light", locale = "en-GB" }, steps) {
  const context = await browser.newContext({ viewport: SIZES[size], colorScheme: scheme, locale, reducedMotion: "reduce", acceptDownloads: true });
  const page = await context.newPage(), faults = [];
  const { origin } = new URL(address);
  context.on("console", (message) => faults.push(message.text()));
  context.on("weberror", (error) => faults.push(String(error.error())));
  context.on("request", (request) => { if (!request.url().startsWith(`${origin}/`) && !/^(data|blob):/.test(request.url())) faults.push(request.url()); });
  await page.goto(address);
  await steps(page, faults);
  assert.deepEqual(faults, []);
  await context.close();
}

const report = (page) => page.frameLocator("#report");
const verdict = (page, pattern) => page.waitForFunction((source) => new RegExp(source, "u").test(document.getElementById("verdict").textContent), pattern.source);
const type = (page, text) => page.locator("#text").fill(text);

for (const look of LOOKS) {
  test(`a fault stands at its line, and a problem is solved (${look.size})`, async () => {
    await visit(await serve(file), look, async (page) => {
      await verdict(page, /✓ Slow out, quick back: quick return/);
      await type(page, PROBLEM.replace("time_ratio", "time_ration"));
      await verdict(page, /✗ \d fault/);
      const faulty = await page.locator("#lines .faulty").allTextContents();
      assert.ok(faulty.includes("5\n"), String(faulty));
      const mark = page.locator("#marks .faulty", { hasText: "time_ration = 1.25" });
      assert.match(await mark.textContent(), /unknown key "time_ration"/);
      // Beside the line in the editor, not only somewhere.
      const [line, own] = await Promise.all([page.locator("#lines span").nth(4).boundingBox(), mark.boundingBox()]);
      assert.ok(Math.abs(line.y - own.y) < 4, `${line.y} ${own.y}`);
      await page.locator("#faults button").first().click();
      assert.equal(await page.evaluate(() => document.activeElement.id), "text");
      await page.locator("#solve").click();
      assert.equal(await page.locator("#report").isVisible(), false);
      await type(page, PROBLEM);
      await verdict(page, /✓/);
      assert.equal(await page.locator("#faults li").count(), 0);
      await page.locator("#text").press("Control+Enter");
      await report(page).locator("#picture .link-body").first().waitFor();
      assert.equal(await report(page).locator("h1").textContent(), "Slow out, quick back");
      assert.match(await page.locator("#run-state").textContent(), /^Solved · /);
      await assertFits(page);
    });
  });
}

test("a search is watched, stopped and replaced", async () => {
  fs.writeFileSync(file, ENDLESS);
  await visit(await serve(file), {}, async (page) => {
    await verdict(page, /✓/);
    await page.locator("#solve").click();
    await page.waitForFunction(() => /\d % · [1-9]\d* s · search · \d+:\d\d left/.test(document.getElementById("run-state").textContent));
    await page.locator("#stop").click();
    await report(page).locator("#status").waitFor();
    assert.match(await page.locator("#run-state").textContent(), /^Interrupted/);
    await page.locator("#solve").click();
    await page.waitForFunction(() => !document.getElementById("stop").disabled);
    await type(page, PROBLEM);
    await page.locator("#solve").click();
    await report(page).locator("h1", { hasText: "Slow out" }).waitFor();
  });
});

test("a file is saved, and what others save is taken or asked about", async () => {
  await visit(await serve(file), {}, async (page) => {
    await verdict(page, /✓/);
    await type(page, `${PROBLEM}# mine\n`);
    assert.ok(await page.locator("#dirty").isVisible());
    await page.locator("#text").press("Control+s");
    await page.locator("#dirty").waitFor({ state: "hidden" });
    assert.equal(fs.readFileSync(file, "utf8"), `${PROBLEM}# mine\n`);
    fs.writeFileSync(file, `${PROBLEM}# theirs\r\n`);
    await page.waitForFunction(() => document.getElementById("text").value.endsWith("# theirs\n"));
    assert.ok(!await page.locator("#dirty").isVisible());
    await type(page, `${PROBLEM}# mine again\n`);
    fs.writeFileSync(file, `${PROBLEM}# theirs again\n`);
    await page.locator('[data-action="keep"]').click();
    assert.match(await page.locator("#text").inputValue(), /# mine again/);
    await page.locator("#save-text").click();
    await page.locator("#dirty").waitFor({ state: "hidden" });
    assert.match(fs.readFileSync(file, "utf8"), /# mine again/);
    await type(page, "something else");
    fs.writeFileSync(file, PROBLEM);
    await page.locator('[data-action="load"]').click();
    assert.equal(await page.locator("#text").inputValue(), PROBLEM);
    assert.ok(!await page.locator("#notice").isVisible());
  });
});

test("without a file a template is the begin, and a download the end", async () => {
  await visit(await serve(), { locale: "zh-CN" }, async (page) => {
    await verdict(page, /✓/);
    assert.equal(await page.evaluate(() => document.documentElement.lang), "zh-Hans");
    await page.locator("#template").selectOption("new/cam");
    await verdict(page, /cam/);
    await page.locator("#live").check();
    const text = await page.locator("#text").inputValue();
    await type(page, `${text}# one more\n`);
    await report(page).locator("h1").waitFor();
    const [saved] = await Promise.all([page.waitForEvent("download"), page.locator("#save-text").click()]);
    assert.match(fs.readFileSync(await saved.path(), "utf8"), /# one more/);
    await page.locator("#theme").selectOption("dark");
    assert.equal(await report(page).locator("html").getAttribute("data-theme"), "dark");
    const [sketch] = await Promise.all([page.context().waitForEvent("page"), page.locator("#template").selectOption("sketch")]);
    await sketch.locator("#hint").waitFor();
  });
});

// What is saved by a click on a button, by names.
async function savedFiles(page, button, count) {
  const downloads = [];
  page.on("download", (one) => downloads.push(one));
  await page.locator(button).click();
  while (downloads.length < count) await page.waitForEvent("download");
  return Object.fromEntries(await Promise.all(downloads.map(async (one) => [one.suggestedFilename(), fs.readFileSync(await one.path(), "utf8")])));
}

test("parts, tables and the report are taken along", async () => {
  await visit(await serve(file), {}, async (page) => {
    await verdict(page, /✓/);
    assert.ok(!await page.locator("#taking").isVisible());
    await page.locator("#solve").click();
    await report(page).locator("h1").waitFor();
    await page.locator("#taking summary").click();
    // At first the linkage itself is seen.
    await page.locator("#taking-picture").waitFor();
    assert.ok(await page.locator("#take-design option").count() > 0);
    const before = await page.locator("#taking-picture").getAttribute("src");
    assert.ok(!await page.locator("[data-option=hole]").isVisible());
    await page.locator("[data-option=parts]").check();
    await page.locator("#taking-said .bad").waitFor();
    for (const [option, value] of [["hole", "3"], ["width", "2"], ["thickness", "3"]]) await page.locator(`[data-option=${option}]`).fill(value);
    await page.waitForFunction(() => /--width/.test(document.getElementById("taking-said").innerText));
    assert.match(await page.locator("#taking-said").innerText(), /--width: 2 leaves nothing about a hole of 3/);
    await page.locator("[data-option=width]").fill("8");
    await page.waitForFunction((old) => document.getElementById("taking-picture").src !== old && !document.querySelector("#taking-said .bad"), before);
    assert.match(decodeURIComponent(await page.locator("#taking-picture").getAttribute("src")), /class="outlines"/);
    await page.locator("[data-option=bill]").check();
    const files = await savedFiles(page, "#taking [data-take=save]", 2);
    assert.deepEqual(Object.keys(files).toSorted(), ["rocker.bill.csv", "rocker.parts.dxf"]);
    assert.match(files["rocker.parts.dxf"], /OUTLINES/);
    assert.match(files["rocker.bill.csv"], /plate/);
    for (const option of ["hole", "width", "thickness"]) await page.locator(`[data-option=${option}]`).fill("");
    for (const option of ["bill", "parts"]) await page.locator(`[data-option=${option}]`).uncheck();
    await page.locator("#take-format").selectOption("csv");
    await page.locator("#taking-picture").waitFor({ state: "hidden" });
    await page.locator("[data-option=steps]").fill("12");
    const [table] = Object.values(await savedFiles(page, "#taking [data-take=save]", 1));
    assert.equal(table.trim().split("\n").length, 14);
    const kept = await savedFiles(page, "#taking [data-take=report]", 1);
    assert.match(kept["rocker.report.html"], /cognate-result\/1/);
    await assertFits(page);
  });
});

for (const [name, steps, pattern] of [["sketch", async (page) => {
  const box = await page.locator("#sheet").boundingBox(), at = (t) => [box.x + box.width * (0.5 + 0.15 * Math.cos(t)), box.y + box.height * (0.45 - 0.2 * Math.sin(t))];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let i = 1; i <= 40; ++i) await page.mouse.move(...at((2 * Math.PI * i) / 40));
  await page.mouse.up();
}, /path generation/], ["mechanism", (page) => page.locator("[data-example=four_bar]").click(), /four-bar|analysis|mechanism/i]]) {
  test(`what is drawn on the page ${name} goes to the studio`, async () => {
    const address = await serve(file);
    await visit(address.replace("/?", `/${name}?`), {}, async (page) => {
      await steps(page);
      await page.locator("[data-take=problem_to_studio]").click();
      await verdict(page, /✓/);
      assert.match(await page.locator("#verdict").textContent(), pattern);
      assert.ok(await page.locator("#dirty").isVisible());
      assert.equal(fs.readFileSync(file, "utf8"), PROBLEM);
      await page.locator("#solve").click();
      await report(page).locator("#picture").waitFor({ timeout: 60000 });
    });
  });
}
