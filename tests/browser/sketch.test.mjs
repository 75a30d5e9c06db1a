// The page of `cognate sketch`: a curve is drawn, and linkages trace it.
import assert from "node:assert/strict";
import fs from "node:fs";
import { assertFits, distance, moves, open } from "./browser.mjs";
import { rarely as test, some, wholeOnly } from "./thinned.mjs";
import { clearanceOf, couplerPose } from "./closures.mjs";
import { addressOf, answered, browser, draw, facts, file, hasKernel, hold, holding, offered, settled, targets, visit } from "./sketching.mjs";

const ellipse = (t) => [0.5 + 0.16 * Math.cos(t), 0.45 - 0.2 * Math.sin(t)];

const FINE = 100000;

function distanceToChord(p, q, r) {
  const way = [r[0] - q[0], r[1] - q[1]];
  const share = Math.min(1, Math.max(0, ((p[0] - q[0]) * way[0] + (p[1] - q[1]) * way[1]) / (way[0] ** 2 + way[1] ** 2)));
  return distance(p, [q[0] + share * way[0], q[1] + share * way[1]]);
}

// Of each point the distance to the curve of the design, over a fine turn.
function misses(design) {
  const curve = Array.from({ length: FINE + 1 }, (_, i) => couplerPose(design, (2 * Math.PI * i) / FINE)?.at);
  const chords = curve.slice(1).map((r, i) => [curve[i], r]).filter(([q, r]) => q && r);
  return design.points.map((p) => Math.min(...chords.map(([q, r]) => distanceToChord(p, q, r))));
}

for (const [name, at, range] of some([["ellipse", ellipse], ["arc", ellipse, [0.4, 3.6]],
  ["egg", (t) => [0.5 + 0.17 * Math.cos(t) + 0.03 * Math.cos(2 * t), 0.45 - 0.17 * Math.sin(t)]]])) {
  test(`of a drawn ${name} designs are found that pass its points within the error`, () => visit({}, async (page) => {
    await draw(page, at, range);
    await settled(page);
    assert.equal(await page.locator("#closed").getAttribute("aria-pressed"), String(!range));
    assert.ok(await targets(page) >= 6 && await targets(page) <= 24);
    const errors = await facts(page, "rms");
    assert.equal(errors.length, 3);
    assert.deepEqual(errors, [...errors].sort((p, q) => p - q));
    for (const least of await facts(page, "least")) assert.ok(least >= 30 - 1e-6);
    const design = addressOf(page);
    assert.equal(design.points.length, await targets(page));
    assert.ok(Math.abs(design.rms - errors[0]) < 1e-9);
    const far = misses(design);
    assert.ok(Math.max(...far) <= design.max * 1.001 + 1e-4, `${Math.max(...far)} against ${design.max}`);
    assert.ok(Math.hypot(...far) / Math.sqrt(far.length) <= design.rms * 1.001 + 1e-4);
    // An ellipse is traced to a hundredth of its size.
    assert.ok(design.rms < 0.6, `${design.rms}`);
  }));
}

test("a design is chosen, and all move", () => visit({ motion: "no-preference" }, async (page) => {
  await draw(page, ellipse);
  await settled(page);
  await moves(page, "#tracing");
  assert.equal(await page.locator("#picture .ghost-linkage").count(), 2);
  const before_ = page.url();
  await page.locator("#design-1").check();
  assert.notEqual(page.url(), before_);
  await page.keyboard.press("3");
  assert.ok(await page.locator("#design-2").isChecked());
}));

test("a card keeps the focus while longer searches answer", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await offered(page);
  await page.locator("#design-0").focus();
  await settled(page);
  assert.equal(await page.evaluate(() => document.activeElement.id), "design-0");
  // Where cards say something else, they are others.
  await page.locator("#by-slider").click();
  await settled(page);
  assert.equal((await facts(page, "stroke")).length, (await facts(page, "rms")).length);
}));

