// The list of tasks and figures: what it says, what it opens, and what its checks find.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { holdKey, withTank } from "./tanklab_page.mjs";

const WINDOW = { width: 700, height: 500 };

/** Returns what the page shows of the open entry. */
const openEntry = (page) =>
  page.evaluate(() => {
    const entries = [...document.querySelectorAll(".task.current")];
    if (entries.length !== 1) {
      return { count: entries.length };
    }
    const [entry] = entries;
    const text = (selector) => entry.querySelector(selector)?.innerText ?? "";
    return {
      count: 1,
      id: entry.dataset.id,
      said: text(".card p"),
      source: text(".source"),
      commands: [...entry.querySelectorAll("[data-command]")].map((button) => button.dataset.command),
      labels: [...entry.querySelectorAll(".facts dt")].map((label) => label.innerText),
      values: [...entry.querySelectorAll(".facts dd")].map((value) => value.innerText),
    };
  });

test("each task and figure is opened by its link, shown with all it has, and gives the link back", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#task=1.1" }, async ({ page, problems }) => {
    const rows = await page.evaluate(() => [...tanklab.tasks(), ...tanklab.figures()]);
    assert.equal(rows.filter((row) => row.kind === "task").length, 13);
    assert.equal(rows.filter((row) => row.kind === "figure").length, 14);
    for (const row of rows) {
      await page.evaluate((link) => (location.hash = link), row.link);
      await page.waitForFunction(
        ({ kind, id }) =>
          tanklab.state()[kind] === id &&
          document.querySelector(".task.current")?.dataset.id === id &&
          document.querySelector(".task.current .facts dd"),
        {},
        row,
      );
      const shown = await openEntry(page);
      assert.equal(shown.said, row.text);
      assert.ok(shown.source.includes(row.source), shown.source);
      assert.deepEqual(shown.commands, row.commands);
      assert.ok(
        shown.values.every((value) => value !== ""),
        JSON.stringify(shown),
      );
      const state = await page.evaluate(() => tanklab.state());
      assert.deepEqual(
        shown.labels,
        state.evidence.map(({ label }) => label),
        row.id,
      );
      assert.equal(state.link.replace(/&tick=\d+$/, ""), row.link, "but for the time that has passed since");
      assert.ok((await page.title()).includes(row.title));
      // It follows four times in a second; what it must never say is caught at one task or another.
      assert.match(
        await page.$eval("#status", (line) => line.textContent),
        /^(High|Low|Both) models?(( · [\d,]+ (triangle|draw call|spark)s?)|( · projectile in flight))+$/,
      );
    }
    assert.deepEqual(
      await page.evaluate(() => [...document.querySelectorAll(".notice p")].map((p) => p.textContent)),
      [],
    );
    assert.deepEqual(problems, []);
  });
});

test("the list is found, a task opened and its keys used by keyboard alone", async () => {
  await withTank("chromium", { viewport: { width: 900, height: 700 } }, async ({ page, state }) => {
    const focus = () => page.evaluate(() => document.activeElement.textContent || document.activeElement.id);
    const tabTo = async (wanted) => {
      for (let i = 0; i < 40; ++i) {
        await page.keyboard.press("Tab");
        if (wanted(await focus())) {
          return;
        }
      }
      assert.fail(`Tab does not come to it, but to ${await focus()}`);
    };
    await tabTo((text) => text === "Tasks");
    await page.keyboard.press("Enter");
    assert.ok(await page.$eval("#tasks", (panel) => !panel.hidden));
    await tabTo((text) => text === "2.4");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => tanklab.state().task === "2.4");
    await page.waitForFunction(() => document.querySelector(".task.current")?.dataset.id === "2.4");
    await page.keyboard.press("Escape");
    assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
    const before = (await state()).point_x;
    assert.ok((await holdKey(page, "KeyL", (now) => now.point_x > before)).point_x > before);
    await page.keyboard.press("Digit3");
    await page.waitForFunction(() => tanklab.state().task === "3.1");
    await page.waitForFunction(() => document.querySelector(".task.current")?.dataset.id === "3.1");
  });
});

