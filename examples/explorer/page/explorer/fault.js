// Terms are clicked to break them. The kinds of faults that a term can have are digits in its attribute.

const kinds = [...document.querySelectorAll("#kinds [data-kind]")];
const terms = [...document.querySelectorAll("[data-kinds]")];
const DROPPED = "1";
let kind = DROPPED;
let marked = null;

// Beside each value there is a place for the right one, which is filled where the fault changes it.
for (const value of document.querySelectorAll(".formulas [data-value^=term], .formulas [data-value^=result]")) {
  const right = document.createElement("span");
  right.className = "ghost";
  right.dataset.value = `right-${value.dataset.value}`;
  value.after(" ", right);
}

const nameOf = (digit) => kinds.find((one) => one.dataset.kind === digit).textContent;
const plant = (value) => act(scenes[0], { choose: { name: "fault", value } });

for (const term of terms) {
  term.addEventListener("click", () => {
    if (scenes[0].state.fault?.split(" = ")[0] === term.dataset.name) return plant("");
    const known = term.dataset.kinds;
    plant(`${term.dataset.name} = ${nameOf(known.includes(kind) ? kind : known[0])}`);
  });
}
for (const button of kinds) {
  button.addEventListener("click", () => {
    kind = button.dataset.kind;
    plant(`${scenes[0].state.fault.split(" = ")[0]} = ${nameOf(kind)}`);
  });
}

/** Marks the broken term, and offers the other faults that it can have. */
function markFault(fault) {
  if (fault === marked) return;
  marked = fault;
  const [name, planted] = fault?.split(" = ") ?? [];
  for (const term of terms) press(term, term.dataset.name === name);
  const known = terms.find((term) => term.dataset.name === name)?.dataset.kinds ?? "";
  for (const button of kinds) {
    button.hidden = !known.includes(button.dataset.kind);
    press(button, button.textContent === planted);
  }
}