test("every step can be undone and made again", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await offered(page);
  const count = await targets(page), drawn = addressOf(page).points;
  await page.locator('[data-target="2"]').focus();
  await page.keyboard.press("Shift+ArrowUp");
  await offered(page);
  assert.notDeepEqual(addressOf(page).points[2], drawn[2]);
  await page.locator('[data-target="2"]').focus();
  await page.keyboard.press("Delete");
  assert.equal(await targets(page), count - 1);
  await page.locator("#class").selectOption("double-crank");
  await page.locator("#clear").click();
  assert.equal(await targets(page), 0);
  assert.equal(await page.locator(".design-card").count(), 0);
  for (let i = 0; i < 2; ++i) await page.locator("#undo").click();
  assert.equal(await page.locator("#class").inputValue(), "any");
  await page.keyboard.press("Control+z");
  await page.keyboard.press("z");
  assert.deepEqual(addressOf(page).points, drawn);
  await offered(page);
  for (let i = 0; i < 2; ++i) await page.keyboard.press("Control+Shift+z");
  assert.equal(await targets(page), count - 1);
  assert.ok(await page.locator("#redo").isEnabled());
}));

test("a dragged point is searched for anew", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await settled(page);
  const [rms] = await facts(page, "rms");
  const box = await page.locator('[data-target="3"]').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y - 40, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  const design = addressOf(page);
  assert.ok(design.rms > rms);
  assert.ok(Math.max(...misses(design)) <= design.max * 1.001 + 1e-4);
  await page.locator("#undo").click();
  await settled(page);
  assert.ok(Math.abs((await facts(page, "rms"))[0] - rms) < 1e-9);
}));

test("the design chosen follows a drag without the others, and is not taken back by what is found for a step before", () => visit({ prepare: holding }, async (page) => {
  if (!hasKernel) return;
  await draw(page, ellipse);
  await settled(page);
  await page.locator("#design-1").click();
  const rms = () => facts(page, "rms"), chosen = () => page.locator(".design-card:has(:checked) [data-fact=rms]").getAttribute("data-value");
  const changed = (value) => page.waitForFunction((before) => document.querySelector(".design-card:has(:checked) [data-fact=rms]").dataset.value !== before, value);
  const before = await rms(), first = await chosen();
  await hold(page);
  const box = await page.locator('[data-target="3"]').boundingBox(), [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y - 25);
  await changed(first);
  const second = await chosen();
  assert.deepEqual((await rms()).toSpliced(1, 1), before.toSpliced(1, 1));
  assert.ok(await page.locator("#design-1").isChecked());
  await page.mouse.move(x + 30, y - 40);
  await changed(second);
  const third = await chosen();
  // The answer to the first step is followed by the question of the second.
  await page.evaluate(() => window.held.shift().send());
  await page.waitForFunction(() => window.held.length === 1);
  assert.equal(await chosen(), third);
  assert.notDeepEqual((await rms()).filter((value) => String(value) !== third), before.toSpliced(1, 1));
  await page.evaluate(() => { window.holds = false; });
  await page.mouse.up();
  await settled(page);
  const design = addressOf(page);
  assert.ok(Math.max(...misses(design)) <= design.max * 1.001 + 1e-4);
}));

test("a point put far outside the places that an address holds stands at their border, and zooming there does not leap", () => visit({ hash: "#p=-900000,0;0,900000;900000,0;0,-600000&o=open,points&l=any,30,3" }, async (page) => {
  await offered(page);
  const scale = async () => { const [a, b] = await Promise.all([0, 2].map((i) => page.locator(`[data-target="${i}"]`).boundingBox())); return b.x - a.x; };
  const widened = await scale();
  await page.locator("[data-zoom=farther]").click();
  await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
  assert.ok(Math.abs(await scale() - widened) < 2, `${await scale()} after ${widened}`);
  const box = await page.locator("#sheet").boundingBox();
  await page.mouse.click(box.x + 4, box.y + box.height / 2);
  assert.equal(await targets(page), 5);
  assert.equal(addressOf(page).points[4][0], -1e6);
  await page.reload();
  assert.equal(await targets(page), 5);
}));

test("points are clicked, and put by keys alone", () => visit({}, async (page) => {
  const box = await page.locator("#sheet").boundingBox();
  for (const [x, y] of [[0.4, 0.4], [0.6, 0.4], [0.6, 0.6]]) await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  assert.equal(await targets(page), 3);
  const first = await page.locator('[data-target="0"]').boundingBox();
  await page.mouse.click(first.x + first.width / 2, first.y + first.height / 2);
  assert.equal(await page.locator("#closed").getAttribute("aria-pressed"), "true");
  await page.locator("#sheet").focus();
  for (const key of ["ArrowLeft", "Shift+ArrowLeft", "ArrowDown", "Enter"]) await page.keyboard.press(key);
  assert.equal(await targets(page), 4);
  await offered(page);
}));

