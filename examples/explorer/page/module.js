// The module: the library as WebAssembly. A request goes in, its answer comes out, both as JSON.

const at = (id) => document.getElementById(id);
const bytesOf = (base64) => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
let module = null;
let exports = null;
const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** Compiles the module that the page contains. */
async function compile() {
  const bytes = bytesOf(at("module").textContent.trim());
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  module = await WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

/** The answer of one of the module's functions. */
function call(name, request) {
  try {
    exports ??= new WebAssembly.Instance(module, {}).exports;
    const bytes = encoder.encode(JSON.stringify(request));
    const start = exports.reserve(bytes.length);
    new Uint8Array(exports.memory.buffer, start, bytes.length).set(bytes);
    const length = exports[name]();
    return JSON.parse(decoder.decode(new Uint8Array(exports.memory.buffer, exports.answer_at(), length)));
  } catch (error) {
    exports = null; // A module that stopped is not asked again; the next request starts it anew.
    return { error: `the computation stopped: ${error}` };
  }
}
