// The page of `cognate sketch`: a function is drawn, typed and dragged, and linkages generate it.
import assert from "node:assert/strict";
import { test as always } from "node:test";
import { assertFits, LOOKS } from "./browser.mjs";
import { rarely as test } from "./thinned.mjs";
import { rockerAngle } from "./closures.mjs";
import { answered, draw, facts, offered, settled, targets, visit } from "./sketching.mjs";

const LIMIT = 30;

// The numbers of the address: pairs, ranges, and the generator.
function addressOf(page) {
  const parts = Object.fromEntries(page.url().split("#")[1].split("&").map((part) => part.split("=")));
  const [numbers, assembly, name] = (parts.d ?? "").split(";");
  const [crank, coupler, rocker, frame, input, output, rms, max, least] = numbers.split(",").map(Number);
  return { pairs: parts.p.split(";").map((p) => p.split(",").map(Number)), ranges: parts.f.split(",").map(Number), name, rms, max, least, input, output,
    bar: { a: [0, 0], d: [frame, 0], crank, coupler, rocker, side: assembly === "crossed" ? -1 : 1 } };
}

// How far the output of the generator of the address is from each pair, in degrees.
function missesOf({ pairs, bar, input, output }) {
  return pairs.map(([at, wanted]) => { const miss = rockerAngle(bar, input + at) - output - wanted; return miss - 360 * Math.round(miss / 360); });
}

function assertAsSaid(page) {
  const said = addressOf(page), misses = missesOf(said), rms = Math.hypot(...misses) / Math.sqrt(misses.length);
  assert.ok(Math.abs(rms - said.rms) < 1e-6 * Math.max(1, said.rms), `${rms} against ${said.rms}`);
  assert.ok(Math.abs(Math.max(...misses.map(Math.abs)) - said.max) < 1e-6 * Math.max(1, said.max), `${misses} against ${said.max}`);
  return said;
}

const begin = (page) => page.locator("#of-function").click();

// A stroke through the diagram, by shares of it.
async function stroke(page, height, [from, to] = [0, 1]) {
  const box = await page.locator("#diagram").boundingBox(), sheet = await page.locator("#sheet").boundingBox();
  const share = (t) => [(box.x - sheet.x + t * box.width) / sheet.width, (box.y - sheet.y + (1 - height(t)) * box.height) / sheet.height];
  await draw(page, share, [from, to]);
}

const RISE = (t) => 0.05 + 0.6 * t + 0.3 * t * t;

async function type(page, text, domain) {
  await page.locator("#expression").fill(text);
  for (const [id, value] of [["domain-from", domain[0]], ["domain-to", domain[1]]]) await page.locator(`#${id}`).fill(String(value));
  await page.locator("#plot").click();
}

test("of a stroke generators are found whose output is as near as is said", () => visit({}, async (page) => {
  await begin(page);
  await stroke(page, RISE);
  await settled(page);
  const { pairs, ranges } = assertAsSaid(page);
  assert.ok(pairs.length >= 9 && pairs.length <= 24 && pairs.length === await targets(page), `${pairs.length}`);
  assert.deepEqual(ranges, [90, 60]);
  // Between its ends, which smoothing leaves alone, it is the line that was drawn.
  for (const [x, y] of pairs) assert.ok(Math.abs(y / 60 - RISE(x / 90)) < 0.01, `${x}, ${y}`);
  for (let i = 0; i < (await facts(page, "rms")).length; ++i) {
    await page.keyboard.press(String(i + 1));
    const { rms, bar, least } = assertAsSaid(page), lengths = [bar.crank, bar.coupler, bar.rocker, bar.d[0]];
    assert.ok(Math.abs((await facts(page, "rms"))[i] - rms) < 1e-9);
    assert.ok(least >= LIMIT - 1e-6 && Math.max(...lengths) / Math.min(...lengths) <= 3 + 1e-6);
  }
}));

