// The address holds the whole state; a case can be copied out, opened and dropped. Then the start.

function remember() {
  const { equations, ...kept } = scenes[0].state;
  const text = btoa(String.fromCharCode(...new TextEncoder().encode(JSON.stringify(kept))));
  const fragment = "#" + text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  if (fragment !== location.hash) history.replaceState(null, "", fragment);
}

/** Takes the state of the fragment over, if there is one that can be drawn. */
function recall() {
  // The skip link has a fragment too.
  if (location.hash.length < 2 || at(location.hash.slice(1))) return;
  const before = scenes[0].state;
  try {
    const text = location.hash.slice(1).replaceAll("-", "+").replaceAll("_", "/");
    scenes[0].state = JSON.parse(new TextDecoder().decode(bytesOf(text)));
  } catch {
    tell("The link holds no state of this page: the standard case is shown.");
    return;
  }
  if (act(scenes[0], null)) return;
  scenes[0].state = before;
  tell(`The link holds a state that cannot be drawn: ${at("message").textContent}`);
}
addEventListener("hashchange", recall);

function tell(words) {
  at("message").textContent = words;
  at("message").hidden = false;
}

const COPIES = { "copy-link": () => location.href, "copy-case": () => answer.case, "copy-vectors": () => answer.vectors, "copy-test": () => answer.test, "copy-command": () => answer.command };
for (const [id, text] of Object.entries(COPIES)) {
  at(id).addEventListener("click", async () => {
    atRest();
    at("copied").textContent = (await written(text())) ? "copied" : "the browser does not allow it: select the text below";
  });
}

async function written(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // Files are not trusted with the clipboard by every browser.
    const area = element("textarea");
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

async function open(file) {
  if (file) act(scenes[0], { choose: { name: "case", value: await file.text() } });
}
at("open").addEventListener("click", () => at("file").click());
at("file").addEventListener("change", () => open(at("file").files[0]));
addEventListener("dragover", (event) => event.preventDefault());
addEventListener("drop", (event) => {
  event.preventDefault();
  open(event.dataTransfer.files[0]);
});

start().then((ready) => {
  if (!ready) return;
  scenes[0].after = after;
  recall();
  atRest();
  markFault(scenes[0].state.fault);
  new ResizeObserver(sizeGrips).observe(svg);
  document.documentElement.dataset.ready = "true";
}).catch(told);
