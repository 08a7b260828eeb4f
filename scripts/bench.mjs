// Measures the page in build/web; see scripts/bench.
//
// It asks nothing of the page but what scripts may rely on anyway: the promise tanklab.ready, and
// tanklab.command("turret_left", 1), which keeps the picture changing.
//   first frame   from the start of navigation to the end of the task that made the first draw call
//   frame         time spent in one requestAnimationFrame callback that drew, update included: what the
//                 page's own thread does, not what the renderer makes of it
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { execFileSync } from "node:child_process";
import { fileURLToPath, pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { launch, SITE } from "../tests/page/browsers.mjs";
import { measureOpenGl } from "./bench-opengl.mjs";
import { measureReading } from "./bench-reading.mjs";
import { serve } from "./serve.mjs";

const OUTPUT = fileURLToPath(new URL("../build/bench.json", import.meta.url));
const WARM_UP_FRAMES = 60;
const FRAMES = 180;
const FRAME_TIMEOUT = 60_000;

const SIZES = [
  ["program", (file) => file.endsWith(".wasm")],
  ["script", (file) => file.endsWith(".js") && !file.startsWith("later/")],
  ["script, when needed", (file) => file.startsWith("later/")],
  ["page and style", (file) => /^[^/]*\.(html|css|svg|ico)$/.test(file) && file !== "tanklab.html"],
  ["assets", (file) => file.startsWith("assets/")],
  ["all in one file", (file) => file === "tanklab.html"],
];

const VARIANTS = [
  { name: "Chromium (SwiftShader)", browser: "chromium" },
  { name: "Chromium (Mesa)", browser: "chromium-mesa" },
  { name: "Firefox (Mesa)", browser: "firefox" },
  { name: "Chromium, all in one file", browser: "chromium", file: "tanklab.html" },
];

/** Runs in the page before anything of it: notes when it draws first, and what its frames cost. */
function observe() {
  const seen = { firstFrame: null, frames: [], recording: false };
  window.tanklabBench = seen;

  const prototype = WebGL2RenderingContext.prototype;
  const drawing = ["drawArrays", "drawElements", "drawRangeElements", "drawArraysInstanced", "drawElementsInstanced"];
  const originals = drawing.map((name) => [name, prototype[name]]);
  for (const [name, original] of originals) {
    prototype[name] = function (...values) {
      original.apply(this, values);
      // The frame is over when its task is. From then on nothing of this is in the way.
      for (const [each, function_] of originals) {
        prototype[each] = function_;
      }
      queueMicrotask(() => (seen.firstFrame = performance.now()));
    };
  }

  let lastTime = null;
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) =>
    request((time) => {
      const start = performance.now();
      callback(time);
      if (!seen.recording) {
        return;
      }
      // Callbacks of one frame share its time.
      if (time !== lastTime) {
        seen.frames.push(0);
      }
      lastTime = time;
      seen.frames[seen.frames.length - 1] += performance.now() - start;
    });
}

/** Opens the page in a browser of its own. Gives { firstFrame, frame, slowFrame } in milliseconds. */
async function measure(variant, server) {
  const browser = await launch(variant.browser);
  try {
    const page = await browser.newPage();
    await page.evaluateOnNewDocument(observe);
    await page.goto(variant.file ? pathToFileURL(path.join(SITE, variant.file)).href : server.url);
    await page.waitForFunction("window.tanklab && window.tanklabBench.firstFrame !== null", { timeout: FRAME_TIMEOUT });
    const firstFrame = await page.evaluate(() => window.tanklabBench.firstFrame);
    await page.evaluate(
      "tanklab.ready.then(() => { tanklab.command('turret_left', 1); tanklabBench.recording = true; })",
    );
    await page.waitForFunction(`tanklabBench.frames.length >= ${WARM_UP_FRAMES + FRAMES}`, { timeout: FRAME_TIMEOUT });
    const recorded = await page.evaluate(() => window.tanklabBench.frames);
    const frames = recorded.slice(WARM_UP_FRAMES, WARM_UP_FRAMES + FRAMES);
    return { firstFrame, frame: quantile(frames, 0.5), slowFrame: quantile(frames, 0.95) };
  } finally {
    await browser.close();
  }
}

