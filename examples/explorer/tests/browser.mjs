// The explorer in a browser: every handle and every control is used by mouse, touch and keys, and what the page shows is compared
// with the frame that the library computes natively for the same state. The other pages are looked at in every size and scheme.
// The documentation, where it is built, is searched for the numbers of the equations.
//
// node browser.mjs REPORTS BEAMGAP EXPLORER [SCREENSHOTS]; BEAMGAP is the command, EXPLORER the program `beamgap-explorer`.
import { WIDTHS, agrees, browser, drawn, looks, middle, opened, speed, stateOf, touched } from "./shared.mjs";
import { execSync } from "node:child_process";
import { existsSync, writeFileSync, mkdtempSync } from "node:fs";
import assert from "node:assert/strict";
import os from "node:os";
import path from "node:path";

const [reports, beamgap, explorer, pictures] = process.argv.slice(2);
const openedPage = (options) => opened(reports, "explorer.html", options);
const shows = (page) => agrees(page, "explorer", explorer);
/** The tables follow when nothing has moved for a while. */
const rested = (page) => page.waitForTimeout(450);
const choose = async (page, name, value) => {
  await page.selectOption(`[data-choose="${name}"]`, value);
  await drawn(page);
};
const situation = async (page, name) => {
  await page.click(`[data-choose="situation"][data-to="${name}"]`);
  return shows(page);
};

/** Every handle of every kind by mouse and keys. */
async function handles(width, colorScheme) {
  const { page, close } = await openedPage({ viewport: { width, height: 900 }, colorScheme });
  let count = 0;
  for (const dragged of ["q", "dq", "linear_dq"]) {
    await page.check(`input[value="${dragged}"][data-choose="dragged"]`);
    await drawn(page);
    for (const handle of await page.locator("[data-handle]:visible").all()) {
      const before = (await shows(page)).state;
      const name = await handle.getAttribute("data-handle");
      const [x, y] = await middle(page, handle);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x - 14, y + 9, { steps: 3 });
      await drawn(page);
      await page.mouse.up();
      const moved = (await shows(page)).state;
      assert.notDeepEqual(moved, before, `the mouse does not move ${name}`);
      await handle.focus();
      for (const key of ["ArrowRight", "ArrowUp"]) await page.keyboard.press(key);
      const pressed = (await shows(page)).state;
      assert.notDeepEqual(pressed, moved, `keys do not move ${name}`);
      await page.keyboard.press("PageUp");
      assert.notDeepEqual((await shows(page)).state, pressed, `page up does not move ${name}`);
      count += 1;
    }
  }
  await close();
  return count;
}

/** Faults: a term is clicked, and the numbers, the picture, the checks and the command show it. */
async function faults() {
  const { page, close } = await openedPage();
  const says = (check) => page.textContent(`#checks tr:has(th:text-is("${check}")) td:nth-child(3)`);
  await page.click("summary:text-is('The checks')");
  await rested(page);
  assert.match(await says("automatic differentiation"), /agrees/);
  for (const shown of ["gap", "xi", "x", "d", "t", "length", "slip"]) {
    await choose(page, "shown", shown);
    for (const order of ["1", "2", "3"]) {
      await page.check(`input[value="${order}"][data-choose="order"]`);
      await shows(page);
      const terms = page.locator(".formulas .term:visible");
      const count = await terms.count();
      assert.ok(count > 0 || (order === "3" && "xdt".includes(shown)), `${shown}${order} has no terms`);
      if (count === 0) continue;
      const term = terms.first();
      await term.click();
      const { state } = await shows(page);
      const name = await term.getAttribute("data-name");
      assert.equal(state.fault.split(" = ")[0], name);
      assert.equal(await term.getAttribute("aria-pressed"), "true");
      assert.ok((await page.locator("#kinds [data-kind]:visible").count()) >= 3);
      if (order !== "3" && shown === "xi") assert.ok((await page.locator(".ghost:visible:not(:empty)").count()) > 0, `${name}: no right value is shown`);
      await term.click();
      assert.equal((await shows(page)).state.fault, null, "a second click repairs the term");
    }
  }
  await choose(page, "shown", "xi");
  await page.check('input[value="1"][data-choose="order"]');
  await page.click('.term[data-name="a: d.t,xi"]:visible');
  await page.click('#kinds button:text-is("sign")');
  const { state, frame } = await shows(page);
  assert.equal(state.fault, "a: d.t,xi = sign");
  assert.notEqual(frame.paths.map_right, "", "no ghost on the map");
  await rested(page);
  assert.match(await says("automatic differentiation"), /WRONG/);
  assert.match(await says("symmetry"), /agrees/);
  assert.match(await page.textContent("#lesson"), /AD detects this fault/);

  // The command gives the same verdict.
  await page.click("summary:text-is('Case file, Rust test and command')");
  await page.waitForFunction(() => document.getElementById("command").textContent.includes("--plant"));
  const command = (await page.textContent("#command")).replace("| beamgap", `| ${path.resolve(beamgap)}`);
  let status = 0;
  try { execSync(command, { stdio: "pipe" }); } catch (error) { status = error.status; }
  assert.equal(status, 1, "the command shows the fault");
  execSync(command.replace(/ --plant .*/, ""), { stdio: "pipe" });
  for (const lesson of await page.locator('[data-choose="lesson"]').all()) {
    await lesson.click();
    await shows(page);
    assert.equal(await lesson.getAttribute("aria-pressed"), "true");
  }
  // Terms light their parts of the picture.
  await choose(page, "shown", "gap");
  await page.check('input[value="1"][data-choose="order"]');
  await page.hover('.term[data-name="n: t x t_bar"]:visible');
  assert.deepEqual(await page.locator(".lit").evaluateAll((all) => [...new Set(all.map((one) => one.dataset.part))].sort()), ["t", "t_bar"]);
  await close();
}

