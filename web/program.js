// The program as an object of the page: what window.tanklab offers.
import createTanklab from "./tanklab.js";
import { fail, LoadFailure } from "./failure.js";

/** Keeps the newest state and tells those who listen. */
class States {
  #listeners = [];
  newest = null;
  listen(listener) {
    this.#listeners.push(listener);
    if (this.newest) listener(this.newest);
  }
  tell(state) {
    this.newest = state;
    for (const listener of this.#listeners) listener(state);
  }
}

/** Gives the bytes of a file to the program. */
function addFile(module, { name, bytes }) {
  const address = module._malloc(bytes.length);
  module.HEAPU8.set(bytes, address);
  module.ccall("tanklab_add_file", null, ["string", "number", "number"], [name, address, bytes.length]);
  module._free(address);
}

/** Makes the object with the functions of window.tanklab. Bad input throws an Error with the program's sentence. */
function makeProgram(module) {
  const call = (name, ...args) =>
    module.ccall(`tanklab_${name}`, "string", args.map((a) => (typeof a === "number" ? "number" : "string")), args);
  const refuse = (sentence) => {
    if (sentence) throw new Error(sentence);
  };
  return {
    state: () => JSON.parse(call("state")),
    commands: () => JSON.parse(call("commands")),
    command: (name, value = 1) => refuse(call("command", String(name), Number(value))),
    link: () => call("link"),
    openLink: (fragment) => JSON.parse(call("open_link", String(fragment))),
    capture: () => JSON.parse(call("capture")),
    tasks: () => JSON.parse(call("tasks")),
    check: async (id) => {
      const task = JSON.parse(call("check", String(id)));
      if (!task) throw new Error(`There is no task ${id}.`);
      return task;
    },
    /** Draws at once, so that the canvas can be read in the same turn. */
    draw: () => call("draw"),
  };
}

/** Starts the program on the canvas, in the state that the address describes. */
export async function startProgram(canvas, { wasm, assets }, notify) {
  const states = new States();
  let stopped = false;
  const stop = (error, detail) => {
    if (!stopped) fail(error, detail);
    stopped = true;
  };
  const said = [];
  const module = await createTanklab({
    canvas,
    wasmBinary: wasm,
    print: (line) => console.log(line),
    printErr: (line) => {
      said.push(line);
      console.warn(line);
    },
    onAbort: (why) => stop(new Error(String(why)), said.slice(-20).join("\n")),
    onStateChanged: (json) => states.tell(JSON.parse(json)),
    onMessage: (sentence) => notify(sentence),
  });
  window.addEventListener("error", (event) => {
    if (event.error instanceof WebAssembly.RuntimeError) stop(event.error, said.slice(-20).join("\n"));
  });
  for (const file of assets) addFile(module, file);
  const problem = module.ccall("tanklab_start", "string", ["string"], [location.hash.slice(1)]);
  if (problem) {
    throw new LoadFailure(
      "The tank cannot be shown",
      problem,
      "If you changed the files of the tank, correct the one that is named; otherwise load the page again.",
    );
  }
  canvas.addEventListener("webglcontextlost", () => notify("The graphics were taken away; the picture comes back by itself.", "lost"));
  canvas.addEventListener("webglcontextrestored", () => notify(null, "lost"));
  return { program: makeProgram(module), states };
}
