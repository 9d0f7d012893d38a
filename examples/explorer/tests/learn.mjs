// The page of the scenes in a browser: every handle is moved by mouse, touch and keys, every control is used, and what the page
// shows is compared with the frame that the library computes natively for the same state.
//
// node learn.mjs REPORTS EXPLORER [SCREENSHOTS]; EXPLORER is the program `beamgap-explorer`.
import { WIDTHS, agrees, browser, drawn, frames, landed, looks, middle, opened, speed, stateOf, touched } from "./shared.mjs";
import assert from "node:assert/strict";

const [reports, explorer, pictures] = process.argv.slice(2);
const SCENES = ["valley", "normal", "slide", "lines", "envelope", "race", "detective", "friction"];
const openedPage = (options) => opened(reports, "learn.html", options);
const shows = async (page, scene) => (await agrees(page, scene, explorer)).state;

/** Every handle by mouse and keys, at every width. */
async function handles(width, colorScheme) {
  const { page, close } = await openedPage({ viewport: { width, height: 900 }, colorScheme });
  let count = 0;
  for (const scene of SCENES) {
    const names = await page.locator(`#${scene} [data-handle]`).evaluateAll((all) => all.map((one) => one.dataset.handle));
    assert.ok(names.length > 0);
    for (const name of names) {
      const handle = page.locator(`#${scene} [data-handle="${name}"]`);
      const before = await shows(page, scene);
      const [x, y] = await middle(page, handle);
      const box = await handle.locator(".grip").boundingBox();
      assert.ok(Math.min(box.width, box.height) >= 44, `${scene}: the handle ${name} is ${box.width} px wide at ${width} px`);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x - 24, y + 13, { steps: 4 });
      await drawn(page);
      await page.mouse.up();
      await page.waitForTimeout(scene === "detective" ? 300 : 0);
      const dragged = await shows(page, scene);
      assert.notDeepEqual(dragged, before, `${scene}: the mouse does not move ${name}`);
      await handle.focus();
      for (const key of ["ArrowRight", "ArrowUp"]) await page.keyboard.press(key);
      await page.waitForTimeout(scene === "detective" ? 300 : 0);
      const pressed = await shows(page, scene);
      assert.notDeepEqual(pressed, dragged, `${scene}: keys do not move ${name}`);
      count += 1;
    }
  }
  await close();
  return count;
}

/** A finger moves a handle of each scene. */
async function touch() {
  const { page, close } = await openedPage({ hasTouch: true, viewport: { width: 400, height: 800 } });
  for (const scene of SCENES) {
    const before = await shows(page, scene);
    await touched(page, page.locator(`#${scene} [data-handle]`).first());
    await page.waitForTimeout(scene === "detective" ? 300 : 30);
    assert.notDeepEqual(await shows(page, scene), before, `${scene}: a finger does not move the handle`);
  }
  await close();
}

/** Every button and range, terms that light their parts, the walk, and the cases of the detective. */
async function controls() {
  const { page, close } = await openedPage();
  for (const scene of SCENES) {
    for (const button of await page.locator(`#${scene} button[data-choose]`).all()) {
      const { height } = await button.boundingBox();
      assert.ok(height >= 44, `${scene}: a button is ${height} px high`);
      await button.click();
      await shows(page, scene);
    }
    for (const term of await page.locator(`#${scene} [data-term]`).all()) {
      await term.hover();
      const name = await term.getAttribute("data-term");
      const lit = await page.locator(`#${scene} .lit`).count();
      const parts = await page.locator(`#${scene} [data-part~="${name}"]`).count();
      assert.equal(lit, parts, `${scene}: ${name}`);
      assert.ok(parts > 0, `${scene}: ${name} lights nothing`);
    }
    await page.mouse.move(0, 0);
    assert.equal(await page.locator(".lighting").count(), 0);
  }
  await sliders(page);
  for (const range of await page.locator("input[type=range]").all()) {
    await range.focus();
    await page.keyboard.press("ArrowLeft");
    await shows(page, "race");
  }
  const walker = page.locator('[data-handle="walker"]');
  const [x, y] = await middle(page, walker);
  await page.click('[data-to="crossing"]');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 40, { steps: 3 });
  await page.mouse.up();
  // A reader who grips the handle ends the walk. The mouse waits at the handle, so that the walk is not at its end before.
  await page.evaluate(() => { document.getElementById("valley").scene.state.at = [0.98, -0.98]; });
  await walker.focus();
  await page.keyboard.press("ArrowLeft");
  await shows(page, "valley");
  await page.mouse.move(...await middle(page, walker));
  await page.evaluate(() => document.querySelector("#valley button.play").click());
  await page.mouse.down();
  await drawn(page);
  const gripped = await stateOf(page, "valley");
  await page.waitForTimeout(300);
  assert.deepEqual(await stateOf(page, "valley"), gripped, "the walk goes on while the handle is gripped");
  await page.mouse.up();
  await page.click("button.play");
  await page.waitForTimeout(3000);
  const walked = await shows(page, "valley");
  assert.ok(Math.hypot(walked.at[0] - gripped.at[0], walked.at[1] - gripped.at[1]) > 0.1, "the walk was at its end before the grip");
  const [bottom] = frames(explorer, [["valley", walked]]);
  assert.ok(Math.abs(Number(bottom.values.F_xi.replace("−", "-"))) < 0.01, "the walk ends at a minimum");
  // A right answer is explained.
  for (let i = 0; i < 6; i++) {
    await page.click(`#detective [data-choose="suspect"][data-to="${i}"]`);
    await shows(page, "detective");
  }
  assert.equal(await page.locator('#detective [data-choose="suspect"][aria-pressed="true"]').count(), 1);
  await close();
}

