// Mouse, touch and keys.

const KEYS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
/** Away from the eye and towards it, in units of length. */
const DEPTHS = { PageUp: 0.03, PageDown: -0.03 };
/** The way of a handle for one key, in units of the picture. */
const WAY = 6;
/** Shift makes the way of a key larger, Ctrl or Alt smaller. */
const factor = (event) => (event.shiftKey ? 4 : event.ctrlKey || event.altKey ? 0.1 : 1);

function listen(scene, handle) {
  const svg = handle.ownerSVGElement;
  const name = handle.dataset.handle;
  const isSlider = handle.getAttribute("role") === "slider";
  let grip = null;
  // Parts of a picture do not obey touch-action in every browser: without this the page scrolls.
  handle.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  handle.addEventListener("pointerdown", (event) => {
    handle.setPointerCapture(event.pointerId);
    const scale = svg.viewBox.baseVal.width / svg.getBoundingClientRect().width;
    grip = { x: event.clientX, y: event.clientY, scale, place: scene.places[name] };
    event.preventDefault();
    handle.focus({ preventScroll: true });
  });
  handle.addEventListener("pointermove", (event) => {
    if (!grip) return;
    const to = [
      grip.place[0] + (event.clientX - grip.x) * grip.scale,
      grip.place[1] + (event.clientY - grip.y) * grip.scale,
    ];
    schedule(scene, { drag: { handle: name, to } });
  });
  for (const end of ["pointerup", "pointercancel"]) handle.addEventListener(end, () => { grip = null; });
  handle.addEventListener("keydown", (event) => {
    const depth = DEPTHS[event.key];
    if (depth && !isSlider) {
      event.preventDefault();
      schedule(scene, { push: { handle: name, by: depth * factor(event) } });
      return;
    }
    const key = KEYS[event.key];
    if (!key) return;
    event.preventDefault();
    // A slider has its own way, and up is more on it.
    const way = Math.max(factor(event) * (handle.dataset.way ?? WAY), handle.dataset.least ?? 0);
    const [right, down] = isSlider ? [key[0] - key[1], 0] : key;
    const place = scene.places[name];
    schedule(scene, { drag: { handle: name, to: [place[0] + way * right, place[1] + way * down] } });
  });
}

/** Buttons and sliders of a scene. */
function listenToControls(scene) {
  for (const element of scene.section.querySelectorAll("[data-choose]")) {
    const name = element.dataset.choose;
    if (element.tagName === "INPUT" || element.tagName === "SELECT") {
      element.addEventListener("input", () => {
        // The state may not take the value: the control shows again what it has.
        scene.last.control.delete(name);
        if (element.checkValidity()) schedule(scene, { choose: { name, value: element.value } });
      });
    } else {
      element.addEventListener("click", () => act(scene, { choose: { name, value: element.dataset.to } }));
    }
  }
}

/** A term lights its parts of the pictures, while it is pointed at or focused. In the explorer it has a list of them. */
function light(scene) {
  const parts = [...scene.section.querySelectorAll("[data-part]")];
  const set = (name) => {
    scene.section.classList.toggle("lighting", name !== null);
    const names = name?.split(" ") ?? [];
    for (const part of parts) part.classList.toggle("lit", part.dataset.part.split(" ").some((of) => names.includes(of)));
  };
  for (const term of scene.section.querySelectorAll("[data-term], [data-light]")) {
    const on = () => set((term.dataset.light ?? term.dataset.term) || null);
    for (const event of ["pointerenter", "focus"]) term.addEventListener(event, on);
    for (const event of ["pointerleave", "blur"]) term.addEventListener(event, () => set(null));
  }
}

/** Compiles the module and opens all scenes; whether it has done so. */
async function start() {
  await compile();
  for (const section of document.querySelectorAll("[data-scene]")) {
    const scene = sceneOf(section);
    scenes.push(scene);
    if (!act(scene, null)) return false;
    for (const handle of section.querySelectorAll("[data-handle]")) listen(scene, handle);
    listenToControls(scene);
    light(scene);
  }
  return true;
}

function told(error) {
  at("message").textContent = `The module does not start: ${error}`;
  at("message").hidden = false;
}
