// The oracle's scenes through legacygl as WebAssembly, held against the pictures that the native build draws.
// The native program draws them anew for each run, so that no picture is an old one.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { spawnSync } from "node:child_process";
import { after, before, test } from "node:test";
import { printRenderer, withPage } from "./harness.mjs";

const drawer = path.join(process.env.TANKLAB_NATIVE, "tests/oracle/oracle_emulated");

let folder;
before(() => {
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-oracle-"));
  const done = spawnSync(drawer, [folder], { encoding: "utf8" });
  assert.equal(done.status, 0, `${drawer}: ${done.error ?? done.stderr}`);
});
after(() => fs.rmSync(folder, { recursive: true }));

/** Counts the pixels in which a channel is off by more than `tolerance`. */
function pixelsOff(one, other, tolerance) {
  assert.equal(one.length, other.length, "the pictures are of different sizes");
  let count = 0;
  for (let i = 0; i < one.length; i += 4)
    if ([0, 1, 2, 3].some((channel) => Math.abs(one[i + channel] - other[i + channel]) > tolerance)) ++count;
  return count;
}

/** Gives the first line that two texts do not share, as a list of at most one sentence. */
function firstOther(text, reference) {
  const [lines, expected] = [text, reference].map((each) => each.split("\n"));
  const at = lines.findIndex((line, i) => line !== expected[i]);
  return at < 0 && lines.length === expected.length ? [] : [`tells '${lines.at(at)}' instead of '${expected.at(at)}'`];
}

/** Draws every scene in a browser and hands allowed(name, pixels) the number of pixels to allow.
    What lies beyond that, or below a nonzero allowance that nothing needs any more, fails. */
async function compare(browser, tolerance, allowed) {
  await withPage(browser, { folder: process.env.TANKLAB_ORACLE_PAGE }, async ({ page, problems }) => {
    await printRenderer(page, browser);
    await page.waitForFunction("window.drawScene");
    const names = await page.evaluate("sceneNames()");
    const native = fs.readdirSync(folder).filter((file) => file.endsWith(".rgba"));
    assert.deepEqual([...names].sort(), native.map((file) => file.replace(".rgba", "")).sort(), "the builds have other scenes");
    const failures = [];
    let same = 0;
    for (const [index, name] of names.entries()) {
      const { problem, told, pixels } = await page.evaluate((i) => drawScene(i), index);
      const reference = fs.readFileSync(path.join(folder, `${name}.rgba`));
      const picture = Buffer.from(pixels, "base64");
      if (problem) failures.push(`${name}: ${problem}`);
      failures.push(...firstOther(told, fs.readFileSync(path.join(folder, `${name}.txt`), "utf8")).map((line) => `${name} ${line}`));
      if (picture.equals(reference)) ++same;
      const count = pixelsOff(picture, reference, tolerance);
      if (count > allowed(name, reference.length / 4)) failures.push(`${name}: ${count} pixels differ by more than ${tolerance}`);
    }
    console.log(`${browser}: ${same} of ${names.length} scenes are the native ones to the byte`);
    assert.deepEqual(failures, []);
    assert.deepEqual(problems, []);
  });
}

for (const browser of ["chromium-mesa", "firefox"])
  test(`${browser} draws every scene as the native build does, to the byte`, () => compare(browser, 0, () => 0));

test("SwiftShader draws every scene within the design's bound", () => compare("chromium", 8, (name, pixels) => 0.002 * pixels));