test("what is typed is plotted, and a file of it is solved and analysed", () => visit({}, async (page) => {
  await begin(page);
  await type(page, "log10(x)", [1, 2]);
  await settled(page);
  const { pairs } = assertAsSaid(page);
  for (const [x, y] of pairs) assert.ok(Math.abs(y - 60 * Math.log2(1 + x / 90)) < 0.006, `${x}, ${y}`);
  const [error] = await facts(page, "rms");
  await page.locator("[data-take=copy_problem]").click();
  const result = await answered("solve", await page.locator("#taken").inputValue());
  assert.equal(result.status, "solved");
  assert.ok(error <= 1.01 * (result.designs[0].error.rms * 180) / Math.PI, `${error} against ${result.designs[0].error.rms}`);
  await page.locator("[data-take=copy_design]").click();
  assert.equal((await answered("analyze", await page.locator("#taken").inputValue())).designs.length, 1);
}));

test("what is no function is refused in a sentence, and what there was stays", () => visit({}, async (page) => {
  await begin(page);
  await type(page, "sqrt(x)", [0, 4]);
  await offered(page);
  const { pairs } = addressOf(page);
  for (const [text, domain] of [["log10(y)", [1, 2]], ["1/x", [0, 1]], ["", [0, 1]], ["sin(x", [0, 1]], ["x", [2, 1]], ["log10(x)", [-1, 1]]]) {
    await type(page, text, domain);
    await page.waitForFunction(() => /This is not a function|x goes from/.test(document.getElementById("state").textContent));
    assert.deepEqual(addressOf(page).pairs, pairs);
  }
}));

test("a pair is dragged, moved by keys, put and removed, and every step undone", () => visit({}, async (page) => {
  await begin(page);
  await type(page, "x^2", [0, 1]);
  await settled(page);
  const drawn = addressOf(page).pairs, before = (await facts(page, "rms"))[0];
  const at = await page.locator('[data-target="9"]').boundingBox();
  await page.mouse.move(at.x + 12, at.y + 12);
  await page.mouse.down();
  await page.mouse.move(at.x + 500, at.y - 30, { steps: 5 });
  // The designs follow while it is dragged.
  await page.waitForFunction((rms) => { const card = document.querySelector("[data-fact=rms]"); return card && card.dataset.value !== String(rms); }, before);
  await page.mouse.up();
  await settled(page);
  const moved = assertAsSaid(page).pairs;
  // It stays before the next pair.
  assert.ok(moved[9][0] > drawn[9][0] && moved[9][0] < moved[10][0] && moved[9][1] > drawn[9][1]);
  await page.locator('[data-target="3"]').focus();
  await page.keyboard.press("ArrowUp");
  assert.ok(addressOf(page).pairs[3][1] > drawn[3][1]);
  await page.keyboard.press("Delete");
  assert.equal(await targets(page), 18);
  await page.locator("#input-range").fill("120");
  await page.locator("#output-range").fill("-80");
  await page.keyboard.press("Enter");
  await settled(page);
  const { pairs, ranges } = assertAsSaid(page);
  assert.deepEqual(ranges, [120, -80]);
  assert.ok(pairs.at(-1)[0] === 120 && pairs.at(-1)[1] === -80);
  for (let i = 0; i < 10 && await page.locator("#undo").isEnabled(); ++i) {
    await page.keyboard.press("Control+z");
    if (JSON.stringify(addressOf(page).pairs) === JSON.stringify(drawn) && addressOf(page).ranges[0] === 90) break;
  }
  assert.deepEqual(addressOf(page).pairs, drawn);
}));

test("a curve out of a file takes the place of the function, whose designs go", () => visit({}, async (page) => {
  await begin(page);
  await stroke(page, RISE);
  await settled(page);
  await page.locator("#bring-file").setInputFiles({ name: "ring.svg", mimeType: "image/svg+xml", buffer: Buffer.from('<svg xmlns="http://www.w3.org/2000/svg"><ellipse rx="4" ry="3"/></svg>') });
  await page.waitForFunction(() => document.getElementById("of-curve").getAttribute("aria-pressed") === "true");
  await settled(page);
  assert.ok((await facts(page, "size")).length > 0);
}));

