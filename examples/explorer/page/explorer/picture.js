// The picture: dragging the background turns the view, and play moves the beams along the direction.

const svg = at("picture");
let turning = null;

// Parts of a picture do not obey touch-action in every browser: without this the page scrolls.
svg.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
svg.addEventListener("pointerdown", (event) => {
  if (event.target.closest("[data-handle]")) return;
  svg.setPointerCapture(event.pointerId);
  turning = { x: event.clientX, y: event.clientY, ...scenes[0].state.view };
});
svg.addEventListener("pointermove", (event) => {
  if (!turning) return;
  const azimuth = turning.azimuth - (event.clientX - turning.x) / 3;
  const elevation = turning.elevation + (event.clientY - turning.y) / 3;
  schedule(scenes[0], { choose: { name: "view", value: `${azimuth} ${elevation}` } });
});
for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => { turning = null; });

/** A handle can be touched where it is 44 pixels wide, however small the picture is. */
function sizeGrips() {
  for (const picture of [svg, at("map")]) {
    const unit = picture.viewBox.baseVal.width / picture.getBoundingClientRect().width;
    for (const grip of picture.querySelectorAll(".grip")) grip.setAttribute("r", Math.max(17, 22.5 * unit).toFixed(1));
  }
}

/** The time in which the beams go along the direction and back, in milliseconds. */
const ROUND = 6000;
let playing = null;

function play() {
  const { step } = scenes[0].state;
  // Without motion each press goes a quarter further.
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    act(scenes[0], { choose: { name: "step", value: String(step < 1 ? Math.min(1, step + 0.25) : 0) } });
    return;
  }
  if (playing) stop();
  else playing = { start: performance.now() - (step * ROUND) / 2, frame: requestAnimationFrame(goOn) };
  press(at("play"), playing !== null);
}

function stop() {
  cancelAnimationFrame(playing.frame);
  playing = null;
}

function goOn(now) {
  const part = ((now - playing.start) / ROUND) % 1;
  schedule(scenes[0], { choose: { name: "step", value: (1 - Math.abs(1 - 2 * part)).toFixed(4) } });
  playing.frame = requestAnimationFrame(goOn);
}

at("play").addEventListener("click", play);

/** The minima on the map are buttons. */
for (const minimum of at("map").querySelectorAll("[data-minimum]")) {
  const choose = () => act(scenes[0], { choose: { name: "minimum", value: minimum.dataset.minimum } });
  minimum.addEventListener("click", choose);
  minimum.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    choose();
  });
}
