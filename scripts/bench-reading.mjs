// Measures how long the tank's ten OBJ files take to become display lists in a page, beside three.js's OBJLoader
// on the same bytes, for scripts/bench; see tests/bench/page/reading.js.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import esbuild from "esbuild";
import { launch } from "../tests/page/browsers.mjs";
import { serve } from "./serve.mjs";

const ROOT = fileURLToPath(new URL("..", import.meta.url));
const PAGE = path.join(ROOT, "build/web-build/tests/bench/page");
const OBJECTS = path.join(ROOT, "assets/tankobjs");
const ROUNDS = 11;
const TIMEOUT = 120_000;

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Gives rows { name, ours_ms, other, other_ms, ratio, target }. */
export async function measureReading(say) {
  say("reading OBJ files: Chromium");
  const bundled = path.join(PAGE, "reading.bundle.js");
  await esbuild.build({
    entryPoints: [path.join(ROOT, "tests/bench/page/reading.js")],
    bundle: true,
    outfile: bundled,
    logLevel: "warning",
  });
  const files = fs.readdirSync(OBJECTS).filter((name) => name.endsWith(".obj"));
  /** @type {[string, string][]} */
  const texts = files.map((name) => [name, fs.readFileSync(path.join(OBJECTS, name), "utf8")]);
  const server = await serve(PAGE, { isolated: true });
  const browser = await launch("chromium");
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(TIMEOUT);
    await page.goto(`${server.url}reading.html`);
    const times = await page.evaluate((...given) => window.reading(...given), texts, ROUNDS);
    return [
      ["reading OBJ into lists", times.ours, 0.5],
      ["the same with the links' steps", times.ours_with_links, null],
    ].map(([name, ours, target]) => ({
      name,
      ours_ms: median(ours),
      other: "three.js",
      other_ms: median(times.three),
      ratio: median(ours) / median(times.three),
      target,
    }));
  } finally {
    await browser.close();
    await server.close();
  }
}