test("from the address of a function to that of a curve and back", () => visit({ hash: "#p=0,0;45,30;90,50&f=90,60" }, async (page) => {
  await settled(page);
  const own = new URL(page.url()).hash;
  const goTo = (hash) => page.evaluate((to) => { location.hash = to; }, hash);
  await goTo("#p=-20,0;0,14;20,0;0,-11&o=closed,points");
  await settled(page);
  const curve = new URL(page.url()).hash;
  for (const [hash, kind] of [[own, "function"], [curve, "curve"], [own, "function"]]) {
    await goTo(hash);
    await settled(page);
    assert.equal(await page.locator(`#of-${kind}`).getAttribute("aria-pressed"), "true");
  }
  assertAsSaid(page);
}));

test("by keys alone pairs are put at the cross", () => visit({}, async (page) => {
  await page.keyboard.press("p");
  await page.keyboard.press("p");
  assert.equal(await page.locator("#of-function").getAttribute("aria-pressed"), "true");
  await page.locator("#sheet").focus();
  for (const steps of [["Shift+ArrowLeft", "Shift+ArrowDown"], ["Shift+ArrowLeft", "ArrowDown"], ["Shift+ArrowLeft", "Shift+ArrowDown"], ["ArrowLeft", "ArrowDown"]]) {
    for (const key of steps) await page.keyboard.press(key);
    await page.keyboard.press("Enter");
  }
  assert.equal(await targets(page), 4);
  await settled(page);
  assertAsSaid(page);
}));

test("the address holds the function and its design", () => visit({}, async (page) => {
  await begin(page);
  await stroke(page, (t) => 0.9 - 0.7 * Math.sin(1.4 * t));
  await settled(page);
  await page.locator("#design-1").check();
  const before = assertAsSaid(page), address = page.url();
  await page.goto("about:blank");
  await page.goto(address);
  await settled(page);
  const after = assertAsSaid(page);
  assert.deepEqual(after.pairs, before.pairs);
  assert.deepEqual(after.bar, before.bar);
  assert.ok((await facts(page, "rms")).some((rms) => rms === before.rms));
}));

const expressionOf = (page) => page.evaluate(() => ["expression", "domain-from", "domain-to"].map((id) => document.getElementById(id).value));

test("the address holds the expression as long as it is that of the pairs", () => visit({}, async (page) => {
  await begin(page);
  await type(page, "x^2 + min(x, 1)", [-0.5, 2]);
  await settled(page);
  const { pairs } = addressOf(page), address = page.url();
  await page.goto("about:blank");
  await page.goto(address);
  await settled(page);
  assert.deepEqual(await expressionOf(page), ["x^2 + min(x, 1)", "-0.5", "2"]);
  assert.deepEqual(addressOf(page).pairs, pairs);
  assert.match(page.url(), /&x=x/);
  await page.locator("#input-range").fill("33");
  await page.keyboard.press("Enter");
  await settled(page);
  assert.match(page.url(), /&x=x/);
  await page.locator('[data-target="3"]').focus();
  await page.keyboard.press("ArrowUp");
  await settled(page);
  assert.doesNotMatch(page.url(), /&x=/);
  await page.keyboard.press("Control+z");
  assert.match(page.url(), /&x=x/);
}));

for (const wrong of ["sqrt(x,0,1", "x^3,0,1", "%E0,0,1", "x,1,0", "x", ",0,1"]) {
  test(`an expression of an address that gives other pairs or none goes: ${wrong}`, () => visit({ hash: `#p=0,0;45,30;90,60&f=90,60&x=${wrong}` }, async (page) => {
    await settled(page);
    assert.equal(await targets(page), 3);
    assert.doesNotMatch(page.url(), /&x=/);
    assert.ok(["", "log10(x)"].includes((await expressionOf(page))[0]));
    assertAsSaid(page);
  }));
}

