// The pages in a browser: the explorer is used by mouse, touch and keys, and both pages are looked at in every size and scheme.
// The documentation, where it is built, is searched for the numbers of the equations.
//
// node browser.mjs REPORTS BEAMGAP [SCREENSHOTS]; playwright-core and axe-core are looked for in NODE_PATH.
import { createRequire } from "node:module";
import { execSync } from "node:child_process";
import { readFileSync, existsSync } from "node:fs";
import assert from "node:assert/strict";
import path from "node:path";

const require = createRequire(process.env.NODE_PATH + "/");
const { chromium } = require("playwright-core");
const axe = readFileSync(require.resolve("axe-core"), "utf8");
const [reports, beamgap, pictures] = process.argv.slice(2);
const page_of = (name) => `file://${path.resolve(reports, name)}`;
const executablePath = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const browser = await chromium.launch({ executablePath, args });

async function opened(name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, ...options });
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("request", (request) => request.url().startsWith("file:") || request.url().startsWith("data:") || errors.push(`asks for ${request.url()}`));
  await page.goto(page_of(name) + (options.fragment ?? ""));
  if (name === "explorer.html" && options.javaScriptEnabled !== false) await page.waitForSelector("html[data-ready]");
  return { page, errors, close: async () => { assert.deepEqual(errors, []); await context.close(); } };
}

const gap = async (page) => Number((await page.textContent("#gap")).replace("−", "-"));
const settled = (page) => page.waitForTimeout(400);

async function explorer() {
  // The mouse.
  let { page, close } = await opened("explorer.html");
  const first = await gap(page);
  const handle = page.locator('[aria-label^="point 1 of the beam"]');
  const { x, y, width, height } = await handle.boundingBox();
  const [u, v] = [x + width / 2, y + height / 2];
  await page.mouse.move(u, v);
  await page.mouse.down();
  await page.mouse.move(u, v - 40, { steps: 8 });
  await page.mouse.up();
  await settled(page);
  const dragged = await gap(page);
  assert.ok(dragged > first + 0.01, `the gap was ${first} and is ${dragged}`);

  // The keys.
  await handle.focus();
  await page.keyboard.press("ArrowDown");
  await settled(page);
  assert.ok((await gap(page)) < dragged);

  // The link holds the state.
  const link = page.url();
  const there = await gap(page);
  await close();
  ({ page, close } = await opened("explorer.html", { fragment: "#" + link.split("#")[1] }));
  assert.equal(await gap(page), there);

  // A fault: AD turns red, symmetry stays green.
  const says = (check) => page.textContent(`#checks tr:has(th:text-is("${check}")) td:nth-child(3)`);
  assert.match(await says("automatic differentiation"), /agrees/);
  await page.click('#lessons button[data-fault^="a: d.t,xi"]');
  await settled(page);
  assert.match(await says("automatic differentiation"), /WRONG/);
  assert.match(await says("symmetry"), /agrees/);

  // The command gives the same verdict.
  const command = (await page.textContent("#command")).replace("| beamgap", `| ${path.resolve(beamgap)}`);
  let status = 0;
  try { execSync(command, { stdio: "pipe" }); } catch (error) { status = error.status; }
  assert.equal(status, 1, "the command shows the fault");
  execSync(command.replace(/ --plant .*/, ""), { stdio: "pipe" });

  // Families and special situations.
  await page.click('#lessons button[data-fault=""]');
  await page.selectOption("#family-bar", "helix");
  await settled(page);
  assert.match(await says("automatic differentiation"), /agrees/);
  for (const [situation, words] of [["parallel", /parallel/], ["crossing", /d = 0/], ["at an end", /end of the/], ["two minima", /2 minima/]]) {
    await page.click(`#situations button[data-situation="${situation}"]`);
    await settled(page);
    assert.match(await page.textContent("#words"), words);
  }
  await page.click('#points button[data-minimum="1"]');
  await settled(page);
  assert.equal(await page.locator('#points button[data-minimum="0"]').count(), 1);

  // Numbers by hand, and the clipboard.
  await page.click("#dofs summary");
  const before = await gap(page);
  await page.fill('[aria-label="q 3 of the beam"]', "0.9");
  await settled(page);
  assert.notEqual(await gap(page), before);
  await page.click("#copy-test");
  await page.waitForFunction(() => /copied|select/.test(document.getElementById("copied").textContent));
  await close();

  // A finger.
  ({ page, close } = await opened("explorer.html", { hasTouch: true, viewport: { width: 400, height: 800 } }));
  const start = await gap(page);
  const scrolled = await page.evaluate(() => scrollY);
  const box = await page.locator('[aria-label^="point 1 of the bar beam"]').boundingBox();
  assert.ok(Math.min(box.width, box.height) >= 44, `a handle is ${box.width} px wide`);
  const touch = await page.context().newCDPSession(page);
  const [px, py] = [box.x + box.width / 2, box.y + box.height / 2];
  const at = (type, points) => touch.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await at("touchStart", [{ x: px, y: py }]);
  for (let i = 1; i <= 6; i++) await at("touchMove", [{ x: px, y: py - 5 * i }]);
  await at("touchEnd", []);
  await settled(page);
  assert.notEqual(await gap(page), start);
  assert.equal(await page.evaluate(() => scrollY), scrolled, "the page scrolls");
  await close();

  // A broken link is told.
  ({ page, close } = await opened("explorer.html", { fragment: "#bm9uc2Vuc2U" }));
  assert.match(await page.textContent("#message"), /link/);
  assert.ok(Number.isFinite(await gap(page)));
  await close();
}