wholeOnly("the address holds the sketch and its design", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await settled(page);
  await page.locator("#design-1").check();
  const [design, rms] = [addressOf(page), (await facts(page, "rms"))[1]];
  await visit({ hash: `#${page.url().split("#")[1]}` }, async (again) => {
    await again.locator("#linkage").waitFor();
    await settled(again);
    assert.deepEqual(addressOf(again), design);
    const chosen = await again.locator(".design-card:has(:checked) [data-fact=rms]").evaluate((one) => JSON.parse(one.dataset.value));
    assert.equal(chosen, rms);
  });
  // Another language keeps the sketch.
  await page.locator("#language").selectOption("zh");
  await page.waitForFunction(() => document.documentElement.lang === "zh-Hans" && document.querySelector("#linkage"));
  assert.deepEqual(addressOf(page).points, design.points);
}));

for (const hash of some(["#p=1,2;3", "#p=x,y", "#d=1,2", "#p=1,2;3,4;5,6&d=1,2,3", "#p=1,2;3,4;5,9&d=0,0,1,0,1,1,1,0,0,1,1,1;open;x;a", "#%"])) {
  test(`a damaged address ${hash} does no harm`, () => visit({ hash }, async (page) => {
    assert.ok(await page.locator("#sheet").isVisible());
    await draw(page, ellipse);
    await offered(page);
  }));
}

test("an address without a sketch gives way to that of the sketch shown", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await settled(page);
  const address = page.url();
  for (const hash of ["#p=0,0,0&f=1", "#", "#p=1,1e9"]) {
    await page.evaluate((to) => { location.hash = to; }, hash);
    await page.waitForFunction((to) => location.href === to, address);
  }
}));

test("limits of an address that are none, and places beyond every sheet, are left out", async () => {
  await visit({ hash: "#p=1,2;30,4;5,36&l=any,1000,1e9" }, async (page) => {
    assert.deepEqual([await page.locator("#least").inputValue(), await page.locator("#reach").inputValue()], ["30", "3"]);
    await settled(page);
    for (const least of await facts(page, "least")) assert.ok(least >= 30 - 1e-6);
  });
  await visit({ hash: "#p=1,2;1e300,4;5,36" }, async (page) => assert.equal(await targets(page), 0));
});

test("the files that are taken along are sound", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await settled(page);
  const design = addressOf(page);
  await page.locator("[data-take=copy_problem]").click();
  const result = await answered("solve", await page.locator("#taken").inputValue());
  assert.equal(result.status, "solved");
  assert.deepEqual(result.problem.target.points, design.points);
  await page.locator("[data-take=copy_design]").click();
  const { designs: [{ mechanism, metrics }] } = await answered("analyze", await page.locator("#taken").inputValue());
  assert.ok(Math.abs(mechanism.crank - design.crank) < 1e-6);
  assert.equal(metrics.class, (await facts(page, "class"))[0]);
  const [saved] = await Promise.all([page.waitForEvent("download"), page.locator("[data-save=picture]").click()]);
  assert.match(fs.readFileSync(await saved.path(), "utf8"), /^<svg .*<\/svg>\s*$/s);
}));

for (const options of some([{ size: "phone", scheme: "dark" }, { size: "phone", locale: "zh-CN" }, { size: "laptop" }])) {
  test(`it fits: ${JSON.stringify(options)}`, () => visit(options, async (page) => {
    await assertFits(page);
    await draw(page, (t) => [0.5 + 0.3 * Math.cos(t), 0.45 - 0.25 * Math.sin(t)]);
    await page.waitForFunction(() => document.querySelectorAll(".design-card").length === 3);
    await assertFits(page);
    if (options.locale) assert.doesNotMatch(await page.locator("main").innerText(), /[A-Za-z]{5}/);
  }));
}