function quantile(values, fraction) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(fraction * sorted.length))];
}

function filesBelow(folder, prefix = "") {
  return fs.readdirSync(path.join(folder, prefix), { withFileTypes: true }).flatMap((entry) => {
    const file = path.posix.join(prefix, entry.name);
    return entry.isDirectory() ? filesBelow(folder, file) : [file];
  });
}

function measureSizes() {
  const files = filesBelow(SITE);
  return SIZES.map(([name, belongs]) => {
    const contents = files.filter(belongs).map((file) => fs.readFileSync(path.join(SITE, file)));
    const sum = (size) => contents.reduce((total, bytes) => total + size(bytes), 0);
    return { name, bytes: sum((bytes) => bytes.length), gzipped: sum((bytes) => gzipSync(bytes, { level: 9 }).length) };
  });
}

function commit() {
  try {
    return execFileSync("git", ["-C", path.dirname(OUTPUT), "describe", "--always", "--dirty"], {
      encoding: "utf8",
    }).trim();
  } catch {
    return null;
  }
}

function row(name, ...cells) {
  console.log(name.padEnd(34) + cells.map((cell) => String(cell).padStart(16)).join(""));
}

async function main() {
  const { values } = parseArgs({ options: { rounds: { type: "string", default: "5" } } });
  const rounds = Number(values.rounds);
  if (!Number.isInteger(rounds) || rounds < 1) {
    throw new Error(`--rounds wants a whole number from 1 on, not '${values.rounds}'`);
  }

  const sizes = measureSizes();
  const count = (bytes) => bytes.toLocaleString("en");
  row("size", "bytes", "gzipped");
  for (const { name, bytes, gzipped } of sizes) {
    row(name, count(bytes), count(gzipped));
  }
  const sum = (key) =>
    sizes.filter(({ name }) => name === "program" || name === "script").reduce((total, size) => total + size[key], 0);
  row("program and script", count(sum("bytes")), count(sum("gzipped")));

  // The finest clock a page can have needs these headers; nothing else depends on them.
  const server = await serve(SITE, { isolated: true });
  const runs = VARIANTS.map(() => []);
  for (let round = 0; round < rounds; ++round) {
    for (const [index, variant] of VARIANTS.entries()) {
      process.stderr.write(`round ${round + 1} of ${rounds}: ${variant.name}\n`);
      runs[index].push(await measure(variant, server));
    }
  }
  await server.close();

  const times = VARIANTS.map(({ name }, index) => {
    const median = (key) =>
      quantile(
        runs[index].map((run) => run[key]),
        0.5,
      );
    return {
      name,
      first_frame_ms: median("firstFrame"),
      frame_cpu_ms: median("frame"),
      frame_cpu_95_ms: median("slowFrame"),
    };
  });
  console.log();
  row(`time (median of ${rounds})`, "first frame", "frame, CPU", "95 % below");
  for (const { name, ...figures } of times) {
    row(name, ...Object.values(figures).map((value, index) => `${value.toFixed(index === 0 ? 0 : 2)} ms`));
  }
  const say = (text) => process.stderr.write(`${text}\n`);
  const compared = [...(await measureOpenGl(rounds, say)), ...(await measureReading(say))];
  console.log();
  row("compared (medians)", "ours", "", "other", "ratio", "target");
  for (const { name, ours_ms, other, other_ms, ratio, target } of compared) {
    row(
      name,
      `${ours_ms.toFixed(3)} ms`,
      other,
      `${other_ms.toFixed(3)} ms`,
      ratio.toFixed(2),
      target === null ? "" : `at most ${target}`,
    );
  }
  const result = {
    date: new Date().toISOString(),
    commit: commit(),
    cpu: os.cpus()[0]?.model,
    rounds,
    sizes,
    times,
    compared,
  };
  fs.writeFileSync(OUTPUT, `${JSON.stringify(result, null, 2)}\n`);
  console.log("\nwritten to build/bench.json");
}

main().catch((error) => {
  console.error(`bench: ${error.message}`);
  process.exitCode = 2;
});