/** Milliseconds from a change to the end of its layout, and frames a second while the beams are dragged. */
async function speed() {
  const { page, close } = await opened("explorer.html");
  const box = await page.locator('[aria-label^="point 1 of the beam"]').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  const frames = page.evaluate(() => new Promise((done) => {
    const times = [];
    const frame = (time) => { times.push(time); times.length < 121 ? requestAnimationFrame(frame) : done(times); };
    requestAnimationFrame(frame);
  }));
  let moving = true;
  frames.then(() => { moving = false; });
  for (let i = 0; moving; i++) await page.mouse.move(box.x + 60 * Math.sin(i / 10), box.y + 40 * Math.cos(i / 10));
  const times = await frames;
  await page.mouse.up();
  const gaps = times.slice(1).map((time, i) => time - times[i]).sort((a, b) => a - b);
  console.log(`dragging: ${(1000 / gaps[60]).toFixed(0)} frames a second in the median, the slowest tenth ${(1000 / gaps[108]).toFixed(0)}`);
  await close();
}

async function looks(name) {
  for (const colorScheme of ["light", "dark"]) {
    for (const width of [400, 1200, 1800]) {
      const { page, close } = await opened(name, { colorScheme, viewport: { width, height: 900 } });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wide <= 0, `${name} is ${wide} px too wide at ${width} px`);
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => axe.run());
      const told = violations.map((one) => `${one.id}: ${one.nodes.length} x ${one.nodes[0].html.slice(0, 160)} ${one.nodes[0].failureSummary}`);
      assert.deepEqual(told, [], `${name}, ${width} px, ${colorScheme}`);
      if (pictures) await page.screenshot({ path: `${pictures}/${name}-${width}-${colorScheme}.png`, fullPage: name === "explorer.html" });
      await close();
    }
  }
  const { page, close } = await opened(name, { javaScriptEnabled: false });
  assert.ok((await page.textContent("main")).length > 3000, `${name} is blank without scripts`);
  assert.ok(await page.locator("svg path").count() > 20);
  if (pictures) {
    await page.screenshot({ path: `${pictures}/${name}-noscript.png` });
    await page.pdf({ path: `${pictures}/${name}.pdf`, format: "A4" });
  }
  await close();
  console.log(`${name}: no overflow and no violation at 400, 1200 and 1800 px, light and dark; not blank without scripts`);
}

/** Typing the number of an equation into the search of the documentation finds what computes it. */
async function documentation() {
  const root = path.resolve(reports, "..");
  const front = path.join(root, "target/doc/beamgap/index.html");
  if (!existsSync(front)) return console.log("SKIPPED: the documentation is not built, its search is not tried");
  const aliases = execSync("grep -rhoE 'doc\\(alias = \"Eq\\. \\([0-9]+\\)' src", { cwd: root }).toString();
  const numbers = [...new Set(aliases.match(/\d+/g))];
  const page = await browser.newPage();
  for (const number of numbers) {
    await page.goto(`file://${front}?search=${encodeURIComponent(`Eq. (${number})`)}`);
    const found = page.locator("a", { hasText: `Eq. (${number})` }).first();
    await found.waitFor({ timeout: 20000 }).catch(() => assert.fail(`the search does not find Eq. (${number})`));
  }
  console.log(`documentation: the search finds ${numbers.length} equations`);
}

try {
  await documentation();
  await explorer();
  console.log("explorer.html: mouse, touch, keys, link, faults, situations and command work");
  await speed();
  await looks("explorer.html");
  await looks("derivation.html");
} finally {
  await browser.close();
}
