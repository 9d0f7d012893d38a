// The page of the scenes in a browser: every handle is moved by mouse, touch and keys, every control is used, and what the page
// shows is compared with the frame that the library computes natively for the same state.
//
// node learn.mjs REPORTS EXPLORER [SCREENSHOTS]; EXPLORER is the program `beamgap-explorer`. playwright-core and axe-core are
// looked for in NODE_PATH.
import { createRequire } from "node:module";
import { execFileSync } from "node:child_process";
import { readFileSync, existsSync } from "node:fs";
import assert from "node:assert/strict";
import path from "node:path";

const require = createRequire(process.env.NODE_PATH + "/");
const { chromium } = require("playwright-core");
const axe = readFileSync(require.resolve("axe-core"), "utf8");
const [reports, explorer, pictures] = process.argv.slice(2);
const address = `file://${path.resolve(reports, "learn.html")}`;
const executablePath = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const browser = await chromium.launch({ executablePath, args });
/** Milliseconds for script, style and layout of a frame, with the processor slowed down four times. A quiet machine needs less than
 * WANTED; above LIMIT there are fewer than 60 frames a second. */
const [WANTED, LIMIT] = [8, 16];
const SCENES = ["valley", "normal", "slide", "lines", "envelope", "race", "detective", "friction"];

async function opened(options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("request", (request) => request.url().startsWith("file:") || request.url().startsWith("data:") || errors.push(`asks for ${request.url()}`));
  await page.goto(address);
  if (options.javaScriptEnabled !== false) await page.waitForSelector("html[data-ready]");
  return { page, close: async () => { assert.deepEqual(errors, []); await context.close(); } };
}

/** The native frames of states. */
function frames(states) {
  const input = states.map(([scene, state]) => JSON.stringify({ scene, state })).join("\n") + "\n";
  return execFileSync(explorer, ["frames"], { input, maxBuffer: 1 << 28 }).toString().trim().split("\n").map((line) => JSON.parse(line));
}

const stateOf = (page, scene) => page.evaluate((id) => document.getElementById(id).scene.state, scene);
/** Two frames: one for the action, one to be sure that it is drawn. */
const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** What a scene shows: texts, paths and places by name. */
const shownBy = (page, scene) => page.evaluate((id) => {
  const section = document.getElementById(id);
  const all = (kind, read) => [...section.querySelectorAll(`[data-${kind}]`)].map((element) => [element.dataset[kind], read(element)]);
  return {
    values: all("value", (element) => element.textContent),
    paths: all("path", (element) => element.getAttribute("d")),
    places: all("place", (element) => (element.style.display === "none" ? null : element.getAttribute("transform"))),
    shown: all("shown", (element) => !element.hidden),
  };
}, scene);

/** Fails unless the page shows the library's frame of its state. */
async function agrees(page, scene) {
  await drawn(page);
  const state = await stateOf(page, scene);
  const [frame] = frames([[scene, state]]);
  assert.deepEqual(frame.state, state);
  const { values, paths, places, shown } = await shownBy(page, scene);
  assert.ok(values.length > 0 && paths.length > 0 && places.length > 0);
  for (const [name, text] of values) assert.equal(text, frame.values[name], `${scene}: ${name}`);
  for (const [name, data] of paths) assert.equal(data ?? "", frame.paths[name], `${scene}: ${name}`);
  for (const [name, is] of shown) assert.equal(is, frame.shown[name], `${scene}: ${name}`);
  for (const [name, transform] of places) {
    const place = frame.places[name];
    assert.equal(transform, place && `translate(${place[0]} ${place[1]})`, `${scene}: ${name}`);
  }
  return state;
}

async function middle(page, handle) {
  await handle.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await handle.boundingBox();
  return [x + width / 2, y + height / 2];
}

