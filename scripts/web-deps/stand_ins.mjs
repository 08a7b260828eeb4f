// Writes, as C, a function for each of SDL2's that a link found missing.
//
//   node stand_ins.mjs LOG OBJECT.o... >stand_ins.c
//
// LOG is what emcc said when it linked: there the missing names stand. The objects import them, each with the type that
// its callers gave it, so that the functions agree with those, whatever they are. One that returns something sets SDL2's
// error and returns 0, which is no pointer; one that does not, does nothing. What is missing and no function, or not
// SDL2's, cannot be written: that is an error.
import fs from "node:fs";

const C_TYPES = { 0x7f: "int", 0x7e: "long long", 0x7d: "float", 0x7c: "double" };
const [TYPES, IMPORTS] = [1, 2]; // sections

/** Gives the types of the functions that a WebAssembly module imports, by name: {parameters, results} in C's words. */
function importedFunctions(bytes) {
  let at = 8; // past the module's header
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      value |= (bytes[at] & 0x7f) << shift;
      if (bytes[at++] < 0x80) {
        return value;
      }
    }
  };
  const list = (each) => Array.from({ length: number() }, each);
  const text = () => {
    const length = number();
    return bytes.toString("utf8", at, (at += length));
  };
  const functionType = () => {
    if (bytes[at++] !== 0x60) {
      throw new Error("there is a type that is no function's");
    }
    return { parameters: list(number), results: list(number) };
  };
  const limits = () => {
    const flags = number();
    for (let i = 0; i <= (flags & 1); ++i) {
      number();
    }
  };
  const rest = {
    1: () => (number(), limits()),
    2: limits,
    3: () => (number(), number()),
    4: () => (number(), number()),
  };
  let types = [];
  const functions = new Map();
  while (at < bytes.length) {
    const section = bytes[at++];
    const end = number() + at;
    if (section === TYPES) {
      types = list(functionType);
    }
    if (section === IMPORTS) {
      list(() => {
        const name = (text(), text());
        const kind = number();
        if (kind === 0) {
          functions.set(name, types[number()]);
        } else {
          rest[kind]();
        }
      });
    }
    at = end;
  }
  return functions;
}

function written(name, { parameters, results }) {
  const types = parameters.map((type) => C_TYPES[type]);
  const result = results.length === 0 ? "void" : C_TYPES[results[0]];
  if (results.length > 1 || [result, ...types].includes(undefined)) {
    throw new Error(`${name} has a type that C has not`);
  }
  const list = types.map((type, i) => `${type} p${i}`).join(", ") || "void";
  const body = result === "void" ? "" : ` SDL_SetError("${name} is not part of the page's SDL2"); return 0; `;
  return `${result} ${name}(${list}) {${body}}`;
}

const [log, ...objects] = process.argv.slice(2);
const functions = new Map(objects.flatMap((object) => [...importedFunctions(fs.readFileSync(object))]));
const found = fs.readFileSync(log, "utf8").matchAll(/undefined symbol: (\w+)/g);
const missing = [...new Set(Array.from(found, ([, name]) => name))].sort();
const strangers = missing.filter((name) => !functions.has(name) || !/^(SDL|Emscripten)_/.test(name));
if (missing.length === 0 || strangers.length > 0) {
  console.error(`stand_ins: missing, and no function of SDL2's: ${strangers.join(", ") || "nothing that emcc names"}`);
  process.exit(1);
}
console.log("int SDL_SetError(const char* format, ...);");
for (const name of missing) {
  console.log(written(name, functions.get(name)));
}