/** Situations, minima, families, the view, and numbers by hand. */
async function controls() {
  const { page, close } = await openedPage();
  for (const [name, words] of [["parallel", /parallel along/], ["nearly parallel", /nearly parallel.*D is −1\.4e−6.*−84225/], ["crossing", /d = 0/], ["overlap", /overlap/], ["at an end", /end of the/], ["two minima", /2 minima/]]) {
    await situation(page, name);
    assert.match(await page.textContent(".sentence"), words);
  }
  const overlap = await situation(page, "overlap");
  assert.notEqual(overlap.frame.paths.overlap, "");
  await situation(page, "two minima");
  const first = await page.textContent('[data-value="gap"]');
  await page.locator('[data-minimum="1"]').first().click();
  assert.equal((await shows(page)).state.minimum, 1);
  await page.click("summary:text-is('Closest points')");
  await rested(page);
  await page.click('#points button[data-minimum="0"]');
  assert.equal((await shows(page)).state.minimum, 0);
  assert.equal(await page.textContent('[data-value="gap"]'), first);
  for (const family of ["segment", "quadratic", "cubic", "hermite", "hermite-scaled", "bezier", "bspline", "nurbs", "nurbs-weighted", "arc", "helix"]) {

    await choose(page, "family-bar", family);
    await shows(page);
  }
  // The background turns the view, by mouse.
  const before = await stateOf(page, "explorer");
  await page.evaluate(() => scrollTo(0, 0));
  const { x, y } = await page.locator("#picture").boundingBox();
  await page.mouse.move(x + 30, y + 30);
  await page.mouse.down();
  await page.mouse.move(x + 90, y + 60, { steps: 3 });
  await page.mouse.up();
  assert.notDeepEqual((await shows(page)).state.view, before.view);
  for (const range of await page.locator("input[type=range]").all()) {
    const { state } = await shows(page);
    await range.focus();
    await page.keyboard.press("ArrowRight");
    assert.notDeepEqual((await shows(page)).state, state);
  }
  // Numbers by hand, and all tables open.
  await page.click("#dofs summary");
  const gap = await page.textContent('[data-value="gap"]');
  await page.fill('[aria-label="q 3 of the beam"]', "0.91");
  await shows(page);
  assert.notEqual(await page.textContent('[data-value="gap"]'), gap);
  await page.click("#paper summary");
  await rested(page);
  assert.match(await page.textContent('tr[data-equation="52"] [data-cell="formula"]'), /\d/);
  await close();
}

/** Play moves the step and stops; without motion it goes a quarter at a time. */
async function play() {
  let { page, close } = await openedPage();
  const before = await stateOf(page, "explorer");
  await page.click("#play");
  await page.waitForTimeout(700);
  await page.click("#play");
  const { state } = await shows(page);
  assert.notEqual(state.step, before.step);
  await page.waitForTimeout(200);
  assert.deepEqual(await stateOf(page, "explorer"), state, "play does not stop");
  await close();
  ({ page, close } = await openedPage({ reducedMotion: "reduce" }));
  await page.click("#play");
  assert.equal((await shows(page)).state.step, 0.5);
  await close();
}

