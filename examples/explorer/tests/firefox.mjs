// The pages in Firefox: opened from the disk without an error, and every handle moved by the mouse, with the page compared with the
// library.
//
// node firefox.mjs REPORTS EXPLORER [SCREENSHOTS]; EXPLORER is the program `beamgap-explorer`. puppeteer-core is looked for in
// NODE_PATH.
import { agrees, drawn, landed, stateOf } from "./frames.mjs";
import { createRequire } from "node:module";
import { existsSync } from "node:fs";
import assert from "node:assert/strict";
import path from "node:path";

const require = createRequire(process.env.NODE_PATH + "/");
const puppeteer = require("puppeteer-core");
const [reports, explorer, pictures] = process.argv.slice(2);
const executablePath = ["/usr/bin/firefox-esr", "/usr/bin/firefox"].find(existsSync);
const browser = await puppeteer.launch({ browser: "firefox", executablePath, headless: true });
const PAGES = { "derivation.html": [], "benchmark.html": [], "explorer.html": ["explorer"] };
PAGES["learn.html"] = ["valley", "normal", "slide", "lines", "envelope", "race", "detective", "friction"];
// Firefox lays out a page that is not read to its end, so it may say this of a formula whose end is still to come. The formulas
// are looked at when the page is read.
const UNFINISHED = /Invalid markup: Incorrect number of children/;
const CHILDREN = { mfrac: 2, mroot: 2, msub: 2, msup: 2, mover: 2, munder: 2, msubsup: 3, munderover: 3 };

for (const [name, scenes] of Object.entries(PAGES)) {
  for (const width of [400, 1280]) {
    const page = await browser.newPage();
    const errors = [];
    const report = (text) => UNFINISHED.test(text) || errors.push(text);
    page.on("pageerror", (error) => report(String(error)));
    page.on("console", (message) => message.type() === "error" && report(message.text()));
    await page.setViewport({ width, height: 900 });
    await page.goto(`file://${path.resolve(reports, name)}`);
    if (scenes.length > 0) await page.waitForSelector("html[data-ready]");
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(wide <= 0, `${name} is ${wide} px too wide at ${width} px`);
    const malformed = (children) =>
      Object.entries(children).flatMap(([tag, count]) =>
        [...document.querySelectorAll(tag)].filter((one) => one.childElementCount !== count).map((one) => one.outerHTML),
      );
    assert.deepEqual(await page.evaluate(malformed, CHILDREN), [], name);
    let moved = 0;
    for (const scene of scenes) {
      for (const handle of await page.$$(`#${scene} [data-handle]`)) {
        if (!(await handle.isVisible())) continue;
        await handle.scrollIntoView();
        await drawn(page);
        // A scene that comes into view is laid out, which may move the handle once more.
        await handle.scrollIntoView();
        const before = await stateOf(page, scene);
        const { x, y, width, height } = await handle.boundingBox();
        await page.mouse.move(x + width / 2, y + height / 2);
        await page.mouse.down();
        await page.mouse.move(x + width / 2 - 24, y + height / 2 + 13, { steps: 4 });
        await drawn(page);
        await page.mouse.up();
        // The detective judges when the handle rests.
        if (scene === "detective") await new Promise((done) => setTimeout(done, 300));
        const { state } = await agrees(page, scene, explorer);
        assert.notDeepEqual(state, before, `${scene}: the mouse does not move ${await handle.evaluate((one) => one.dataset.handle)}`);
        moved += 1;
      }
    }
    assert.ok(moved >= scenes.length);
    for (const scene of name === "learn.html" ? scenes : []) {
      await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
      await page.click(`nav a[href="#${scene}"]`);
      await landed(page, scene, width);
    }
    if (name === "learn.html") {
      await page.goto("about:blank");
      await page.goto(`file://${path.resolve(reports, name)}#friction`);
      await page.waitForSelector("html[data-ready]");
      await landed(page, "friction", width);
    }
    if (pictures) await page.screenshot({ path: `${pictures}/firefox-${name}-${width}.png` });
    assert.deepEqual(errors, [], name);
    await page.close();
    console.log(`Firefox, ${name} at ${width} px: no error, ${moved} handles moved`);
  }
}
await browser.close();