/** Every handle by mouse and keys, at every width. */
async function handles(width, colorScheme) {
  const { page, close } = await opened({ viewport: { width, height: 900 }, colorScheme });
  let count = 0;
  for (const scene of SCENES) {
    const names = await page.locator(`#${scene} [data-handle]`).evaluateAll((all) => all.map((one) => one.dataset.handle));
    assert.ok(names.length > 0);
    for (const name of names) {
      const handle = page.locator(`#${scene} [data-handle="${name}"]`);
      const before = await agrees(page, scene);
      const [x, y] = await middle(page, handle);
      const box = await handle.locator(".grip").boundingBox();
      assert.ok(Math.min(box.width, box.height) >= 44, `${scene}: the handle ${name} is ${box.width} px wide at ${width} px`);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x - 24, y + 13, { steps: 4 });
      await drawn(page);
      await page.mouse.up();
      await page.waitForTimeout(scene === "detective" ? 300 : 0);
      const dragged = await agrees(page, scene);
      assert.notDeepEqual(dragged, before, `${scene}: the mouse does not move ${name}`);
      await handle.focus();
      for (const key of ["ArrowRight", "ArrowUp"]) await page.keyboard.press(key);
      await page.waitForTimeout(scene === "detective" ? 300 : 0);
      const pressed = await agrees(page, scene);
      assert.notDeepEqual(pressed, dragged, `${scene}: keys do not move ${name}`);
      count += 1;
    }
  }
  await close();
  return count;
}

/** A finger moves a handle upwards, and the page does not scroll. */
async function touch() {
  const { page, close } = await opened({ hasTouch: true, viewport: { width: 400, height: 800 } });
  const session = await page.context().newCDPSession(page);
  for (const scene of SCENES) {
    const handle = page.locator(`#${scene} [data-handle]`).first();
    const [x, y] = await middle(page, handle);
    const before = await agrees(page, scene);
    const scrolled = await page.evaluate(() => scrollY);
    const at = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
    await at("touchStart", [{ x, y }]);
    for (let i = 1; i <= 6; i++) await at("touchMove", [{ x: x - 2 * i, y: y - 6 * i }]);
    await at("touchEnd", []);
    await page.waitForTimeout(scene === "detective" ? 300 : 30);
    assert.notDeepEqual(await agrees(page, scene), before, `${scene}: a finger does not move the handle`);
    assert.equal(await page.evaluate(() => scrollY), scrolled, `${scene}: the page scrolls`);
  }
  await close();
}

/** Every button and range, terms that light their parts, the walk, and the cases of the detective. */
async function controls() {
  const { page, close } = await opened();
  for (const scene of SCENES) {
    for (const button of await page.locator(`#${scene} button[data-choose]`).all()) {
      const { height } = await button.boundingBox();
      assert.ok(height >= 44, `${scene}: a button is ${height} px high`);
      await button.click();
      await agrees(page, scene);
    }
    for (const term of await page.locator(`#${scene} [data-term]`).all()) {
      await term.hover();
      const name = await term.getAttribute("data-term");
      const lit = await page.locator(`#${scene} .lit`).count();
      const parts = await page.locator(`#${scene} [data-part~="${name}"]`).count();
      assert.equal(lit, parts, `${scene}: ${name}`);
    }
    await page.mouse.move(0, 0);
    assert.equal(await page.locator(".lighting").count(), 0);
  }
  for (const range of await page.locator("input[type=range]").all()) {
    await range.focus();
    await page.keyboard.press("ArrowLeft");
    await agrees(page, "race");
  }
  const walker = page.locator('[data-handle="walker"]');
  const [x, y] = await middle(page, walker);
  await page.click('[data-to="crossing"]');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 40, { steps: 3 });
  await page.mouse.up();
  await page.click("button.play");
  await page.waitForTimeout(3000);
  const walked = await agrees(page, "valley");
  const [bottom] = frames([["valley", walked]]);
  assert.ok(Math.abs(Number(bottom.values.F_xi.replace("−", "-"))) < 0.01, "the walk ends at a minimum");
  // A right answer is explained.
  for (let i = 0; i < 6; i++) {
    await page.click(`#detective [data-choose="suspect"][data-to="${i}"]`);
    await agrees(page, "detective");
  }
  assert.equal(await page.locator('#detective [data-choose="suspect"][aria-pressed="true"]').count(), 1);
  await close();
}

