// What the tests of the pages in a browser share: opened pages, frames of the library, and what every page must hold.
//
// playwright-core and axe-core are looked for in NODE_PATH.
import { drawn } from "./frames.mjs";
import { createRequire } from "node:module";
import { readFileSync, existsSync } from "node:fs";
import assert from "node:assert/strict";
import path from "node:path";

const require = createRequire(process.env.NODE_PATH + "/");
const { chromium } = require("playwright-core");
const axe = readFileSync(require.resolve("axe-core"), "utf8");
const executablePath = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
export const browser = await chromium.launch({ executablePath, args });
/** Milliseconds for script, style and layout of a frame, with the processor slowed down four times. A quiet machine needs less. A
 * time depends on the machine, so it is shown and no test. */
const WANTED = 8;
export const WIDTHS = [400, 800, 1280];
export { agrees, drawn, frames, landed, stateOf } from "./frames.mjs";

/** A page of the reports, in which no error may occur and which may ask for no other file. */
export async function opened(reports, name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("request", (request) => request.url().startsWith("file:") || request.url().startsWith("data:") || errors.push(`asks for ${request.url()}`));
  await page.goto(`file://${path.resolve(reports, name)}` + (options.fragment ?? ""));
  const isScript = ["explorer.html", "learn.html"].includes(name);
  if (isScript && options.javaScriptEnabled !== false) await page.waitForSelector("html[data-ready]");
  return { page, close: async () => { assert.deepEqual(errors, []); await context.close(); } };
}

/** The middle of a handle in the window. A scene that comes into view is laid out, which may move it once more. */
export async function middle(page, handle) {
  await handle.scrollIntoViewIfNeeded();
  await drawn(page);
  await handle.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await handle.boundingBox();
  return [x + width / 2, y + height / 2];
}

/** A finger moves a handle upwards; the page may not scroll. */
export async function touched(page, handle) {
  const session = await page.context().newCDPSession(page);
  const [x, y] = await middle(page, handle);
  const scrolled = await page.evaluate(() => scrollY);
  const at = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  await at("touchStart", [{ x, y }]);
  for (let i = 1; i <= 6; i++) await at("touchMove", [{ x: x - 2 * i, y: y - 6 * i }]);
  await at("touchEnd", []);
  assert.equal(await page.evaluate(() => scrollY), scrolled, "the page scrolls");
}

/** Handles and controls that are less than 44 px high or wide. A link in a sentence may be. */
const smallTargets = (page) => page.evaluate(() => {
  const all = [...document.querySelectorAll("main button, main select, main input, main summary, main [role=button], main [role=slider]")];
  const target = (element) => (element.type === "radio" || element.type === "range" ? element.closest("label") ?? element : element.querySelector(".grip") ?? element);
  return all.filter((element) => element.checkVisibility() && element.getAttribute("tabindex") !== "-1").map((element) => [element, target(element).getBoundingClientRect()])
    // What is not drawn has no size.
    .filter(([element, box]) => box.width + box.height > 0 && (box.height < 43.5 || (box.width < 43.5 && element.tagName !== "SUMMARY")))
    .map(([element, box]) => `${element.outerHTML.slice(0, 90)} is ${box.width.toFixed(0)} x ${box.height.toFixed(0)}`);
});

/** Elements that are cut, or that scroll inside the page. */
const cut = (page) => page.evaluate(() => [...document.querySelectorAll("main *")]
  .filter((element) => element.checkVisibility() && !(element instanceof SVGElement) && !element.closest("math, .vh") && !["INPUT", "SELECT", "CANVAS"].includes(element.tagName))
  .filter((element) => {
    const { overflowX, overflowY, display } = getComputedStyle(element);
    const box = element.getBoundingClientRect();
    const scrolls = [overflowX, overflowY].some((of) => of === "auto" || of === "scroll") && (element.scrollWidth > element.clientWidth + 1 || element.scrollHeight > element.clientHeight + 1);
    const beyond = box.width > 0 && display !== "inline" && (box.right > innerWidth + 1 || box.left < -1) && getComputedStyle(element).clipPath === "none" && !element.closest("thead");
    return scrolls || beyond;
  })
  .map((element) => element.outerHTML.slice(0, 120)));

/** No overflow, nothing cut, targets of 44 px and no violation, in every width and scheme; not blank without scripts. */
export async function looks(reports, name, { pictures, widths = WIDTHS, characters = 3000, targets = true }) {
  for (const colorScheme of ["light", "dark"]) {
    for (const width of widths) {
      const { page, close } = await opened(reports, name, { colorScheme, viewport: { width, height: 900 } });
      if (pictures) await page.screenshot({ path: `${pictures}/${name}-${width}-${colorScheme}.png`, fullPage: name !== "derivation.html" });
      await page.evaluate(() => document.querySelectorAll("details").forEach((one) => { one.open = true; }));
      await page.waitForTimeout(400);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(wide <= 0, `${name} is ${wide} px too wide at ${width} px`);
      if (targets) {
        assert.deepEqual(await cut(page), [], `${name}: cut at ${width} px`);
        assert.deepEqual(await smallTargets(page), [], `${name}: small targets at ${width} px`);
      }
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => axe.run());
      const told = violations.map((one) => `${one.id}: ${one.nodes.length} x ${one.nodes[0].html.slice(0, 160)} ${one.nodes[0].failureSummary}`);
      assert.deepEqual(told, [], `${name}, ${width} px, ${colorScheme}`);
      await close();
    }
  }
  const { page, close } = await opened(reports, name, { javaScriptEnabled: false });
  assert.ok((await page.textContent("main")).length > characters, `${name} is blank without scripts`);
  assert.ok(await page.locator("main svg :is(path, circle)").count() > 20);
  if (pictures) await page.pdf({ path: `${pictures}/${name}.pdf`, format: "A4" });
  await close();
  console.log(`${name}: no overflow and no violation at ${widths.join(", ")} px, light and dark; not blank without scripts`);
}

/** Script, style and layout of the frames while each handle is dragged. */
export async function speed(reports, name, scenes, prepare = async () => {}) {
  const { page, close } = await opened(reports, name);
  await prepare(page);
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: 4 });
  const found = {};
  for (const scene of scenes) {
    for (const handle of await page.locator(`#${scene} [data-handle]:visible`).all()) {
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
      found[`${scene} ${await handle.getAttribute("data-handle")}`] = [sorted[Math.floor(sorted.length / 2)], sorted[Math.floor(sorted.length * 0.9)]];
    }
  }
  await close();
  for (const [handle, [median, slow]] of Object.entries(found)) console.log(`${handle}: ${median.toFixed(1)} ms in the median, ${slow.toFixed(1)} ms in the slowest tenth`);
  assert.ok(Object.keys(found).length > 0 && Object.values(found).flat().every(Number.isFinite));
  const slow = Object.entries(found).filter(([, [median]]) => median > WANTED).map(([handle]) => handle);
  if (slow.length > 0) console.log(`above ${WANTED} ms: ${slow.join(", ")}`);
}
