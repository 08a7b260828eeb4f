// legacygl defines every OpenGL name that the page's program uses. Emscripten has functions of its own
// under 64 of those names, and a link takes them without a word where we lack one: so none is imported. It has an SDL 1
// as well, under many of SDL2's names.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const PROGRAM =
  process.env.TANKLAB_NAMED_IMPORTS ??
  fileURLToPath(new URL("../../build/web-build/wasm/tanklab_named_imports.wasm", import.meta.url));

/** Returns the names of OpenGL, GLU and SDL among what a WebAssembly module imports. */
function importedNames(bytes) {
  const names = WebAssembly.Module.imports(new WebAssembly.Module(bytes)).map(({ name }) => name);
  return names.filter((name) => /^(glu?[A-Z]|SDL_)/.test(name));
}

/** Returns a WebAssembly module that imports functions of these names from "env", and does nothing else. */
function moduleImporting(...names) {
  const text = (value) => [value.length, ...Buffer.from(value)];
  const section = (id, content) => [id, content.length, ...content];
  const imports = names.flatMap((name) => [...text("env"), ...text(name), 0, 0]);
  const header = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
  return Uint8Array.from([...header, ...section(1, [1, 0x60, 0, 0]), ...section(2, [names.length, ...imports])]);
}

test("the check finds names of OpenGL, GLU and SDL, and no other", () => {
  assert.deepEqual(
    importedNames(moduleImporting("glBegin", "emscripten_glClear", "gluSphere", "SDL_Init", "global", "gl")),
    ["glBegin", "gluSphere", "SDL_Init"],
  );
});

test("the program imports no name of OpenGL or SDL, and its import names are whole", () => {
  const bytes = fs.readFileSync(PROGRAM);
  const names = WebAssembly.Module.imports(new WebAssembly.Module(bytes)).map(({ name }) => name);
  assert.ok(
    names.includes("emscripten_glDrawArrays") || names.includes("emscripten_glDrawElements"),
    `shortened? ${names.join(" ")}`,
  );
  assert.deepEqual(importedNames(bytes), []);
});