// A file that is chosen.
const bring = (page, name, content) => page.locator("#bring-file").setInputFiles({ name, mimeType: name.endsWith(".svg") ? "image/svg+xml" : "image/png", buffer: Buffer.from(content) });

test("the longest line of an SVG file becomes the curve, with its transforms and nothing else of it", () => visit({}, async (page) => {
  // An ellipse of 2 to 1 that is turned upright, beside a shorter line, a shape that is not drawn, and a script.
  await bring(page, "mark.svg", `<svg xmlns="http://www.w3.org/2000/svg" onload="window.bad = 1"><defs><circle r="900"/></defs><script>window.bad = 1</script>
    <rect width="4000" height="4000"/><path d="M0 0L5 5"/><g transform="translate(300 -20) rotate(90)"><ellipse cx="7" cy="9" rx="80" ry="40" transform="scale(2)" onclick="bad()"/></g></svg>`);
  await offered(page);
  const { points } = addressOf(page);
  const far = points.map(([x, y]) => Math.hypot(2 * x, y));
  assert.ok(Math.max(...far) / Math.min(...far) < 1.02, `${far}`);
  assert.ok(Math.abs(Math.max(...far) - 0.35 * 84) < 0.6, `${Math.max(...far)}`);
  assert.equal(await page.locator("#closed").getAttribute("aria-pressed"), "true");
  assert.equal(await page.evaluate(() => window.bad), undefined);
  // Of a path its first stroke; y counts downwards in such files.
  const before = page.url();
  await bring(page, "wave.svg", '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0C0 0 0 0 100 50L200 50m300 300L900 900"/></svg>');
  await page.waitForFunction((url) => location.href !== url, before);
  await offered(page);
  const wave = addressOf(page).points;
  assert.ok(wave[0][1] > wave.at(-1)[1] && wave.at(-1)[0] > wave[0][0]);
  assert.ok(Math.abs(wave.at(-1)[0] - wave[0][0] - 0.7 * 120) < 0.1);
  for (const content of ["<svg", "", '<svg xmlns="http://www.w3.org/2000/svg"><text>A</text></svg>', '<svg xmlns="http://www.w3.org/2000/svg"><path/><circle r="1e400"/></svg>']) {
    await bring(page, "none.svg", content);
    await page.waitForFunction(() => document.getElementById("state").textContent.startsWith("The file has no path"));
    assert.deepEqual(addressOf(page).points, wave);
    await page.evaluate(() => { document.getElementById("state").textContent = ""; });
  }
}));

test("a picture lies under the drawing until it is removed", () => visit({}, async (page) => {
  await bring(page, "photo.png", await page.evaluate(() => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 40, height: 20 });
    return canvas.toDataURL().split(",")[1];
  }).then((text) => Buffer.from(text, "base64")));
  const box = async () => page.locator(".underneath").evaluate((one) => ["width", "height"].map((name) => Number(one.getAttribute(name))));
  await page.locator(".underneath").waitFor();
  const [width, height] = await box();
  assert.ok(Math.abs(width - 2 * height) < 0.1);
  await page.locator("#picture-width").fill("42");
  assert.ok(Math.abs((await box())[0] / width - 42 / 84) < 0.01);
  await draw(page, ellipse);
  await offered(page);
  assert.equal(await page.locator(".underneath").count(), 1);
  await page.locator("#picture-away").click();
  assert.equal(await page.locator(".underneath").count(), 0);
  await bring(page, "none.png", "no picture");
  await page.waitForFunction(() => document.getElementById("state").textContent.startsWith("The file is not a picture"));
}));

