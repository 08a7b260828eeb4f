// What scripts/bench asks of this page: window.measure(frames) and window.pictures().
//
// Time is that of this thread in a function that draws a frame: what the program, the library and the browser's
// WebGL do before the commands lie in the queue of the process that draws. That process is let finish after
// each frame, outside of the time, so that a full queue never makes the next frame wait for it.
import { webglLists } from "./webgl_lists.js";

const LISTS = 1000, LIST_FLOATS = 36 * 6;

async function legacygl(id, which) {
  const module = await createLegacygl({ canvas: document.getElementById(id) });
  if (!module.ccall("bench_open", "number", ["string", "number"], [`#${id}`, which])) throw new Error(`${id} cannot open`);
  return { module, frame: module._bench_frame, gl: document.getElementById(id).getContext("webgl2") };
}

async function emulation(id) {
  const module = await createEmscripten({ canvas: document.getElementById(id) });
  if (!module.ccall("bench_open", "number", ["string", "number"], [`#${id}`, 0])) throw new Error(`${id} cannot open`);
  return { frame: module._bench_frame, gl: document.getElementById(id).getContext("webgl") };
}

function byHand(id, { module }) {
  const numbers = (at, count) => module.HEAPF32.slice(at / 4, at / 4 + count);
  const meshes = Array.from({ length: LISTS }, (_, i) => numbers(module._bench_list_vertices(i), LIST_FLOATS));
  const gl = document.getElementById(id).getContext("webgl2", { alpha: false, antialias: false });
  return { frame: webglLists(gl, meshes, numbers(module._bench_list_matrices(), LISTS * 16)), gl };
}

const ready = (async () => {
  const immediate = await legacygl("immediate", 0);
  const lists = await legacygl("lists", 1);
  return { immediate, emulation: await emulation("emulation"), lists, by_hand: byHand("by_hand", lists) };
})();

function readBack({ gl }, pixels) {
  gl.readPixels(0, 0, pixels.length > 4 ? 256 : 1, pixels.length > 4 ? 256 : 1, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/** Gives { name: milliseconds of each frame }, the programs taken in turn. */
window.measure = async (frames, warmUp) => {
  const programs = Object.entries(await ready);
  const times = Object.fromEntries(programs.map(([name]) => [name, []]));
  const pixel = new Uint8Array(4);
  for (let number = 0; number < warmUp + frames; ++number) {
    for (const [name, program] of programs) {
      await new Promise(requestAnimationFrame);
      const start = performance.now();
      program.frame(number);
      const time = performance.now() - start;
      if (number >= warmUp) times[name].push(time);
      readBack(program, pixel);
    }
  }
  return times;
};

/** Gives { name: bytes of a frame's picture }: what is measured has to draw the same. */
window.pictures = async () => {
  const out = {};
  for (const [name, program] of Object.entries(await ready)) {
    program.frame(1);
    out[name] = Array.from(readBack(program, new Uint8Array(256 * 256 * 4)));
  }
  return out;
};
