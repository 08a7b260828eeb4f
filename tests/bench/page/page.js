// What scripts/bench asks of this page: run(name, frames) and pictures().
import { webglLists } from "./webgl_lists.js";

const canvasOf = (id) => /** @type {HTMLCanvasElement} */ (document.getElementById(id));

const LISTS = 1000;
const LIST_FLOATS = 36 * 6;

async function legacygl(id, which) {
  const module = await createLegacygl({ canvas: canvasOf(id) });
  if (!module.ccall("bench_open", "number", ["string", "number"], [`#${id}`, which])) {
    throw new Error(`${id} cannot open`);
  }
  return { module, frame: module._bench_frame, gl: canvasOf(id).getContext("webgl2") };
}

async function emulation(id) {
  const module = await createEmscripten({ canvas: canvasOf(id) });
  if (!module.ccall("bench_open", "number", ["string", "number"], [`#${id}`, 0])) {
    throw new Error(`${id} cannot open`);
  }
  return { frame: module._bench_frame, gl: canvasOf(id).getContext("webgl") };
}

function byHand(id, { module }) {
  const numbers = (at, count) => module.HEAPF32.slice(at / 4, at / 4 + count);
  const meshes = Array.from({ length: LISTS }, (_, i) => numbers(module._bench_list_vertices(i), LIST_FLOATS));
  const gl = canvasOf(id).getContext("webgl2", { alpha: false, antialias: false });
  return { frame: webglLists(gl, meshes, numbers(module._bench_list_matrices(), LISTS * 16)), gl };
}

const ready = (async () => {
  const immediate = await legacygl("immediate", 0);
  const lists = await legacygl("lists", 1);
  return { immediate, emulation: await emulation("emulation"), lists, by_hand: byHand("by_hand", lists) };
})();

function readBack({ gl }) {
  const pixels = new Uint8Array(256 * 256 * 4);
  gl.readPixels(0, 0, 256, 256, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

let number = 0;

/** Draws some frames of a program, or none in as many turns. After each turn the process that draws is let finish,
    so that a full queue never makes the next frame wait. */
window.run = async (name, frames, draws) => {
  const { frame, gl } = (await ready)[name];
  const pixel = new Uint8Array(4);
  for (let i = 0; i < frames; ++i) {
    if (draws) {
      frame(++number);
    }
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  }
};

/** Gives { name: bytes of a frame's picture }: what is measured has to draw the same. */
window.pictures = async () => {
  /** @type {Record<string, number[]>} */
  const out = {};
  for (const [name, program] of Object.entries(await ready)) {
    program.frame(1);
    out[name] = Array.from(readBack(program));
  }
  return out;
};