const THREE = "p=0,0;45,20;90,60";
for (const damaged of [`${THREE}&f=90`, `${THREE}&f=0,60`, `${THREE}&f=90,0`, `${THREE}&f=-90,60`, `${THREE}&f=90,-60`, `${THREE}&f=80,60`, "p=0,0;45,20;20,60&f=90,60", "p=0,0,0;45,20,0;90,60,1&f=90,60",
  `${THREE}&f=90,60&d=1,2,3`, `${THREE}&f=90,60&d=1,-2,3,4,5,6,7,8,9;open;crank-rocker`, `${THREE}&f=90,60&d=1,2,3,40,5,6,7,8,9;open;crank-rocker`, `${THREE}&f=90,60&d=1,2,3,4,5,6,7,8,9;open;<b>`, `${THREE}&f=90,60&d=1,0.6,0.6,1.2,0,0,7,8,9;open;triple-rocker`]) {
  test(`a damaged address #${damaged} does no harm`, () => visit({ hash: `#${damaged}` }, async (page) => {
    assert.ok([0, 3].includes(await targets(page)));
    await begin(page);
    await type(page, "x", [0, 1]);
    await offered(page);
    assertAsSaid(page);
  }));
}

test("over a whole turn the crank goes round, and its design is analysed", () => visit({ hash: "#p=0,0;90,20;180,40;270,20;360,0&f=360,40" }, async (page) => {
  await settled(page);
  const { name } = assertAsSaid(page);
  assert.equal(name, "crank-rocker");
  const crank = async (place) => {
    await page.locator("#drive").evaluate((slider, to) => { slider.value = to; slider.dispatchEvent(new Event("input")); }, place);
    return page.evaluate(() => ["A", "B"].map((pin) => document.querySelector(`[data-pin=${pin}]`)).map((pin) => ["cx", "cy"].map((key) => Number(pin.getAttribute(key)))));
  };
  const [first, half, end] = [await crank(0), await crank(180), await crank(359.99)];
  assert.ok([0, 1].every((k) => Math.abs(first[1][k] + half[1][k] - 2 * first[0][k]) < 0.1 && Math.abs(end[1][k] - first[1][k]) < 0.1), JSON.stringify([first, half, end]));
  await page.locator("[data-take=copy_design]").click();
  assert.equal((await answered("analyze", await page.locator("#taken").inputValue())).designs.length, 1);
}));

test("limits are kept, and their costs are what the search finds without them", () => visit({}, async (page) => {
  await begin(page);
  await type(page, "x^3", [0, 1]);
  await page.evaluate(() => { const slider = document.getElementById("reach"); slider.value = 2; slider.dispatchEvent(new Event("change")); });
  await page.locator("#class").selectOption("crank-rocker");
  await settled(page);
  for (const name of await facts(page, "class")) assert.equal(name, "crank-rocker");
  for (const ratio of await facts(page, "ratio")) assert.ok(ratio <= 2 + 1e-6);
  await page.waitForFunction(() => document.getElementById("cost-of-class").textContent !== "");
  const said = await page.locator("#cost-of-class").textContent(), cost = Number(/: ([\d.]+)°/.exec(said)?.[1]);
  await page.locator("#class").selectOption("any");
  await settled(page);
  const free = (await facts(page, "rms"))[0];
  assert.ok(Math.abs(cost - free) < 0.01 * free, `${said} against ${free}`);
}));

test("the front of a function is plotted, and a point of it is taken", () => visit({}, async (page) => {
  await begin(page);
  await type(page, "sin(3*x)", [0, 1]);
  await settled(page);
  await page.waitForFunction(() => document.querySelectorAll(".front-point").length > 2, null, { timeout: 60000 });
  await page.locator(".front-point").first().focus();
  const least = Number(await page.locator(".front-point").first().getAttribute("data-level"));
  await page.keyboard.press("Enter");
  await settled(page);
  assert.equal(Number(await page.locator("#least").inputValue()), least);
  assertAsSaid(page);
}));

