// The walk of the first scene, and the start.

/** Lets the walker go down, one step a frame, until the reader does something else; at once if the reader wants no motion. */
function play(scene) {
  scene.plays = true;
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    act(scene, { choose: { name: "walk", value: "end" } });
    return;
  }
  scene.walk = (scene.walk ?? 0) + 1;
  step(scene, scene.walk);
}

/** A step of a walk; a later walk ends it. */
function step(scene, walk) {
  if (!scene.plays || scene.walk !== walk) return;
  const before = JSON.stringify(scene.state);
  act(scene, { choose: { name: "walk", value: "step" } });
  if (JSON.stringify(scene.state) === before) scene.plays = false;
  else requestAnimationFrame(() => step(scene, walk));
}

start().then((ready) => {
  if (!ready) return;
  const valley = scenes[0];
  valley.section.querySelector("button.play").addEventListener("click", () => play(valley));
  document.documentElement.dataset.ready = "true";
}).catch(told);
