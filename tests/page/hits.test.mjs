// What is penetrated, read from the page while real keys move the projectile.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn, holdKey, withTank } from "./tanklab_page.mjs";

const WINDOW = { width: 1000, height: 320 };

/** Returns the printed lines that the page shows, oldest first. */
const printed = (page) =>
  page.$$eval("#hits .log li", (items) =>
    items.reverse().map((item) => [...item.querySelectorAll("p")].map((line) => line.textContent)),
  );

/** Waits until the page has shown all that the program printed. */
const allPrinted = (page) =>
  page.waitForFunction(() => {
    const { log } = tanklab.hits();
    return Number(document.querySelector("#hits .log li")?.dataset.report) === log.at(-1).report;
  });

/** Returns the spheres that the page shows, as {name, amount, text, from, to}: percentages of the bar. */
const spheres = (page) =>
  page.$$eval("#hits .level", (levels) =>
    levels.map((level) => {
      const width = (selector) => level.querySelector(selector).getBoundingClientRect().width;
      const all = level.querySelector(".bar").clientWidth;
      return {
        name: level.querySelector("b").textContent,
        amount: level.querySelector(".amount").textContent,
        text: level.querySelector(".numbers").innerText,
        depth: width(".depth") / all,
        radius: width(".sphere") / all,
      };
    }),
  );

test("a point's hits are printed on load, on every change and by key, never the same line twice in a row", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#task=2.3" }, async ({ page, problems }) => {
    await page.waitForSelector("#hits:not([hidden])");
    await allPrinted(page);
    const first = await printed(page);
    assert.equal(first.length, 1);
    assert.match(first[0][0], /^Report 1/);
    assert.match(first[0][1], /^Point \(1, 2\.6, 1\.5\) is inside the whole tank/);

    await holdKey(page, "KeyL", (now) => now.point_x > 1.3);
    await drawn(page);
    await allPrinted(page);
    const moved = await printed(page);
    assert.ok(moved.length > 3, "each change is printed");

    await page.keyboard.press("KeyP");
    await page.waitForFunction((count) => tanklab.hits().count > count, {}, moved.length);
    await allPrinted(page);
    const asked = await printed(page);
    assert.match(asked.at(-1)[0], /asked for/);
    assert.deepEqual(asked.at(-1).slice(1), moved.at(-1).slice(1), "the same once more, because it was asked for");

    const lines = asked.flat();
    for (let i = 1; i < lines.length; ++i) {
      assert.notEqual(lines[i], lines[i - 1]);
    }
    const log = await page.evaluate(() => tanklab.hits().log.map(({ text }) => text));
    assert.deepEqual(lines, log, "as the program has it");
    await drawn(page);
    assert.equal(
      await page.evaluate(() => tanklab.hits().count),
      asked.length,
      "nothing is printed while nothing changes",
    );
    assert.deepEqual(problems, []);
  });
});

test("the root is shown first, then the parts that are penetrated, with bars as long as they are deep", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#task=2.3" }, async ({ page, state }) => {
    await page.waitForSelector("#hits .level");
    const { report } = (await state()).hits;
    const shown = await spheres(page);
    assert.equal(shown.length, 1 + report.parts.length);
    assert.ok(report.parts.length >= 2);
    for (const [i, test] of [report.root, ...report.parts].entries()) {
      assert.equal(shown[i].name, i === 0 ? "Tank" : test.part.replaceAll("_", " "));
      assert.equal(shown[i].amount, `${test.depth.toFixed(2)} m deep`);
      assert.ok(shown[i].text.includes(`radius ${test.radius.toFixed(2)} m`), shown[i].text);
      assert.ok(Math.abs(shown[i].depth - test.depth / test.radius) < 0.02, JSON.stringify([shown[i], test]));
    }
    assert.equal(await page.$$eval("#hits .tested-parts i", (marks) => marks.length), 18);
    assert.equal(await page.$$eval("#hits .tested-parts .is-inside", (marks) => marks.length), report.parts.length);
  });
});