test("a stroke that runs back leaves the later part, and one straight up is none", () => visit({}, async (page) => {
  await begin(page);
  await stroke(page, () => 0.5, [0.5, 0.5]);
  assert.equal(await targets(page), 1);
  await page.locator("#clear").click();
  await draw(page, await there(page, (t) => [0.5, 0.2 + 0.6 * t]), [0, 1]);
  assert.equal(await targets(page), 0);
  await draw(page, await there(page, (t) => (t < 1 ? [t, 0.2] : [2 - t, 0.8])), [0, 2]);
  await offered(page);
  for (const [x, y] of addressOf(page).pairs) assert.ok(x < 5 || x > 85 || Math.abs(y - 48) < 3, `${x}, ${y}`);
}));

// Shares of the diagram as shares of the sheet.
async function there(page, at) {
  const box = await page.locator("#diagram").boundingBox(), sheet = await page.locator("#sheet").boundingBox();
  return (t) => { const [x, y] = at(t); return [(box.x - sheet.x + x * box.width) / sheet.width, (box.y - sheet.y + (1 - y) * box.height) / sheet.height]; };
}

for (const look of LOOKS) {
  test(`a function fits: ${JSON.stringify(look)}`, () => visit(look, async (page) => {
    await begin(page);
    await stroke(page, RISE);
    await settled(page);
    await assertFits(page);
    for (const id of ["region", "obstacle", "bring", "closed"]) assert.equal(await page.locator(`#${id}`).isVisible(), false);
    // Nor do their keys make the next stroke a box.
    for (const key of ["r", "o", "c"]) await page.keyboard.press(key);
    await stroke(page, (t) => 0.9 * t);
    await settled(page);
    assert.ok(await targets(page) >= 9);
    await page.locator("#of-curve").click();
    for (const id of ["region", "obstacle", "bring", "closed"]) assert.equal(await page.locator(`#${id}`).isVisible(), true);
    assert.equal(await page.locator("#diagram").count(), 0);
  }));
}

test("in a narrow window the linkage stands below the diagram, and beside it when the window grows wide", () => visit({ size: "phone" }, async (page) => {
  await begin(page);
  await stroke(page, RISE);
  await settled(page);
  const places = async () => { const [diagram, linkage, sheet] = await Promise.all(["#diagram", "[data-pin=A]", "#sheet"].map((one) => page.locator(one).boundingBox())); return { diagram, linkage, sheet }; };
  const tall = await places(), before = assertAsSaid(page);
  assert.ok(tall.diagram.width > 0.65 * tall.sheet.width && tall.linkage.y > tall.diagram.y + tall.diagram.height);
  await page.setViewportSize({ width: 1100, height: 700 });
  await page.waitForFunction((width) => document.getElementById("diagram").getBoundingClientRect().width !== width, tall.diagram.width);
  await settled(page);
  const wide = await places(), after = assertAsSaid(page);
  assert.ok(wide.linkage.x > wide.diagram.x + wide.diagram.width);
  assert.deepEqual([after.pairs, after.bar], [before.pairs, before.bar]);
  // A pair is where the hand drags it.
  await page.locator('[data-target="4"]').focus();
  await page.keyboard.press("Shift+ArrowDown");
  await settled(page);
  assertAsSaid(page);
}));

always("a finger draws a function", () => visit({ size: "phone" }, async (page) => {
  await begin(page);
  await page.locator("#sheet").scrollIntoViewIfNeeded();
  const box = await page.locator("#diagram").boundingBox();
  const session = await page.context().newCDPSession(page);
  const touch = (kind, t) => session.send("Input.dispatchTouchEvent", { type: kind, touchPoints: kind === "touchEnd" ? [] : [{ x: box.x + t * box.width, y: box.y + (1 - RISE(t)) * box.height }] });
  await touch("touchStart", 0);
  for (let i = 1; i <= 30; ++i) await touch("touchMove", i / 30);
  await touch("touchEnd");
  await settled(page);
  assertAsSaid(page);
}));