test("Check all runs every check by keyboard; each passes, and its verdict is shown as tanklab.tasks() has it", async () => {
  await withTank("chromium", { viewport: { width: 240, height: 160 }, path: "#task=1.3" }, async ({ page, state }) => {
    const before = (await state()).link;
    await page.focus(".check-all button");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.querySelector(".check-all button").disabled);
    await page.waitForFunction(() => !document.querySelector(".check-all button").disabled, { timeout: 300000 });
    const { tasks, tiles, summary } = await page.evaluate(() => ({
      tasks: tanklab.tasks(),
      tiles: [...document.querySelectorAll(".tile")].map((tile) => tile.getAttribute("aria-label")),
      summary: document.querySelector(".check-all .verdict").textContent,
    }));
    assert.deepEqual(
      tasks.filter((task) => !task.passed).map(({ id, evidence }) => ({ id, evidence })),
      [],
      "every task is right",
    );
    assert.equal(summary, "13 of 13 passed");
    await page.waitForFunction(() => document.title.startsWith("13 of 13 passed"));
    for (const [i, task] of tasks.entries()) {
      assert.equal(tiles[i], `${task.id} ${task.title}: passed`);
      const found = await page.$$eval(`.task[data-id="${task.id}"] .found li`, (lines) =>
        lines.map((line) => line.textContent),
      );
      assert.deepEqual(found, task.evidence);
    }
    assert.equal((await state()).link, before, "what is shown stays");
  });
});

test("a figure has no verdict, and an unknown id is refused", async () => {
  await withTank("chromium", {}, async ({ page }) => {
    const figure = await page.evaluate(() => tanklab.check("5b"));
    assert.deepEqual([figure.id, figure.passed, figure.evidence], ["5b", null, []]);
    await assert.rejects(
      page.evaluate(() => tanklab.check("9.9")),
      /9\.9/,
    );
  });
});

test("the tree of parts is shown as a tree", async () => {
  await withTank("chromium", { viewport: WINDOW, path: "#figure=2" }, async ({ page }) => {
    await page.waitForSelector(".task.current .tree");
    const below = (selector) =>
      page.$$eval(`.task.current .facts > dd > .tree > li${selector}`, (items) =>
        items.map((item) => item.firstChild.textContent),
      );
    assert.deepEqual(await below(""), ["body"]);
    assert.deepEqual(await below(" > ul > li"), ["turret", "wheel left 1 … 7", "wheel right 1 … 7"]);
    assert.deepEqual(await below(" > ul > li > ul > li"), ["main gun", "secondary gun"]);
  });
});

test("a check that fails is seen at a glance, with what it found, also from another task", async () => {
  // The low tank gets the high tank's wheels, which have far too many triangles.
  const wheel = fs.readFileSync(new URL("../../assets/tankobjs/tankwheel.obj", import.meta.url));
  const before = async (page) => {
    await page.setRequestInterception(true);
    page.on("request", (request) =>
      request.url().includes("tankwheelLow.obj") ? request.respond({ status: 200, body: wheel }) : request.continue(),
    );
  };
  await withTank("chromium", { viewport: WINDOW, path: "#task=3.1", before }, async ({ page }) => {
    await page.waitForSelector('.task.current[data-id="3.1"]');
    await page.click(".task.current .buttons button");
    await page.waitForFunction(() => document.querySelector(".task.current .verdict").textContent === "✗ failed", {
      timeout: 120000,
    });
    await page.evaluate(() => (location.hash = "#task=1.2"));
    await page.waitForSelector('.task.current[data-id="1.2"]');
    assert.equal(await page.$eval(".check-all .verdict", (said) => said.textContent), "1 failed, 12 not checked");
    assert.equal(
      await page.$eval(".tile.failed", (tile) => tile.getAttribute("aria-label")),
      "3.1 Assemble the low-detail tank: failed",
    );
    const found = await page.$eval('.task[data-id="3.1"]', (entry) => ({
      seen: entry.querySelector(".found").checkVisibility(),
      said: entry.querySelector(".found").innerText,
    }));
    assert.ok(found.seen);
    assert.match(found.said, /The low tank has \d+ triangles/);
  });
});
