// The walk of the first scene, the sliders, and the start.

/** The ends of a slider, beyond every picture. */
const ENDS = { Home: -10000, End: 10000 };

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

/** Home and End of the sliders. The slider of a run has an end and a way between two values that change. */
function listenToSliders(scene) {
  for (const slider of scene.section.querySelectorAll("[role=slider]")) {
    const name = slider.dataset.handle;
    slider.addEventListener("keydown", (event) => {
      if (!(event.key in ENDS)) return;
      event.preventDefault();
      schedule(scene, { drag: { handle: name, to: [ENDS[event.key], scene.places[name][1]] } });
    });
    scene.after = ({ controls }) => {
      const max = controls[`${name}_max`];
      if (max) slider.setAttribute("aria-valuemax", max);
      // From one whole number to the next there is no smaller way.
      slider.dataset.least = controls[`${name}_way`] ?? 0;
      slider.dataset.way = controls[`${name}_way`] ?? 10;
    };
    act(scene, null);
  }
}

/** Tells a scene when its handle rests. */
function rest(scene) {
  clearTimeout(scene.rest);
  scene.rest = setTimeout(() => act(scene, { choose: { name: "rest", value: "" } }), 180);
}

start().then((ready) => {
  if (!ready) return;
  for (const scene of scenes) {
    for (const handle of scene.section.querySelectorAll("[data-handle]")) {
      if (handle.getAttribute("role") !== "slider") handle.setAttribute("aria-roledescription", "movable point");
      handle.setAttribute("aria-describedby", "keys");
    }
    listenToSliders(scene);
    if ("rest" in scene.section.dataset) scene.moved = () => rest(scene);
  }
  const valley = scenes[0];
  for (const event of ["pointerdown", "keydown", "click"]) {
    valley.section.addEventListener(event, () => { valley.plays = false; }, true);
  }
  valley.section.querySelector("button.play").addEventListener("click", () => play(valley));
  document.documentElement.dataset.ready = "true";
}).catch(told);
