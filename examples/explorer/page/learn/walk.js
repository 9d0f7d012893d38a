// The walk of the first scene, and the start.

/** Lets the walker go down, one step a frame; at once if the reader wants no motion. */
function play(scene) {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    act(scene, { choose: { name: "walk", value: "end" } });
    return;
  }
  const before = JSON.stringify(scene.state);
  act(scene, { choose: { name: "walk", value: "step" } });
  if (JSON.stringify(scene.state) !== before) requestAnimationFrame(() => play(scene));
}

start().then((ready) => {
  if (!ready) return;
  const valley = scenes[0];
  valley.section.querySelector("button.play").addEventListener("click", () => play(valley));
  document.documentElement.dataset.ready = "true";
}).catch(told);
