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
