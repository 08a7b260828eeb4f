// The tree of parts: what moves is marked there, by keys and drags, and what it carries along; its parts are buttons.
import assert from "node:assert/strict";
import { test } from "node:test";
import { withTank } from "./tanklab_page.mjs";

/** Returns the titles of the tree's rows that are marked so. */
const marked = (page, name) =>
  page.$$eval(`.task.current .tree li.${name} > .part`, (parts) => parts.map((part) => part.textContent));

const waitForMarks = (page, name, titles) =>
  page.waitForFunction(
    (mark, wanted) =>
      [...document.querySelectorAll(`.task.current .tree li.${mark} > .part`)]
        .map((part) => part.textContent)
        .join() === wanted,
    {},
    name,
    titles.join(),
  );

test("the tree marks what a key moves and what that carries along, until it rests", async () => {
  await withTank("chromium", { path: "#figure=2" }, async ({ page, problems }) => {
    await page.keyboard.down("KeyQ");
    await waitForMarks(page, "moving", ["turret"]);
    assert.deepEqual(await marked(page, "carried"), ["main gun", "secondary gun"]);
    const said = await page.$eval(".task.current .facts [role=status]", (status) => status.textContent);
    assert.equal(said, "Moving: turret; carried along: main gun and secondary gun.");
    await page.keyboard.up("KeyQ");
    await waitForMarks(page, "moving", []);
    assert.deepEqual(await marked(page, "carried"), []);

    await page.keyboard.down("Period");
    await waitForMarks(page, "moving", ["secondary gun"]);
    await page.keyboard.up("Period");
    await waitForMarks(page, "moving", []);

    await page.keyboard.down("KeyC");
    await waitForMarks(page, "moving", ["wheel left 1 … 7", "wheel right 1 … 7"]);
    assert.deepEqual(await marked(page, "carried"), []);
    await page.keyboard.up("KeyC");

    await page.keyboard.down("KeyA");
    await waitForMarks(page, "moving", ["body", "wheel left 1 … 7", "wheel right 1 … 7"]);
    assert.deepEqual(await marked(page, "carried"), ["turret", "main gun", "secondary gun"]);
    await page.keyboard.up("KeyA");
    assert.deepEqual(problems, []);
  });
});

test("the tree marks what a drag moves", async () => {
  await withTank("chromium", { path: "#figure=2&view=gunner" }, async ({ page }) => {
    await page.mouse.move(200, 300);
    await page.mouse.down();
    const marks = waitForMarks(page, "moving", ["turret"]);
    for (let x = 201, done = false; !done; x = x < 600 ? x + 3 : 200) {
      await page.mouse.move(x, 300); // on and on: a drag that rests is none
      done = await Promise.race([marks.then(() => true), new Promise((resolve) => setTimeout(resolve, 20, false))]);
    }
    await page.mouse.up();
    await waitForMarks(page, "moving", []);
  });
});

test("a part of the tree shows its axis by keyboard, and hides it again", async () => {
  await withTank("chromium", { path: "#figure=2" }, async ({ page, state }) => {
    await page.focus(".task.current .tree .part");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.textContent), "turret");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => tanklab.state().axis === "turret");
    await page.waitForFunction(() => document.activeElement.getAttribute("aria-pressed") === "true");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => tanklab.state().axis === "off");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.textContent), "secondary gun");
    for (const axis of ["secondary_gun", "secondary_gun_pitch", "off"]) {
      await page.keyboard.press("Enter");
      await page.waitForFunction((wanted) => tanklab.state().axis === wanted, {}, axis);
      await page.waitForFunction(
        (pressed) => document.activeElement.getAttribute("aria-pressed") === pressed,
        {},
        String(axis !== "off"),
      );
    }
    await page.keyboard.press("Tab");
    await page.keyboard.press("Space");
    await page.waitForFunction(() => tanklab.state().axis === "wheels");
    assert.equal((await state()).event, "none"); // Space pressed the button and fired nothing
  });
});
