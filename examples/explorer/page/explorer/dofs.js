// All numbers of the beams, as fields.

const COLUMNS = { q: "q", dq: "δq", linear_dq: "Δq" };

function fillDofs() {
  const { state } = scenes[0];
  const tables = at("dof-tables");
  const shape = [state.beam, state.bar].map((one) => one.family + one.q.length).join();
  if (tables.shape !== shape) {
    tables.shape = shape;
    tables.replaceChildren(...["beam", "bar"].map((which) => dofTable(which, state[which])));
  }
  for (const input of tables.querySelectorAll("input")) {
    if (input !== document.activeElement) input.value = input.read(scenes[0].state);
  }
}

/** A field of a number; its control has a name like `bar dq 3`. */
function field(label, control, read) {
  const input = element("input");
  input.type = "number";
  input.step = "any";
  input.required = true;
  input.setAttribute("aria-label", label);
  input.read = read;
  input.addEventListener("input", () => {
    if (input.checkValidity()) schedule(scenes[0], { choose: { name: control, value: input.value } });
  });
  return input;
}

function element(tag, ...content) {
  const made = document.createElement(tag);
  made.append(...content);
  return made;
}

function dofTable(which, beam) {
  const words = which === "beam" ? "beam" : "bar beam";
  const box = element("div", element("h2", `The ${words}: ${beam.family}`));
  for (const [name, value] of Object.entries(beam.curve ?? {})) {
    const fields = Array.isArray(value)
      ? value.map((_, i) => field(`${name} ${i + 1} of the ${words}`, `${which} curve ${name} ${i}`, (state) => state[which].curve[name][i]))
      : [field(`${name} of the ${words}`, `${which} curve ${name}`, (state) => state[which].curve[name])];
    box.append(element("p", `${name} `, ...fields));
  }
  const table = element("table");
  const head = table.createTHead().insertRow();
  for (const name of ["dof", ...Object.values(COLUMNS)]) {
    const cell = element("th", name);
    cell.scope = "col";
    head.append(cell);
  }
  const body = table.createTBody();
  beam.q.forEach((_, i) => {
    const row = body.insertRow();
    const name = element("th", i + 1);
    name.scope = "row";
    row.append(name);
    for (const [list, letter] of Object.entries(COLUMNS)) {
      row.insertCell().append(field(`${letter} ${i + 1} of the ${words}`, `${which} ${list} ${i}`, (state) => state[which][list][i]));
    }
  });
  box.append(table);
  return box;
}
