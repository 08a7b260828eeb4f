// Measures legacygl beside other ways to draw the same, for scripts/bench; see tests/bench.
//
// Every figure is a ratio of medians: the two sides take turns, a few frames at a time in a page, run by run natively.
//   in Chromium   CPU time that the kernel counts for the page's main thread, a frame: the program, the library
//                 and the browser's WebGL up to where another process draws, whose time is not in it, nor is
//                 waiting for it
//   natively      wall time of a frame, its drawing by Mesa's llvmpipe included
//   compile       wall time from glNewList to glEndList, with what the first call takes longer than a later one
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { launch } from "../tests/page/browsers.mjs";
import { serve } from "./serve.mjs";

const PAGE = fileURLToPath(new URL("../build/web-build/tests/bench/page", import.meta.url));
const NATIVE = fileURLToPath(new URL("../build/native/tests/bench", import.meta.url));
const FRAMES = 100;
const BATCH = 10;
const BATCHES = 9;
const WARM_UP_BATCHES = 4;
const PAGE_TIMEOUT = 120_000;
const BROWSERS = { SwiftShader: "chromium", Mesa: "chromium-mesa" };

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Stops where two programs that are compared draw something else: then they do not do the same. */
function expectSame(what, one, other) {
  let off = 0;
  for (let i = 0; i < one.length; i += 4) {
    if ([0, 1, 2].some((channel) => Math.abs(one[i + channel] - other[i + channel]) > 32)) {
      ++off;
    }
  }
  if (off > 0.01 * (one.length / 4)) {
    throw new Error(`${what}: ${off} pixels of what is compared differ`);
  }
  if (one.every((value, i) => value === one[i % 4])) {
    throw new Error(`${what}: the picture is empty`);
  }
}

/** Gives a function that tells the CPU time of the page's main thread so far, in milliseconds. */
async function threadClock(browser, page) {
  const session = await browser.target().createCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await page.evaluate(() => {
    const end = performance.now() + 200;
    while (performance.now() < end) {
      // so that the thread has been the busiest
    }
  });
  const after = (await session.send("SystemInfo.getProcessInfo")).processInfo;
  const used = (process) => process.cpuTime - (processInfo.find(({ id }) => id === process.id)?.cpuTime ?? 0);
  const busiest = after
    .filter(({ type }) => type === "renderer")
    .reduce((one, other) => (used(one) > used(other) ? one : other));
  return () => Number(fs.readFileSync(`/proc/${busiest.id}/task/${busiest.id}/schedstat`, "utf8").split(" ")[0]) / 1e6;
}

/** Gives { name: milliseconds of a frame in each batch }; the programs take turns. */
async function measureBatches(page, clock, names) {
  const batch = async (name, draws) => {
    const before = clock();
    await page.evaluate((which, frames, wanted) => window.run(which, frames, wanted), name, BATCH, draws);
    return clock() - before;
  };
  const times = Object.fromEntries(names.map((name) => [name, []]));
  for (let i = 0; i < WARM_UP_BATCHES + BATCHES; ++i) {
    for (const name of names) {
      const waiting = await batch(name, false);
      const time = (await batch(name, true)) - waiting;
      if (i >= WARM_UP_BATCHES) {
        times[name].push(time / BATCH);
      }
    }
  }
  return times;
}

async function measurePage(browserName) {
  const server = await serve(PAGE, { isolated: true });
  const browser = await launch(browserName);
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(PAGE_TIMEOUT);
    await page.goto(server.url);
    await page.waitForFunction("window.pictures");
    const pictures = await page.evaluate(() => window.pictures());
    expectSame("immediate mode", pictures.immediate, pictures.emulation);
    expectSame("display lists", pictures.lists, pictures.by_hand);
    return await measureBatches(page, await threadClock(browser, page), Object.keys(pictures));
  } finally {
    await browser.close();
    await server.close();
  }
}

// Whether freed memory at the heap's end goes back to the kernel after each frame, to be faulted in for the next, is
// the luck of what lies there. It made either side up to a quarter slower; here none gives any back.
const KEEP_MEMORY = {
  ...process.env,
  GLIBC_TUNABLES: "glibc.malloc.trim_threshold=268435456:glibc.malloc.mmap_threshold=268435456",
};

/** Runs a native program. Gives the numbers it prints. */
function runNative(renderer, ...given) {
  const text = execFileSync(path.join(NATIVE, `opengl_bench_${renderer}`), given, {
    encoding: "utf8",
    env: KEEP_MEMORY,
  });
  return text.trim().split("\n").map(Number);
}

function comparePictures(program) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-bench-"));
  try {
    const [one, other] = ["emulated", "reference"].map((renderer) => {
      execFileSync(path.join(NATIVE, `opengl_bench_${renderer}`), ["picture", program, path.join(folder, renderer)]);
      return fs.readFileSync(path.join(folder, renderer));
    });
    expectSame(program, one, other);
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

/** Gives rows { name, ours_ms, other, other_ms, ratio, target }; target is null where none is set. */
export async function measureOpenGl(rounds, say) {
  const rows = [];
  const add = (name, ours, other, others, target) =>
    rows.push({
      name,
      ours_ms: median(ours),
      other,
      other_ms: median(others),
      ratio: median(ours) / median(others),
      target,
    });

  for (const [renderer, browser] of Object.entries(BROWSERS)) {
    const times = { immediate: [], emulation: [], lists: [], by_hand: [] };
    for (let round = 0; round < rounds; ++round) {
      say(`OpenGL, round ${round + 1} of ${rounds}: Chromium (${renderer})`);
      for (const [name, values] of Object.entries(await measurePage(browser))) {
        times[name].push(median(values));
      }
    }
    add(`immediate, Chromium (${renderer})`, times.immediate, "Emscripten", times.emulation, 0.1);
    add(`lists, Chromium (${renderer})`, times.lists, "WebGL by hand", times.by_hand, 1.25);
  }

  for (const program of ["immediate", "lists"]) {
    comparePictures(program);
    const times = { emulated: [], reference: [] };
    for (let round = 0; round < 2 * rounds; ++round) {
      say(`OpenGL, round ${round + 1} of ${2 * rounds}: ${program}, native`);
      for (const renderer of round % 2 ? ["emulated", "reference"] : ["reference", "emulated"]) {
        times[renderer].push(median(runNative(renderer, program, String(FRAMES))));
      }
    }
    add(`${program}, native`, times.emulated, "Mesa", times.reference, 1);
  }

  const lists = { emulated: [], reference: [], copy: [] };
  for (let round = 0; round < rounds; ++round) {
    say(`OpenGL, round ${round + 1} of ${rounds}: compiling`);
    for (const renderer of Object.keys(lists).slice(0, 2)) {
      const numbers = runNative(renderer, "compile", "5");
      lists[renderer].push(median(numbers.filter((_, i) => i % 2 === 0)));
      if (renderer === "emulated") {
        lists.copy.push(median(numbers.filter((_, i) => i % 2 === 1)));
      }
    }
  }
  add("compile 100,000 triangles", lists.emulated, "Mesa", lists.reference, null);
  add("compile 100,000 triangles", lists.emulated, "copy and upload", lists.copy, null);
  return rows;
}
