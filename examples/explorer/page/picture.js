// The picture: state in, pieces of the page out. All numbers come from the module.

const data = JSON.parse(document.getElementById("data").textContent);
const svg = at("picture");
const copy = (value) => JSON.parse(JSON.stringify(value));
let state = copy(data.standard);
let answer = null;

const ask = (request) => call("respond", request);

// The page.

const PIECES = ["scene", "words", "points", "checks", "prediction", "plot", "numbers"];
const TEXTS = ["gap", "test", "command"];
let frame = 0;
let rest = 0;

/** Draws the state at the next frame; what takes long follows when nothing has moved for a while. */
function redraw() {
  frame ||= requestAnimationFrame(() => {
    frame = 0;
    draw(false);
    clearTimeout(rest);
    rest = setTimeout(() => { draw(true); remember(); }, 200);
  });
}

function draw(equations) {
  const found = ask({ ...state, equations });
  const message = at("message");
  message.hidden = !found.error;
  message.textContent = found.error ?? "";
  if (found.error) return false;
  answer = found;
  for (const id of PIECES) {
    const element = at(id);
    if (element.shown !== found[id]) {
      const scrolled = element.firstElementChild?.scrollLeft;
      element.innerHTML = found[id];
      element.shown = found[id];
      if (scrolled) element.firstElementChild.scrollLeft = scrolled;
    }
  }
  for (const id of TEXTS) at(id).textContent = found[id];
  placeHandles(found.handles);
  if (equations) fillEquations(found.equations);
  if (at("dofs").open) fillDofs();
  return true;
}

function fillEquations(equations) {
  const known = new Map(equations.map((equation) => [equation.number, equation]));
  for (const row of document.querySelectorAll("tr[data-equation]")) {
    const equation = known.get(Number(row.dataset.equation));
    for (const cell of row.querySelectorAll("td[data-cell]")) cell.textContent = equation?.[cell.dataset.cell] ?? "";
  }
}

// Handles.

const SVG = "http://www.w3.org/2000/svg";
let handles = [];

function placeHandles(list) {
  const layer = at("handles");
  const names = list.map((handle) => handle.name).join();
  if (layer.names !== names) {
    layer.names = names;
    handles = list.map((handle) => {
      const group = document.createElementNS(SVG, "g");
      group.setAttribute("class", `handle ${handle.beam ? "r" : "b"}`);
      group.setAttribute("tabindex", "0");
      group.setAttribute("role", "button");
      for (const [name, radius] of [["grip", 17], ["knob", 6.5]]) {
        const circle = document.createElementNS(SVG, "circle");
        circle.setAttribute("class", name);
        circle.setAttribute("r", radius);
        group.append(circle);
      }
      return group;
    });
    layer.replaceChildren(...handles);
    handles.forEach((group, i) => listen(group, i));
    sizeGrips();
  }
  list.forEach((handle, i) => {
    handles[i].setAttribute("transform", `translate(${handle.at[0].toFixed(1)} ${handle.at[1].toFixed(1)})`);
    handles[i].setAttribute("aria-label", `${handle.name}: ${handle.value.map((x) => x.toFixed(3)).join(", ")}`);
  });
}

/** A handle can be touched where it is 44 pixels wide, however small the picture is. */
function sizeGrips() {
  const unit = svg.viewBox.baseVal.width / svg.getBoundingClientRect().width;
  for (const grip of svg.querySelectorAll(".grip")) grip.setAttribute("r", Math.max(17, 22.5 * unit).toFixed(1));
}
new ResizeObserver(sizeGrips).observe(svg);

const rounded = (x) => Math.round(x * 1000) / 1000;
const beam = (which) => (which ? state.bar : state.beam);

/** Moves a handle in space, in units of length: right, up, away. */
function move(i, [right, up, away], from) {
  const { beam: which, start, factor } = answer.handles[i];
  const numbers = beam(which)[state.dragged];
  for (let c = 0; c < 3; c++) {
    const along = right * answer.basis[0][c] + up * answer.basis[1][c] + away * answer.basis[2][c];
    numbers[start + c] = rounded((from ?? answer.handles[i].value)[c] + along / factor);
  }
  redraw();
}

function listen(group, i) {
  let from = null;
  // Parts of a picture do not obey touch-action in every browser: without this the page scrolls.
  group.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  group.addEventListener("pointerdown", (event) => {
    group.setPointerCapture(event.pointerId);
    from = { x: event.clientX, y: event.clientY, value: answer.handles[i].value };
    event.stopPropagation();
  });
  group.addEventListener("pointermove", (event) => {
    if (!from) return;
    const unit = svg.viewBox.baseVal.width / svg.getBoundingClientRect().width / state.view.scale;
    move(i, [(event.clientX - from.x) * unit, (from.y - event.clientY) * unit, 0], from.value);
  });
  for (const end of ["pointerup", "pointercancel"]) group.addEventListener(end, () => { from = null; });
  group.addEventListener("keydown", (event) => {
    const keys = { ArrowRight: [1, 0, 0], ArrowLeft: [-1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0], PageUp: [0, 0, 1], PageDown: [0, 0, -1] };
    const key = keys[event.key];
    if (!key) return;
    event.preventDefault();
    move(i, key.map((x) => x * (event.shiftKey ? 0.1 : 0.02)));
  });
}

// The view: the background turns it.

let turning = null;
svg.addEventListener("pointerdown", (event) => {
  svg.setPointerCapture(event.pointerId);
  turning = { x: event.clientX, y: event.clientY, ...state.view };
});
svg.addEventListener("pointermove", (event) => {
  if (!turning) return;
  const turned = turning.azimuth - (event.clientX - turning.x) / 3;
  state.view.azimuth = Math.round(((turned + 540) % 360 + 360) % 360 - 180);
  state.view.elevation = Math.round(Math.max(-90, Math.min(90, turning.elevation + (event.clientY - turning.y) / 3)));
  showControls();
  redraw();
});
for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => { turning = null; });
