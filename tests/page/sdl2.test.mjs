// SDL2 for the web as scripts/web-deps/build-sdl makes it: trimmed, and whole where that does not do.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { spawnSync } from "node:child_process";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const DEPENDENCIES = path.join(ROOT, "build/deps/web");
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-sdl2 ä "));
after(() => fs.rmSync(scratch, { recursive: true }));

/** Runs a command with what emcc needs; gives what spawnSync gives. */
const run = (...command) =>
  spawnSync("bash", ["-c", 'source "$0"; use_emscripten; "$@"', path.join(ROOT, "scripts/common.sh"), ...command], {
    encoding: "utf8",
  });

/** Writes stand-ins for `missing` as it would be where SDL2's only file is `code`. Gives what spawnSync gives. */
function standIns(missing, code) {
  const [log, source, object] = ["link.log", "caller.c", "caller.o"].map((file) => path.join(scratch, file));
  fs.writeFileSync(log, `wasm-ld: error: ${object}: undefined symbol: ${missing}\n`);
  fs.writeFileSync(source, code);
  const compiled = run("emcc", "-c", source, "-o", object);
  assert.equal(compiled.status, 0, compiled.stderr);
  return run("node", path.join(ROOT, "scripts/web-deps/stand_ins.mjs"), log, object);
}

test("the page's SDL2 is trimmed to less than half of the whole one, which links, too", () => {
  assert.equal(
    fs.readFileSync(path.join(DEPENDENCIES, "sdl-form"), "utf8").trim(),
    "trimmed",
    "see build/deps/trim.log",
  );
  const trimmed = Number(fs.readFileSync(path.join(DEPENDENCIES, "sdl-bytes"), "utf8"));
  const built = run(path.join(ROOT, "scripts/web-deps/build-sdl"), "whole", path.join(DEPENDENCIES, "source"), scratch);
  assert.equal(built.status, 0, built.stderr);
  const whole = Number(built.stdout);
  const libraries = [DEPENDENCIES, scratch].map((folder) => fs.statSync(path.join(folder, "lib/libSDL2.a")).size);
  console.log(`a page's SDL2: ${trimmed} bytes trimmed, ${whole} whole; the libraries: ${libraries.join(" and ")}`);
  assert.ok(trimmed > 0 && trimmed < 0.5 * whole);
  assert.ok(libraries[0] < 0.5 * libraries[1]);
});

test("a function that is left out is stood in for by one of the type that it is called with", () => {
  const { stdout, stderr } = standIns(
    "SDL_Left",
    "double SDL_Left(long long, float, void*); double f(void) { return SDL_Left(1, 2, 0); }",
  );
  assert.match(stdout, /^double SDL_Left\(long long p0, float p1, int p2\) \{.*return 0; \}$/m, stderr);
});

test("what is left out and no function, or not SDL2's, is named, and nothing stands in for it", () => {
  const cases = {
    SDL_table: "extern int SDL_table[]; int f(int i) { return SDL_table[i]; }",
    sleep: "void sleep(int); void f(void) { sleep(1); }",
  };
  for (const [name, code] of Object.entries(cases)) {
    const { status, stdout, stderr } = standIns(name, code);
    assert.deepEqual([status, stdout], [1, ""]);
    assert.match(stderr, new RegExp(`no function of SDL2's: ${name}$`, "m"));
  }
});
