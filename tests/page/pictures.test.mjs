// The page's pictures against the native program's, and what a steady frame costs.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { differentPixels, keepPicture, pixels, printRenderer, readPicture } from "./harness.mjs";
import { BARE, drawn, withTank } from "./tanklab_page.mjs";

const LINKS = [
  "",
  "#turret=60&gun=20&secondary_gun=45&orbit=-150&tilt=25",
  "#turret=-165&gun=-9&heading=30&orbit=90&tilt=3&distance=9",
];
const SIZE = { width: 640, height: 400 };

/** Draws a link by the native program. */
function native(link) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-native-"));
  try {
    const out = path.join(folder, "native.png");
    const program = path.join(process.env.TANKLAB_NATIVE, "tanklab-render");
    const done = spawnSync(program, [link || "#", "--size", `${SIZE.width}x${SIZE.height}`, "--out", out], {
      encoding: "utf8",
    });
    assert.equal(done.status, 0, done.stderr);
    return readPicture(out);
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

/** Compares the page's pictures of all links with the native ones; allowed(count, total) judges. */
async function compare(browser, links, tolerance, allowed) {
  for (const [i, link] of links.entries()) {
    await withTank(browser, { path: BARE + link, viewport: SIZE }, async ({ page }) => {
      if (i === 0) {
        await printRenderer(page, browser);
      }
      await drawn(page);
      const picture = await pixels(page, "#canvas");
      const reference = native(link);
      const count = differentPixels(picture, reference, tolerance);
      console.log(`${browser} ${link || "#"}: ${count} pixels differ by more than ${tolerance}`);
      if (!allowed(count)) {
        keepPicture(`${browser}-${i}-page`, picture);
        keepPicture(`${browser}-${i}-native`, reference);
        assert.fail(`${count} pixels differ; both are in build/test/pictures`);
      }
    });
  }
}

test("Chromium on Mesa draws the native picture to the byte", () =>
  compare("chromium-mesa", LINKS, 0, (count) => count === 0));

// Without the ground: SwiftShader lays whole grid lines a pixel beside Mesa's, 0.65 % of the first picture.
const WITHOUT_GROUND = LINKS.map((link) => (link ? `${link}&ground=off` : "#ground=off"));

test("Chromium on SwiftShader draws the native tank within the design's bound", () =>
  compare("chromium", WITHOUT_GROUND, 8, (count) => count <= 0.002 * SIZE.width * SIZE.height));

test("a steady frame makes no object, compiles no shader and makes few calls besides the ground and the shadow on it", async () => {
  const before = (page) =>
    page.evaluateOnNewDocument(() => {
      window.glCalls = {};
      for (const name of Object.getOwnPropertyNames(WebGL2RenderingContext.prototype)) {
        const real = Object.getOwnPropertyDescriptor(WebGL2RenderingContext.prototype, name)?.value;
        if (typeof real !== "function") {
          continue;
        }
        WebGL2RenderingContext.prototype[name] = function (...args) {
          window.glCalls[name] = (window.glCalls[name] ?? 0) + 1;
          return real.apply(this, args);
        };
      }
    });
  await withTank("chromium", { before, path: "#task=1.2&ground=off" }, async ({ page }) => {
    await page.keyboard.down("KeyQ");
    await page.waitForFunction(() => tanklab.state().turret > 4);
    const calls = await page.evaluate(async () => {
      window.glCalls = {};
      const from = tanklab.state().tick;
      await new Promise((done) => {
        const wait = () => (tanklab.state().tick >= from + 20 ? done() : requestAnimationFrame(wait));
        wait();
      });
      return window.glCalls;
    });
    await page.keyboard.up("KeyQ");
    assert.ok(calls.clear > 0 && calls.drawArrays > 0, JSON.stringify(calls));
    for (const name of [
      "compileShader",
      "linkProgram",
      "texImage2D",
      "createBuffer",
      "createVertexArray",
      "getError",
      "readPixels",
    ]) {
      assert.equal(calls[name] ?? 0, 0, `${name} in a steady frame: ${JSON.stringify(calls)}`);
    }
    const draws = ((calls.drawArrays ?? 0) + (calls.drawElements ?? 0)) / calls.clear;
    console.log(`${draws} draw calls a frame`);
    assert.ok(draws <= 25 + 10, "20 parts and tracks, the sky and an axis");
  });
});
