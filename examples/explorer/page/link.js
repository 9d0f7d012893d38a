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
  await compile();
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