test("outside the whole tank no part is tested, and the page says so", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#figure=5b" }, async ({ page, state }) => {
    await page.waitForSelector("#hits .level");
    const shown = await spheres(page);
    assert.equal(shown.length, 1);
    assert.match(shown[0].amount, /outside$/);
    assert.equal(shown[0].depth, 0);
    const { root } = (await state()).hits.report;
    assert.ok(Math.abs(shown[0].radius - root.radius / root.distance) < 0.02);
    assert.match(await page.$eval("#hits .now", (now) => now.innerText), /parts: not tested/);
  });
});

test("by keyboard a line is chosen and moved; its closest points and parameters are shown", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#task=2.4" }, async ({ page, state }) => {
    await page.waitForSelector("#hits .level");
    await page.focus('#hits input[value="point"]');
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => tanklab.state().probe === "segment");
    await page.waitForFunction(() =>
      /closest point \(.*\) at t = 0\.\d+/.test(document.querySelector("#hits .numbers")?.innerText),
    );
    await page.keyboard.press("Escape");
    for (const probe of ["ray", "line", "none", "point", "segment"]) {
      await page.keyboard.press("KeyY");
      await page.waitForFunction(
        (name) => tanklab.state().probe === name && document.querySelector("#hits input:checked").value === name,
        {},
        probe,
      );
    }
    await page.keyboard.press("KeyM");
    await page.waitForFunction(() => tanklab.state().handle === "line_a");
    const before = await state();
    const after = await holdKey(page, "KeyO", (now) => now.line_ay > before.line_ay + 0.2);
    assert.ok(after.line_ay > before.line_ay && after.point_y === before.point_y);
    await page.keyboard.press("KeyM");
    assert.ok((await holdKey(page, "KeyK", (now) => now.line_bz > before.line_bz)).line_bz > before.line_bz);
  });
});

test("choosing that nothing is tested closes neither the panel nor takes the focus from the choice", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#task=2.4" }, async ({ page }) => {
    await page.waitForSelector("#hits .level");
    await page.focus('#hits input[value="point"]');
    await page.keyboard.press("ArrowLeft");
    await page.waitForFunction(() => tanklab.state().probe === "none");
    await page.waitForFunction(() => /Nothing is tested/.test(document.querySelector("#hits .now").innerText));
    assert.equal(await page.$eval("#hits", (panel) => panel.hidden), false);
    assert.equal(await page.evaluate(() => document.activeElement.value), "none");
    await page.evaluate(() => tanklab.openLink("task=1.1"));
    await page.waitForFunction(() => document.getElementById("hits").hidden);
  });
});

test("a point that its triangles reject is shown as rejected", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#figure=7d" }, async ({ page, state }) => {
    await page.waitForSelector("#hits .level");
    const { triangles } = (await state()).hits.report;
    assert.ok(triangles.length > 0);
    const said = await page.$eval("#hits .now", (now) => now.innerText);
    assert.equal(said.match(/rejected/g)?.length, triangles.filter((one) => !one.inside).length);
  });
});

test("what is penetrated is read out when it changes, without its numbers and not too often", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#figure=5d" }, async ({ page }) => {
    await page.evaluate(() => {
      window.said = [];
      new MutationObserver(() =>
        window.said.push([performance.now(), document.getElementById("hits-said").textContent]),
      ).observe(document.getElementById("hits-said"), { childList: true });
    });
    assert.equal(
      await page.$eval("#hits-said", (said) => said.textContent),
      "",
      "what the page begins with is read where it stands",
    );
    await holdKey(page, "KeyO", (now) => !now.hits.report.root.inside, 15000);
    await page.waitForFunction(() => window.said.at(-1)?.[1] === "Outside the whole tank.");
    const times = await page.evaluate(() => window.said.map(([time]) => time));
    for (let i = 1; i < times.length; ++i) {
      assert.ok(times[i] - times[i - 1] > 1000, JSON.stringify(times));
    }
  });
});