/** The longest of the usual frames of each scene, in milliseconds. */
async function speed() {
  const { page, close } = await opened();
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 4 });
  const found = {};
  for (const scene of SCENES) {
    for (const handle of await page.locator(`#${scene} [data-handle]`).all()) {
      const name = await handle.getAttribute("data-handle");
      const [x, y] = await middle(page, handle);
      await page.mouse.move(x, y);
      await page.mouse.down();
      const times = await handle.evaluate((element, [x, y]) => new Promise((done) => {
        const times = [];
        const next = (i) => {
          if (i === 60) return done(times);
          // The three callbacks run in this order in the same frame: the clock, the page's own, the layout and the clock.
          let start = 0;
          requestAnimationFrame(() => { start = performance.now(); });
          const to = { clientX: x - 30 * Math.sin(i / 9), clientY: y + 18 * Math.sin(i / 7), pointerId: 1, bubbles: true };
          element.dispatchEvent(new PointerEvent("pointermove", to));
          requestAnimationFrame(() => {
            element.ownerSVGElement.getBoundingClientRect();
            times.push(performance.now() - start);
            setTimeout(() => next(i + 1), 0);
          });
        };
        next(0);
      }), [x, y]);
      await page.mouse.up();
      const sorted = times.slice(5).sort((a, b) => a - b);
      found[`${scene} ${name}`] = [sorted[Math.floor(sorted.length / 2)], sorted[Math.floor(sorted.length * 0.9)]];
    }
  }
  await close();
  for (const [name, [median, slow]] of Object.entries(found)) console.log(`${name}: ${median.toFixed(1)} ms in the median, ${slow.toFixed(1)} ms in the slowest tenth`);
  const slow = Object.entries(found).filter(([, [median]]) => median > WANTED).map(([name]) => name);
  if (slow.length > 0) console.log(`above ${WANTED} ms: ${slow.join(", ")}`);
  for (const [name, [median]] of Object.entries(found)) assert.ok(median < LIMIT, `${name}: a frame takes ${median} ms`);
}

async function looks() {
  for (const colorScheme of ["light", "dark"]) {
    for (const width of [400, 800, 1280]) {
      const { page, close } = await opened({ colorScheme, viewport: { width, height: 900 } });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wide <= 0, `the page is ${wide} px too wide at ${width} px`);
      await page.evaluate(() => document.querySelectorAll("details").forEach((one) => { one.open = true; }));
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => axe.run());
      const told = violations.map((one) => `${one.id}: ${one.nodes.length} x ${one.nodes[0].html.slice(0, 160)} ${one.nodes[0].failureSummary}`);
      assert.deepEqual(told, [], `${width} px, ${colorScheme}`);
      if (pictures) await page.screenshot({ path: `${pictures}/learn-${width}-${colorScheme}.png`, fullPage: true });
      await close();
    }
  }
  // Without scripts the pictures are there, as they open.
  const { page, close } = await opened({ javaScriptEnabled: false });
  assert.ok((await page.textContent("main")).length > 15000, "the page is blank without scripts");
  assert.ok(await page.locator("main svg path[d]").count() > 60);
  if (pictures) await page.pdf({ path: `${pictures}/learn.pdf`, format: "A4" });
  await close();
}

/** Without motion the walk ends at once. */
async function still() {
  const { page, close } = await opened({ reducedMotion: "reduce" });
  const before = await stateOf(page, "valley");
  await page.click("button.play");
  const after = await agrees(page, "valley");
  assert.notDeepEqual(after, before);
  await page.click("button.play");
  const again = await agrees(page, "valley");
  assert.ok(Math.abs(again.at[0] - after.at[0]) < 0.01 && Math.abs(again.at[1] - after.at[1]) < 0.01);
  await close();
}

try {
  for (const width of [400, 800, 1280]) {
    for (const scheme of ["light", "dark"]) await handles(width, scheme);
  }
  console.log("learn.html: every handle moves by mouse and keys, and the page shows the library's numbers");
  await touch();
  await controls();
  await still();
  console.log("learn.html: touch, buttons, terms and the walk work");
  await looks();
  console.log("learn.html: no overflow and no violation at 400, 800 and 1280 px, light and dark; not blank without scripts");
  await speed();
} finally {
  await browser.close();
}