/** The address holds the state; a case is copied, read by the commands, opened and dropped. */
async function elsewhere() {
  let { page, close } = await openedPage();
  await situation(page, "at an end");
  await choose(page, "shown", "slip");
  await page.click('[data-choose="lesson"][data-to^="a: d.t,xi"]');
  const { state } = await shows(page);
  await rested(page);
  const link = page.url();
  // Files may not use the clipboard in every browser, so the test takes what the page writes to it.
  const copied = async (button) => {
    await page.evaluate(() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; });
    await page.click(button);
    await page.waitForFunction(() => document.getElementById("copied").textContent === "copied");
    return page.evaluate(() => window.copied);
  };
  const [file, vectors] = [await copied("#copy-case"), await copied("#copy-vectors")];
  assert.equal(await copied("#copy-link"), link);
  await close();
  ({ page, close } = await openedPage({ fragment: "#" + link.split("#")[1] }));
  assert.deepEqual({ ...(await shows(page)).state, equations: state.equations }, state, "the address does not hold the state");
  await close();

  const folder = mkdtempSync(path.join(os.tmpdir(), "explorer-"));
  const paths = { case: path.join(folder, "case.json"), vectors: path.join(folder, "vectors.jsonl") };
  writeFileSync(paths.case, file);
  writeFileSync(paths.vectors, vectors);
  const run = (rest) => execSync(`${path.resolve(beamgap)} ${rest}`, { stdio: "pipe" }).toString();
  assert.match(run(`check --case-file ${paths.case}`), /AGREE|agree/);
  assert.match(run(`verify ${paths.vectors} --run "${path.resolve(beamgap)} evaluate"`), /AGREE/);

  ({ page, close } = await openedPage());
  for (const one of [paths.case, paths.vectors]) {
    await situation(page, "standard");
    await page.setInputFiles("#file", one);
    await page.waitForTimeout(200);
    assert.deepEqual((await shows(page)).state.beam, state.beam, `${one} is not opened`);
  }
  await situation(page, "standard");
  const dropped = async (text) => {
    await page.evaluate((text) => {
      const files = new DataTransfer();
      files.items.add(new File([text], "case.json"));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
    }, text);
    await page.waitForTimeout(200);
  };
  await dropped(file);
  assert.deepEqual((await shows(page)).state.bar, state.bar, "a case is not dropped");
  await dropped("nonsense");
  assert.match(await page.textContent("#message"), /not a case/);
  await close();

  // A broken link is told.
  ({ page, close } = await openedPage({ fragment: "#bm9uc2Vuc2U" }));
  assert.match(await page.textContent("#message"), /link/);
  await shows(page);
  await close();
}

/** A finger moves a handle and turns the view, and the page does not scroll. */
async function touch() {
  const { page, close } = await openedPage({ hasTouch: true, viewport: { width: 400, height: 800 } });
  for (const name of ["r0", "b2"]) {
    const { state } = await shows(page);
    await touched(page, page.locator(`[data-handle="${name}"]`));
    assert.notDeepEqual((await shows(page)).state, state, `a finger does not move ${name}`);
  }
  const { state } = await shows(page);
  await touched(page, page.locator("#picture"));
  assert.notDeepEqual((await shows(page)).state.view, state.view, "a finger does not turn the view");
  await close();
}

/** At 1280 px the picture has two thirds of the width, the formulas are beside it, and tables are folded. */
async function layout() {
  const { page, close } = await openedPage();
  const box = (selector) => page.locator(selector).first().boundingBox();
  const [picture, formulas, map] = [await box("#picture"), await box(".formulas"), await box("#map")];
  assert.ok(picture.width >= 0.62 * 1280, `the picture is ${picture.width} px wide`);
  for (const beside of [formulas, map]) assert.ok(beside.x > picture.x + picture.width && beside.y < picture.y + picture.height);
  assert.equal(await page.locator("details[open]").count(), 0);
  const letters = await page.locator("#picture text:visible").evaluateAll((all) => all.map((one) => one.getBoundingClientRect().toJSON()));
  for (const [i, one] of letters.entries()) {
    for (const other of letters.slice(0, i)) {
      const apart = one.right <= other.left || other.right <= one.left || one.bottom <= other.top || other.bottom <= one.top;
      assert.ok(apart, "letters of the picture collide");
    }
  }
  await close();
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
  await layout();
  for (const width of WIDTHS) {
    for (const scheme of ["light", "dark"]) assert.ok((await handles(width, scheme)) >= 24);
  }
  console.log("explorer.html: every handle moves by mouse and keys, and the page shows the library's numbers");
  await faults();
  await controls();
  await play();
  await elsewhere();
  await touch();
  console.log("explorer.html: touch, faults, situations, play, links and case files work");
  await looks(reports, "explorer.html", { pictures });
  await looks(reports, "benchmark.html", { pictures, targets: false });
  await looks(reports, "derivation.html", { pictures, widths: [400, 1200, 1800], targets: false });
  await speed(reports, "explorer.html", ["explorer"]);
} finally {
  await browser.close();
}
