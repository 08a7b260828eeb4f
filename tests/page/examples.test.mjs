// A program for OpenGL 1.1 of somebody else's, linked with legacygl, on a page of its own.
import { test } from "node:test";
import assert from "node:assert/strict";
import { differentPixels, keepPicture, pixels, withPage } from "./harness.mjs";

test("the example's cube turns, its sides lit and coloured", async () => {
  await withPage(
    "chromium",
    { folder: process.env.TANKLAB_EXAMPLES, path: "spinning_cube.html" },
    async ({ page, problems }) => {
      await page.waitForFunction(() => document.querySelector("canvas").width === 640);
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      const first = await pixels(page, "#canvas");
      keepPicture("spinning_cube", first);
      const colours = new Set();
      for (let i = 0; i < first.data.length; i += 4) {
        colours.add(`${first.data.subarray(i, i + 3)}`);
      }
      assert.ok(colours.size >= 3, `${colours.size} colours`);
      await page.waitForFunction(
        (start) => performance.now() > start + 500,
        {},
        await page.evaluate(() => performance.now()),
      );
      assert.ok(differentPixels(first, await pixels(page, "#canvas")) > 500, "it stands still");
      assert.deepEqual(problems, []);
    },
  );
});
