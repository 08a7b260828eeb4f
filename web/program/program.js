// The program as an object of the page, and what window.tanklab offers of it.
import createTanklab from "tanklab";
import { dismiss, notify } from "../base/notices.js";
import { throttled } from "../base/throttle.js";
import { LoadFailure, showFailure } from "./failure.js";

const LINES_KEPT = 40; // of what the program printed, for a failure's details
const RETURNS = { draw: "void", forget_files: "void", draw_calls: "number" }; // the other functions return texts

/** Tells whether an error came out of the WebAssembly module: a trap, an abort, a stack that ran over. */
const isFromModule = (error) => error instanceof WebAssembly.RuntimeError || /wasm/i.test(error?.stack ?? "");

/** Throws a sentence of the program as an error; an empty one means that all went well. */
function refuse(sentence) {
  if (sentence) {
    throw new Error(sentence);
  }
}

export class Program {
  /** @type {import("tanklab").TanklabModule | null} */
  #module = null;
  #stopped = false;
  #printed = [];
  #listeners = [];

  /** The newest status that the program told, or null: what something shows at all times (status_json in
      src/app/report/state_json.h). All else is asked for by who shows it. It stays readable when the program has
      stopped. */
  newest = null;
  #link = "";

  /** Compiles the program and gives it its files: [{name, bytes}]. */
  async open(canvas, wasm, files) {
    addEventListener("error", (event) => isFromModule(event.error) && this.#stop(event.error));
    try {
      this.#module = await createTanklab({
        canvas,
        wasmBinary: wasm,
        print: (line) => this.#keep(line, "log"),
        printErr: (line) => this.#keep(line, "warn"),
        onAbort: (why) => this.#stop(new Error(String(why))),
        onStatus: (json) => this.#tell(JSON.parse(json)),
        onMessage: (sentence) => notify(sentence, { topic: "link" }),
      });
    } catch (error) {
      throw new LoadFailure(
        "The program could not be started",
        `The browser refused tanklab.wasm: ${String(error?.message ?? error).replace(/\.?$/, ".")}`,
        "Reload the page. If that does not help, use a current Firefox, Chrome, Edge or Safari.",
      );
    }
    for (const file of files) {
      this.#add(file);
    }
    canvas.addEventListener("webglcontextlost", () =>
      notify(
        "The browser took the graphics away. The picture comes back by itself; if it does not, reload the page, whose address keeps what you see.",
        { topic: "graphics" },
      ),
    );
    canvas.addEventListener("webglcontextrestored", () => dismiss("graphics"));
  }

  /** Shows the state of a fragment. Throws a LoadFailure when the files or the browser do not allow it. */
  start(fragment) {
    const sentence = this.#call("start", fragment);
    if (sentence) {
      throw new LoadFailure(
        "The tank cannot be shown",
        sentence,
        "If you changed the tank’s files, correct the one that is named and reload the page.",
      );
    }
  }

  /** Calls listener(status) now, if there is one, and after every change, or at most once in `every` ms. */
  listen(listener, every = 0) {
    const heard = every ? throttled(listener, every) : listener;
    this.#listeners.push(heard);
    if (this.newest) {
      heard(this.newest);
    }
  }

  state = () => JSON.parse(this.#call("state"));
  commands = () => JSON.parse(this.#call("commands"));
  command = (name, value = 1) => refuse(this.#call("command", String(name), Number(value)));
  fields = () => JSON.parse(this.#call("fields"));
  report = () => JSON.parse(this.#call("report"));
  evidence = () => JSON.parse(this.#call("evidence"));
  capture = () => JSON.parse(this.#call("capture"));
  assetManifest = () => JSON.parse(this.#call("asset_manifest"));
  hits = () => JSON.parse(this.#call("hits"));
  drawCalls = () => this.#call("draw_calls");
  tasks = () => this.#tasksAndFigures().filter((row) => row.kind === "task");
  figures = () => this.#tasksAndFigures().filter((row) => row.kind === "figure");
  draw = () => void this.#call("draw");

  /** Returns the fragment that describes the state, without "#"; of a program that has stopped, the last one asked for. */
  link = () => {
    if (!this.#stopped) {
      this.#link = this.#call("link");
    }
    return this.#link;
  };

  /** Shows a tank made of files: [{name, bytes}]. Returns {error, notes}: "" or a sentence that says why the
      tank stays as it was, and sentences about the new one. */
  bringTank(files) {
    try {
      for (const file of files) {
        this.#add(file);
      }
    } catch (error) {
      this.#call("forget_files");
      return { error: error.message, notes: [] };
    }
    return JSON.parse(this.#call("bring_tank"));
  }

  /** Opens a fragment and returns what was wrong with it, a sentence each. */
  openLink = (fragment) => JSON.parse(this.#call("open_link", String(fragment)));

  /** Runs the check of a task. Returns the task with `passed` and `evidence`; of a figure passed is null. */
  check = async (id) => {
    const task = JSON.parse(this.#call("check", String(id)));
    if (!task) {
      throw new Error(`There is no task or figure '${id}'.`);
    }
    return task;
  };

  /** Returns what stands in window.tanklab. Everything throws an Error with a sentence where it cannot be done. */
  forScripts() {
    const { state, commands, command, link, openLink, capture, hits, tasks, figures, check, draw } = this;
    return { state, commands, command, link, openLink, capture, hits, tasks, figures, check, draw };
  }

  #tasksAndFigures() {
    return JSON.parse(this.#call("tasks"));
  }

  #call(name, ...values) {
    if (this.#stopped) {
      throw new Error("The program has stopped; reload the page.");
    }
    if (!this.#module) {
      throw new Error("The program is still being loaded; wait for tanklab.ready.");
    }
    const types = values.map((value) => (typeof value === "number" ? "number" : "string"));
    try {
      return this.#module.ccall(`tanklab_${name}`, RETURNS[name] ?? "string", types, values);
    } catch (error) {
      if (isFromModule(error)) {
        this.#stop(error);
      }
      throw error;
    }
  }

  #add({ name, bytes }) {
    const module = /** @type {import("tanklab").TanklabModule} */ (this.#module);
    const address = module._malloc(Math.max(1, bytes.length));
    if (!address) {
      throw new LoadFailure(
        "The tank cannot be shown",
        `The browser has no memory left for ${name}.`,
        "Close other tabs and reload the page.",
      );
    }
    module.HEAPU8.set(bytes, address);
    module.ccall("tanklab_add_file", null, ["string", "number", "number"], [name, address, bytes.length]);
    module._free(address);
  }

  #keep(line, level) {
    console[level](line);
    this.#printed.push(line);
    if (this.#printed.length > LINES_KEPT) {
      this.#printed.shift();
    }
  }

  #tell(status) {
    this.newest = status;
    for (const listener of this.#listeners) {
      listener(status);
    }
  }

  #stop(error) {
    if (this.#stopped) {
      return;
    }
    this.#stopped = true;
    showFailure(error, this.#printed);
  }
}
