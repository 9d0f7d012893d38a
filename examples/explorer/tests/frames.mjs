// What a page shows, against the frames that the library computes natively. In any browser: a page has `evaluate`.
import { execFileSync } from "node:child_process";
import assert from "node:assert/strict";

/** The native frames of states; `explorer` is the program `beamgap-explorer`. */
export function frames(explorer, states) {
  const input = states.map(([scene, state]) => JSON.stringify({ scene, state })).join("\n") + "\n";
  return execFileSync(explorer, ["frames"], { input, maxBuffer: 1 << 28 }).toString().trim().split("\n").map((line) => JSON.parse(line));
}

export const stateOf = (page, scene) => page.evaluate((id) => document.getElementById(id).scene.state, scene);
/** Two frames: one for the action, one to be sure that it is drawn. */
export const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** What a scene shows: texts, paths and places by name. */
const shownBy = (page, scene) => page.evaluate((id) => {
  const section = document.getElementById(id);
  const all = (kind, read) => [...section.querySelectorAll(`[data-${kind}]`)].map((element) => [element.dataset[kind], read(element)]);
  return {
    values: all("value", (element) => element.textContent),
    paths: all("path", (element) => element.getAttribute("d")),
    places: all("place", (element) => (element.style.display === "none" ? null : element.getAttribute("transform"))),
    shown: all("shown", (element) => !element.hidden),
    labels: all("label", (element) => element.getAttribute("aria-label")),
  };
}, scene);

/** Fails unless the page shows the library's frame of its state. A value that no visible formula has may be an old one. */
export async function agrees(page, scene, explorer) {
  await drawn(page);
  const state = await stateOf(page, scene);
  const [frame] = frames(explorer, [[scene, state]]);
  assert.deepEqual(frame.state, state);
  const { values, paths, places, shown, labels } = await shownBy(page, scene);
  assert.ok(values.length > 0 && paths.length > 0 && places.length > 0);
  for (const [name, text] of values) if (name in frame.values || scene !== "explorer") assert.equal(text, frame.values[name], `${scene}: ${name}`);
  // The page of a scene need not show everything; that of the explorer shows all.
  for (const [kind, all] of scene === "explorer" ? Object.entries({ values, paths, places }) : []) {
    const known = new Set(all.map(([name]) => name));
    for (const name in frame[kind]) assert.ok(known.has(name), `the page has nothing for ${kind} ${name}`);
  }
  for (const [name, data] of paths) assert.equal(data ?? "", frame.paths[name], `${scene}: ${name}`);
  for (const [name, is] of shown) assert.equal(is, frame.shown[name], `${scene}: ${name}`);
  for (const [name, label] of labels) if (frame.labels[name]) assert.equal(label, frame.labels[name], `${scene}: ${name}`);
  for (const [name, transform] of places) {
    const place = frame.places[name];
    assert.equal(transform, place && `translate(${place[0]} ${place[1]})`, `${scene}: ${name}`);
  }
  return { state, frame };
}

/** Fails unless a link to a section has scrolled it to the top of the window, or the page to its end. */
export async function landed(page, id, width) {
  const [top, rest] = await page.evaluate((id) => new Promise((done) => {
    let [last, still] = [-1, 0];
    const look = () => {
      // At rest for some frames: the way there may be smooth.
      still = scrollY === last ? still + 1 : 0;
      last = scrollY;
      if (still < 20) return requestAnimationFrame(look);
      const { scrollHeight, clientHeight } = document.documentElement;
      done([document.getElementById(id).getBoundingClientRect().top, scrollHeight - clientHeight - scrollY]);
    };
    look();
  }), id);
  assert.ok((top > -2 && top < 20) || (rest < 2 && top > -2 && top < 900), `the link to ${id} lands ${top} px above it at ${width} px`);
}
