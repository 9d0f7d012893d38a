// What takes long is computed when nothing has moved for a while. A folded table is filled when it is opened.

const PIECES = ["words", "points", "checks", "prediction", "plot", "numbers", "lesson"];
const TEXTS = ["test", "command", "case"];
let answer = null;
/** The time without a frame after which the tables are computed, in milliseconds. */
const REST = 200;
let drawnAt = 0;
let rest = 0;

/** Follows a frame. */
function after(frame) {
  markFault(frame.state.fault);
  drawnAt = performance.now();
  rest ||= setTimeout(restOrWait, REST);
}

function restOrWait() {
  const wait = REST - (performance.now() - drawnAt);
  rest = wait > 5 ? setTimeout(restOrWait, wait) : 0;
  if (!rest) atRest();
}

function atRest() {
  remember();
  const found = call("respond", { ...scenes[0].state, equations: at("paper").open });
  if (found.error) return;
  answer = found;
  fill();
}

const isFolded = (element) => element.closest("details")?.open === false;

function fill() {
  for (const id of PIECES) {
    const element = at(id);
    if (isFolded(element) || element.shown === answer[id]) continue;
    element.innerHTML = answer[id];
    element.shown = answer[id];
  }
  for (const id of TEXTS) if (!isFolded(at(id))) at(id).textContent = answer[id];
  if (answer.equations) fillEquations(answer.equations);
  if (at("dofs").open) fillDofs();
}

function fillEquations(equations) {
  const known = new Map(equations.map((equation) => [equation.number, equation]));
  for (const row of document.querySelectorAll("tr[data-equation]")) {
    const equation = known.get(Number(row.dataset.equation));
    for (const cell of row.querySelectorAll("td[data-cell]")) cell.textContent = equation?.[cell.dataset.cell] ?? "";
  }
}

for (const details of document.querySelectorAll(".tables details")) {
  details.addEventListener("toggle", () => {
    if (!details.open || !scenes[0]?.state) return;
    if (details.id === "paper" || !answer) atRest();
    else fill();
  });
}
at("points").addEventListener("click", (event) => {
  const { minimum } = event.target.dataset;
  if (minimum !== undefined) act(scenes[0], { choose: { name: "minimum", value: minimum } });
});