/** Home and End go to the ends of a slider, Ctrl and Alt make a step smaller, Shift larger. */
async function sliders(page) {
  await page.click('#race [data-to="sign_b"]');
  for (const slider of await page.locator("[role=slider]").all()) {
    const now = async (name) => Number(await slider.getAttribute(`aria-value${name}`));
    await slider.focus();
    for (const [key, end] of [["Home", "min"], ["End", "max"]]) {
      await page.keyboard.press(key);
      await drawn(page);
      assert.equal(await now("now"), await now(end), key);
    }
  }
  const place = (name) => page.evaluate((name) => document.getElementById("normal").scene.places[name][0], name);
  const way = async (key) => {
    const before = await place("both");
    await page.locator('[data-handle="both"]').focus();
    await page.keyboard.press(key);
    await drawn(page);
    return Math.abs((await place("both")) - before);
  };
  const [usual, fine, also, wide] = [await way("ArrowLeft"), await way("Control+ArrowLeft"), await way("Alt+ArrowLeft"), await way("Shift+ArrowRight")];
  assert.ok(fine > 0 && fine < 0.2 * usual && also > 0 && also < 0.2 * usual && wide > 3 * usual, `${usual}, ${fine}, ${also}, ${wide}`);
}

/** Every link of the contents lands on its scene, also when the page opens at it. */
async function links() {
  for (const width of [1280, 400]) {
    const viewport = { width, height: 900 };
    const { page, close } = await openedPage({ viewport });
    for (const scene of SCENES) {
      await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
      await page.click(`nav a[href="#${scene}"]`);
      await landed(page, scene, width);
    }
    await close();
    for (const scene of ["lines", "friction"]) {
      const { page, close } = await openedPage({ viewport, fragment: `#${scene}` });
      await landed(page, scene, width);
      await close();
    }
  }
}

/** The map is seen: without it the screen is lighter. */
async function shades() {
  const { page, close } = await openedPage();
  const map = page.locator("#valley canvas[data-shades]");
  await map.scrollIntoViewIfNeeded();
  await drawn(page);
  const clip = await map.boundingBox();
  const pictures = [await page.screenshot({ clip })];
  await map.evaluate((canvas) => { canvas.style.visibility = "hidden"; });
  pictures.push(await page.screenshot({ clip }));
  const [shaded, bare] = await page.evaluate((all) => Promise.all(all.map(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = context.getImageData(0, 0, image.width, image.height).data;
    return pixels.reduce((sum, channel) => sum + channel, 0) / pixels.length;
  })), pictures.map((picture) => picture.toString("base64")));
  assert.ok(bare - shaded > 5, `the map darkens the screen by ${bare - shaded} of 255`);
  await close();
}

/** Without motion the walk ends at once. */
async function still() {
  const { page, close } = await openedPage({ reducedMotion: "reduce" });
  const before = await stateOf(page, "valley");
  await page.click("button.play");
  const after = await shows(page, "valley");
  assert.notDeepEqual(after, before);
  await page.click("button.play");
  const again = await shows(page, "valley");
  assert.ok(Math.abs(again.at[0] - after.at[0]) < 0.01 && Math.abs(again.at[1] - after.at[1]) < 0.01);
  await close();
}

try {
  for (const width of WIDTHS) {
    for (const scheme of ["light", "dark"]) await handles(width, scheme);
  }
  console.log("learn.html: every handle moves by mouse and keys, and the page shows the library's numbers");
  await touch();
  await controls();
  await links();
  await still();
  await shades();
  console.log("learn.html: touch, buttons, terms, sliders, links and the walk work");
  await looks(reports, "learn.html", { pictures, characters: 15000 });
  await speed(reports, "learn.html", SCENES);
} finally {
  await browser.close();
}
