// The views: by key, in the link, the four at once with their names, and the gunner's, which shoots where it looks.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn, withTank } from "./tanklab_page.mjs";

test("a key goes through the views, and the link says which", async () => {
  await withTank("chromium", {}, async ({ page, state, problems }) => {
    for (const view of ["follow", "gunner", "four", "orbit"]) {
      await page.keyboard.press("End");
      await page.waitForFunction((name) => tanklab.state().view === name, {}, view);
      assert.equal((await state()).link.includes(`view=${view}`), view !== "orbit");
    }
    assert.deepEqual(problems, []);
  });
});

for (const viewport of [
  { width: 1280, height: 800 },
  { width: 390, height: 844 },
]) {
  test(`figure 1 shows four views, each with its name in its own quarter, at ${viewport.width} x ${viewport.height}`, async () => {
    await withTank("chromium", { viewport, path: "#figure=1" }, async ({ page }) => {
      const named = await page.evaluate(() => {
        const picture = document.getElementById("canvas").getBoundingClientRect();
        return [...document.querySelectorAll("#pane-names li")].map((name) => {
          const box = name.getBoundingClientRect();
          const column = (x) => (x - picture.left) / picture.width;
          const row = (y) => (y - picture.top) / picture.height;
          return {
            text: name.textContent,
            shown: name.checkVisibility(),
            left: column(box.left),
            right: column(box.right),
            top: row(box.top),
            bottom: row(box.bottom),
          };
        });
      });
      const quarter = ({ left, right, top, bottom }) => [
        left >= 0.5 ? 1 : right <= 0.5 ? 0 : null,
        top >= 0.5 ? 1 : bottom <= 0.5 ? 0 : null,
      ];
      assert.deepEqual(
        named.map((name) => [name.text, ...quarter(name)]),
        [
          ["From the front", 0, 0],
          ["From the left", 1, 0],
          ["In perspective", 0, 1],
          ["From above", 1, 1],
        ],
      );
      assert.ok(named.every(({ shown }) => shown));
      const covered = await page.evaluate(() => {
        const picture = document.getElementById("canvas").getBoundingClientRect();
        const panel = document.getElementById("tasks").getBoundingClientRect();
        return (
          Math.min(picture.right, panel.right) - Math.max(picture.left, panel.left) > 1 &&
          Math.min(picture.bottom, panel.bottom) - Math.max(picture.top, panel.top) > 1
        );
      });
      assert.equal(covered, false, "no view lies under the panel");
      const viewports = await page.evaluate(() => tanklab.capture().filter(({ name }) => name === "glViewport").length);
      assert.equal(viewports, 4);
      await page.evaluate(() => tanklab.command("view", 0));
      await page.waitForFunction(() => document.getElementById("pane-names").hidden);
    });
  });
}

test("the gunner's drag turns turret and gun, and Space fires from the muzzle", async () => {
  await withTank("chromium", { path: "?overlays=0#view=gunner&speed=20" }, async ({ page, state }) => {
    const before = await state();
    await page.mouse.move(400, 300);
    await page.mouse.down();
    await page.mouse.move(480, 360, { steps: 4 });
    await page.mouse.up();
    await drawn(page);
    const after = await state();
    assert.ok(after.turret > before.turret, "the picture goes to the right, so the turret turns to the left");
    assert.ok(after.gun > before.gun, "the picture goes down, so the gun rises");
    assert.deepEqual([after.orbit, after.tilt, after.event], [before.orbit, before.tilt, "none"]);
    await page.keyboard.press("Space");
    await page.waitForFunction(() => tanklab.state().shot);
    const shot = (await state()).shot;
    assert.ok(Math.hypot(shot[0], shot[2]) > 6, `${shot} is before the muzzle`);
    assert.equal((await state()).touches, 0);
  });
});