test("fixed pivots stand in the box that is drawn for them, by hand or by keys", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await offered(page);
  const box = await page.locator("#sheet").boundingBox();
  await page.locator("#region").click();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.75 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.55 * box.width, box.y + 0.2 * box.height, { steps: 5 });
  await page.mouse.up();
  await offered(page);
  const bounds = () => page.url().match(/&b=([^&]+)/)[1].split(",").map(Number);
  const inside = () => {
    const [x0, y0, x1, y1] = bounds(), { a, d } = addressOf(page);
    assert.ok(x0 < x1 && y0 < y1);
    for (const [x, y] of [a, d]) assert.ok(x >= x0 - 1e-6 && x <= x1 + 1e-6 && y >= y0 - 1e-6 && y <= y1 + 1e-6, `${[x, y]} in ${[x0, y0, x1, y1]}`);
  };
  inside();
  assert.ok(await page.locator("#pivot-region").isVisible());
  // Another click takes it away, a step back brings it again; the address holds it.
  await page.locator("#region").click();
  assert.ok(!page.url().includes("&b="));
  await page.keyboard.press("Control+z");
  await offered(page);
  inside();
  await visit({ hash: `#${page.url().split("#")[1]}` }, async (again) => {
    await offered(again);
    assert.ok(again.url().includes(page.url().match(/&b=[^&]+/)[0]));
  });
  await page.locator("#region").click();
  const drawn = addressOf(page).points;
  await page.keyboard.press("r");
  await page.locator("#sheet").focus();
  for (const key of ["Shift+ArrowLeft", "Enter", ...Array.from({ length: 6 }, () => "Shift+ArrowRight"), ...Array.from({ length: 5 }, () => "Shift+ArrowDown"), "Enter"]) await page.keyboard.press(key);
  await offered(page);
  inside();
  assert.deepEqual(addressOf(page).points, drawn);
  // The next stroke draws again.
  await draw(page, ellipse, [0.4, 3.6]);
  await offered(page);
  inside();
  assert.equal(await page.locator("#closed").getAttribute("aria-pressed"), "false");
}));

test("joints and the point stay out of a box that is drawn for that, while the crank turns fully", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await offered(page);
  const box = await page.locator("#sheet").boundingBox();
  const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  await page.locator("#obstacle").click();
  await page.mouse.move(...at(0.4, 0.7));
  await page.mouse.down();
  await page.mouse.move(...at(0.6, 0.95), { steps: 5 });
  await page.mouse.up();
  assert.equal(await page.locator("#class").inputValue(), "crank-rocker");
  await offered(page);
  const kept = () => { const [x0, y0, x1, y1] = page.url().match(/&c=([^&]+)/)[1].split(",").map(Number); return [[x0, y0], [x1, y1]]; };
  for (const i of [0, 1]) {
    await page.locator(`#design-${i}`).check();
    assert.ok(clearanceOf(addressOf(page), kept()) > -1e-4);
  }
  await page.locator("[data-take=copy_problem]").click();
  const result = await answered("solve", await page.locator("#taken").inputValue());
  assert.equal(result.status, "solved");
  assert.deepEqual(result.problem.constraints.clearance.map(({ outside }) => outside), Array.from({ length: 3 }, kept));
  await visit({ hash: `#${page.url().split("#")[1]}` }, async (again) => {
    await offered(again);
    assert.ok(await again.locator("#kept-clear").isVisible());
    assert.ok(again.url().includes(page.url().match(/&c=[^&]+/)[0]));
  });
  // A class whose crank does not turn takes it away, a step back brings both again.
  await page.locator("#class").selectOption("double-rocker");
  assert.ok(!page.url().includes("&c="));
  await page.keyboard.press("Control+z");
  assert.ok(page.url().includes("&c=") && await page.locator("#kept-clear").isVisible());
  await page.locator("#obstacle").click();
  assert.ok(!page.url().includes("&c="));
}));

test("a finger draws", () => visit({ size: "phone" }, async (page) => {
  const box = await page.locator("#sheet").boundingBox();
  const client = await page.context().newCDPSession(page);
  const touch = (type, t) => client.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x: box.x + ellipse(t)[0] * box.width, y: box.y + ellipse(t)[1] * box.height }] });
  await touch("touchStart", 0);
  for (let i = 1; i <= 40; ++i) await touch("touchMove", (2 * Math.PI * i) / 40);
  await touch("touchEnd");
  assert.ok(await targets(page) >= 6);
  assert.equal(await page.evaluate(() => scrollY), 0);
}));

test("without its search the page draws, and says so", async () => {
  if (hasKernel) return;
  const { page, faults, close } = await open(browser, file);
  await draw(page, ellipse);
  assert.ok(await page.locator("#no-kernel").isVisible());
  assert.ok(await page.locator("[data-take=copy_problem]").isEnabled());
  assert.deepEqual(faults, []);
  await close();
});

test("the page is one file below 2 MB", () => assert.ok(fs.statSync(file).size < 2e6));
