// The harness itself: each browser starts, draws with WebGL 2 on the renderer it is said to, and its
// picture arrives.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { BROWSERS, checkVersion, differentPixels, pixelAt, pixels, printRenderer, withPage } from "./harness.mjs";

const RENDERERS = { chromium: /SwiftShader/i, "chromium-mesa": /llvmpipe|Mesa/i, firefox: /llvmpipe|Mesa/i };

const PAGE = `<!doctype html><meta charset="utf-8"><title>harness</title><link rel="icon" href="data:,">
<style>body { margin: 0 } canvas { display: block }</style><canvas id="canvas" width="80" height="60"></canvas>
<script>
const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, preserveDrawingBuffer: true });
gl.clearColor(32 / 255, 128 / 255, 224 / 255, 1);
gl.clear(gl.COLOR_BUFFER_BIT);
gl.enable(gl.SCISSOR_TEST);
gl.scissor(0, 0, 40, 30);
gl.clearColor(1, 0, 0, 1);
gl.clear(gl.COLOR_BUFFER_BIT);
window.drawn = true;
</script>`;

let folder;
before(() => {
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-harness-"));
  fs.writeFileSync(path.join(folder, "index.html"), PAGE);
  fs.writeFileSync(
    path.join(folder, "broken.html"),
    "<script>console.error('oh'); throw new Error('no')</script><img src=none.png>",
  );
});
after(() => fs.rmSync(folder, { recursive: true }));

for (const browser of BROWSERS) {
  test(`${browser} draws a WebGL 2 canvas and gives its pixels`, async () => {
    await withPage(browser, { folder }, async ({ page, problems }) => {
      assert.match(await printRenderer(page, browser), RENDERERS[browser]);
      await page.waitForFunction("window.drawn");
      const picture = await pixels(page, "#canvas");
      assert.deepEqual([picture.width, picture.height], [80, 60]);
      assert.deepEqual(pixelAt(picture, 79, 0), [32, 128, 224], "top right");
      assert.deepEqual(pixelAt(picture, 0, 59), [255, 0, 0], "bottom left");
      assert.deepEqual(problems, []);
    });
  });
}

test("a browser that is too old is named, with the version that is wanted; others are let through", () => {
  const program = path.join(folder, "firefox");
  for (const [told, tooOld] of [
    ["Mozilla Firefox 115.9.1esr", true],
    ["Mozilla Firefox 153.5.1esr", false],
    ["of no version", false],
  ]) {
    fs.writeFileSync(program, `#!/bin/sh\necho '${told}'\n`, { mode: 0o755 });
    if (tooOld) {
      assert.throws(() => checkVersion("firefox", program), /Firefox 115\.9.* is too old: .*firefox 129 and newer/);
    } else {
      assert.equal(checkVersion("firefox", program), told);
    }
  }
});

test("what goes wrong in a page is gathered", async () => {
  await withPage("chromium", { folder, path: "broken.html" }, async ({ problems }) => {
    assert.ok(
      problems.some((text) => text.startsWith("console: oh")),
      problems.join("\n"),
    );
    assert.ok(
      problems.some((text) => text.startsWith("exception: ") && text.includes("no")),
      problems.join("\n"),
    );
    assert.ok(
      problems.some((text) => text.includes("404")),
      problems.join("\n"),
    );
  });
});

test("different pixels are counted beyond the tolerance, and sizes must agree", () => {
  const picture = (...values) => ({
    width: values.length,
    height: 1,
    data: Uint8Array.from(values.flatMap((v) => [v, 0, 0, 255])),
  });
  assert.equal(differentPixels(picture(1, 2, 3), picture(1, 2, 3)), 0);
  assert.equal(differentPixels(picture(1, 2, 3), picture(1, 4, 6), 2), 1);
  assert.equal(differentPixels(picture(1, 2, 3), picture(1, 4, 6)), 2);
  assert.throws(() => differentPixels(picture(1), picture(1, 2)));
});
