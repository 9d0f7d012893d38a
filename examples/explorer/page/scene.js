// The scenes: a frame of the module sets texts and attributes of existing elements. Nothing is computed here.

const scenes = [];
const PARTS = ["value", "path", "place", "shades", "shown", "label", "width"];

/** A scene with its elements by kind and name. */
function sceneOf(section) {
  const scene = { section, name: section.dataset.scene, state: null, places: {}, pending: null, last: { control: new Map() } };
  for (const kind of PARTS) {
    scene[kind] = new Map();
    scene.last[kind] = new Map();
    for (const element of section.querySelectorAll(`[data-${kind}]`)) {
      const name = element.dataset[kind];
      if (!scene[kind].has(name)) scene[kind].set(name, []);
      scene[kind].get(name).push(element);
    }
  }
  scene.controls = new Map();
  for (const element of section.querySelectorAll("[data-choose], [data-handle]")) {
    const name = element.dataset.choose ?? element.dataset.handle;
    scene.controls.set(name, [...(scene.controls.get(name) ?? []), element]);
  }
  section.scene = scene;
  return scene;
}

/** Asks for the frame after an action, or a part of it, and shows it. */
function act(scene, action, part) {
  const frame = call("learn", { scene: scene.name, state: scene.state, action, part });
  const message = at("message");
  message.hidden = !frame.error;
  message.textContent = frame.error ?? "";
  if (frame.error) return false;
  scene.state = frame.state;
  show(scene, frame);
  scene.after?.(frame);
  return true;
}

const NONE = [];

/** The elements of a name, if its content has changed. */
function changed(scene, kind, name, content) {
  const last = scene.last[kind];
  if (last.get(name) === content) return NONE;
  last.set(name, content);
  return scene[kind].get(name) ?? NONE;
}

function show(scene, frame) {
  for (const name in frame.values) {
    const text = frame.values[name];
    for (const element of changed(scene, "value", name, text)) write(element, text);
  }
  for (const name in frame.paths) {
    const path = frame.paths[name];
    for (const element of changed(scene, "path", name, path)) element.setAttribute("d", path);
  }
  for (const name in frame.places) {
    const place = frame.places[name];
    scene.places[name] = place;
    const transform = place && `translate(${place[0]} ${place[1]})`;
    for (const element of changed(scene, "place", name, transform)) move(element, transform);
  }
  for (const name in frame.shades) {
    const letters = frame.shades[name];
    for (const canvas of changed(scene, "shades", name, letters)) shade(canvas, letters);
  }
  for (const name in frame.shown) {
    const is = frame.shown[name];
    for (const element of changed(scene, "shown", name, is)) element.hidden = !is;
  }
  for (const name in frame.labels) {
    const label = frame.labels[name];
    for (const element of changed(scene, "label", name, label)) element.setAttribute("aria-label", label);
  }
  for (const name in frame.widths) {
    const width = frame.widths[name];
    for (const element of changed(scene, "width", name, width)) element.style.setProperty("--w", `${width}px`);
  }
  for (const name in frame.controls) control(scene, name, frame.controls[name]);
}

/** Changes the text of an element. A node that is kept costs half of a new one. */
function write(element, text) {
  const node = element.firstChild;
  if (node && text) node.data = text;
  else element.textContent = text;
}

function move(element, transform) {
  if (transform) element.setAttribute("transform", transform);
  const display = transform ? "" : "none";
  if (element.style.display !== display) element.style.display = display;
}

/** A map: the letter of each point is its opacity. */
function shade(canvas, letters) {
  const context = (canvas.context ??= canvas.getContext("2d"));
  const image = (canvas.image ??= context.createImageData(canvas.width, canvas.height));
  for (let i = 0; i < letters.length; i++) image.data[4 * i + 3] = 9 * (letters.charCodeAt(i) - 97);
  context.putImageData(image, 0, 0);
}

function control(scene, name, value) {
  if (scene.last.control.get(name) === value) return;
  scene.last.control.set(name, value);
  for (const element of scene.controls.get(name) ?? []) {
    if (element.dataset.handle) element.setAttribute("aria-valuenow", value);
    else if (element.type === "radio") element.checked = element.value === value;
    // What the reader types is not written over.
    else if (element.type === "number" && element === document.activeElement) continue;
    else if (element.tagName !== "BUTTON") { if (element.value !== value) element.value = value; }
    else press(element, element.dataset.to === value);
  }
}

function press(button, is) {
  if (button.getAttribute("aria-pressed") !== String(is)) button.setAttribute("aria-pressed", String(is));
}

/** A scene that has much beside its picture shows one part of it in each frame, and all when nothing follows. */
function actInTurns(scene, action) {
  scene.turn = scene.turn === "map" ? "texts" : "map";
  act(scene, action, scene.turn);
  requestAnimationFrame(() => { if (!scene.pending) act(scene, null); });
}

/** Shows the last of several actions at the next frame. */
function schedule(scene, action) {
  const isFirst = !scene.pending;
  scene.pending = action;
  if (isFirst) requestAnimationFrame(() => {
    const next = scene.pending;
    scene.pending = null;
    if ("turns" in scene.section.dataset) actInTurns(scene, next);
    else act(scene, next);
  });
  scene.moved?.();
}
