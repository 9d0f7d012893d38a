"use strict";
// State in, pieces of the page out: all numbers come from the module. This script carries input to the state.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const at = (id) => document.getElementById(id);
  const svg = at("picture");
  const bytesOf = (base64) => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const copy = (value) => JSON.parse(JSON.stringify(value));
  let state = copy(data.standard);
  let answer = null;
  let module = null;
  let exports = null;

  // The module.

  function ask(request) {
    try {
      exports ??= new WebAssembly.Instance(module, {}).exports;
      const bytes = new TextEncoder().encode(JSON.stringify(request));
      const start = exports.reserve(bytes.length);
      new Uint8Array(exports.memory.buffer, start, bytes.length).set(bytes);
      const length = exports.respond();
      return JSON.parse(new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.answer_at(), length)));
    } catch (error) {
      exports = null; // A module that stopped is not asked again; the next request starts it anew.
      return { error: `the computation stopped: ${error}` };
    }
  }

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
    }
    list.forEach((handle, i) => {
      handles[i].setAttribute("transform", `translate(${handle.at[0].toFixed(1)} ${handle.at[1].toFixed(1)})`);
      handles[i].setAttribute("aria-label", `${handle.name}: ${handle.value.map((x) => x.toFixed(3)).join(", ")}`);
    });
  }

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

  // Controls.

  const choices = { "family-beam": "beam", "family-bar": "bar" };

  function showControls() {
    for (const [id, which] of Object.entries(choices)) at(id).value = state[which].family;
    for (const id of ["radius", "radius_bar"]) if (document.activeElement !== at(id)) at(id).value = state.contact[id];
    for (const id of ["azimuth", "elevation", "scale"]) at(id).value = state.view[id];
    at("step").value = state.step;
    at("step-value").textContent = state.step.toFixed(2);
    for (const radio of document.getElementsByName("dragged")) radio.checked = radio.value === state.dragged;
    for (const radio of document.getElementsByName("along")) radio.checked = (radio.value === "linear_dq") === state.along_linear;
    const [term, kind] = state.fault ? state.fault.split(" = ") : ["", ""];
    at("fault-term").value = term;
    showKinds(kind);
  }

  function showKinds(kind) {
    const kinds = data.faults[at("fault-term").value] ?? [];
    at("fault-kind").replaceChildren(...kinds.map((name) => new Option(name, name)));
    at("fault-kind").disabled = kinds.length === 0;
    if (kinds.includes(kind)) at("fault-kind").value = kind;
  }

  function setFault() {
    const term = at("fault-term").value;
    state.fault = term ? `${term} = ${at("fault-kind").value}` : null;
    redraw();
  }

  for (const [id, which] of Object.entries(choices)) {
    at(id).addEventListener("change", () => {
      state[which] = copy(data.presets[which][at(id).value]);
      state.minimum = 0;
      redraw();
    });
  }
  for (const id of ["radius", "radius_bar"]) {
    at(id).addEventListener("input", () => {
      if (!at(id).checkValidity()) return;
      state.contact[id] = at(id).valueAsNumber;
      redraw();
    });
  }
  for (const id of ["azimuth", "elevation", "scale"]) {
    at(id).addEventListener("input", () => { state.view[id] = at(id).valueAsNumber; redraw(); });
  }
  at("step").addEventListener("input", () => {
    state.step = at("step").valueAsNumber;
    at("step-value").textContent = state.step.toFixed(2);
    redraw();
  });
  document.addEventListener("change", (event) => {
    if (event.target.name === "dragged") state.dragged = event.target.value;
    else if (event.target.name === "along") state.along_linear = event.target.value === "linear_dq";
    else return;
    redraw();
  });
  at("controls").addEventListener("submit", (event) => event.preventDefault());
  at("fault-term").addEventListener("change", () => { showKinds(at("fault-kind").value); setFault(); });
  at("fault-kind").addEventListener("change", setFault);
  at("situations").addEventListener("click", (event) => {
    const situation = data.situations[event.target.dataset?.situation];
    if (!situation) return;
    state = { ...state, ...copy(situation), minimum: 0 };
    showControls();
    redraw();
  });
  at("lessons").addEventListener("click", (event) => {
    const fault = event.target.dataset?.fault;
    if (fault === undefined) return;
    state.fault = fault || null;
    showControls();
    redraw();
  });
  at("points").addEventListener("click", (event) => {
    const minimum = event.target.dataset?.minimum;
    if (minimum === undefined) return;
    state.minimum = Number(minimum);
    redraw();
  });

  // All numbers of the beams.

  const COLUMNS = { q: "q", dq: "δq", linear_dq: "Δq" };

  function fillDofs() {
    const tables = at("dof-tables");
    const shape = [state.beam, state.bar].map((one) => one.family + one.q.length).join();
    if (tables.shape !== shape) {
      tables.shape = shape;
      tables.replaceChildren(...["beam", "bar"].map(dofTable));
    }
    for (const input of tables.querySelectorAll("input")) {
      if (input !== document.activeElement) input.value = input.read();
    }
  }

  function field(label, read, write) {
    const input = document.createElement("input");
    input.type = "number";
    input.step = "any";
    input.required = true;
    input.setAttribute("aria-label", label);
    input.read = read;
    input.addEventListener("input", () => {
      if (!input.checkValidity()) return;
      write(input.valueAsNumber);
      redraw();
    });
    return input;
  }

  function dofTable(which) {
    const words = which === "beam" ? "beam" : "bar beam";
    const box = document.createElement("div");
    box.className = "wide";
    const heading = document.createElement("h3");
    heading.textContent = `The ${words}: ${state[which].family}`;
    box.append(heading);
    for (const [name, value] of Object.entries(state[which].curve ?? {})) {
      const row = document.createElement("p");
      row.append(`${name} `);
      const fields = Array.isArray(value)
        ? value.map((_, i) => field(`${name} ${i + 1} of the ${words}`, () => state[which].curve[name][i], (x) => { state[which].curve[name][i] = x; }))
        : [field(`${name} of the ${words}`, () => state[which].curve[name], (x) => { state[which].curve[name] = x; })];
      fields.forEach((one) => row.append(one, " "));
      box.append(row);
    }
    const table = document.createElement("table");
    const head = table.createTHead().insertRow();
    for (const name of ["dof", ...Object.values(COLUMNS)]) {
      const cell = document.createElement("th");
      cell.scope = "col";
      cell.textContent = name;
      head.append(cell);
    }
    const body = table.createTBody();
    state[which].q.forEach((_, i) => {
      const row = body.insertRow();
      const name = document.createElement("th");
      name.scope = "row";
      name.textContent = i + 1;
      row.append(name);
      for (const [list, letter] of Object.entries(COLUMNS)) {
        row.insertCell().append(field(`${letter} ${i + 1} of the ${words}`, () => state[which][list][i], (x) => { state[which][list][i] = x; }));
      }
    });
    box.append(table);
    return box;
  }
  at("dofs").addEventListener("toggle", () => { if (at("dofs").open) fillDofs(); });

  // The link: the whole state in the fragment.

  function remember() {
    const { equations, ...kept } = state;
    const text = btoa(String.fromCharCode(...new TextEncoder().encode(JSON.stringify(kept))));
    const fragment = "#" + text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
    if (fragment !== location.hash) history.replaceState(null, "", fragment);
  }

  /** Takes the state of the fragment over, if there is one that can be drawn. */
  function recall() {
    // The skip link has a fragment too.
    if (location.hash.length < 2 || at(location.hash.slice(1))) return;
    const before = state;
    try {
      const text = location.hash.slice(1).replaceAll("-", "+").replaceAll("_", "/");
      state = { ...copy(data.standard), ...JSON.parse(new TextDecoder().decode(bytesOf(text))) };
    } catch {
      at("message").textContent = "The link holds no state of this page: the standard case is shown.";
      at("message").hidden = false;
      return;
    }
    if (draw(true)) return;
    const { error } = ask({ ...state, equations: false });
    state = before;
    draw(true);
    at("message").textContent = `The link holds a state that cannot be drawn: ${error}`;
    at("message").hidden = false;
  }
  addEventListener("hashchange", () => { recall(); showControls(); });

  const COPIES = { "copy-link": () => location.href, "copy-test": () => answer.test, "copy-command": () => answer.command };
  for (const [id, text] of Object.entries(COPIES)) {
    at(id).addEventListener("click", async () => {
      remember();
      at("copied").textContent = (await written(text())) ? "copied" : "the browser does not allow it: select the text below";
    });
  }

  async function written(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      // Files are not trusted with the clipboard by every browser.
      const area = document.createElement("textarea");
      area.value = text;
      document.body.append(area);
      area.select();
      const done = document.execCommand("copy");
      area.remove();
      return done;
    }
  }

  // The start.

  async function start() {
    const bytes = bytesOf(at("module").textContent.trim());
    const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    module = await WebAssembly.compile(await new Response(unpacked).arrayBuffer());
    if (!draw(true)) return;
    recall();
    showControls();
    for (const element of document.querySelectorAll("fieldset, button")) element.disabled = false;
    document.documentElement.dataset.ready = "true";
  }
  start().catch((error) => {
    at("message").textContent = `The module does not start: ${error}`;
    at("message").hidden = false;
  });
})();
