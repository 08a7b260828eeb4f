// The pointer on the picture: a click fires, a drag of the point moves it, a drag elsewhere goes round.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn, withTank } from "./tanklab_page.mjs";

// The point stands in the middle of the picture, because the camera looks at it.
const POINT = "?overlays=0#probe=point&point_x=0&point_y=3&point_z=3&look_x=0&look_y=3&look_z=3";
const MIDDLE = { x: 400, y: 300 };

async function drag(page, from, by) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + by.x, from.y + by.y, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
}

test("a drag of the point moves it and leaves the camera", async () => {
  await withTank("chromium", { path: POINT }, async ({ page, state }) => {
    const before = await state();
    await drag(page, MIDDLE, { x: 60, y: -50 });
    const after = await state();
    assert.ok(after.point_y > before.point_y + 0.1, `${before.point_y} to ${after.point_y}`);
    assert.deepEqual([after.orbit, after.tilt, after.event], [before.orbit, before.tilt, before.event]);
  });
});

test("a drag elsewhere goes round and leaves the point", async () => {
  await withTank("chromium", { path: POINT }, async ({ page, state }) => {
    const before = await state();
    await drag(page, { x: 150, y: 450 }, { x: 80, y: 20 });
    const after = await state();
    assert.notEqual(after.orbit, before.orbit);
    assert.notEqual(after.tilt, before.tilt);
    assert.deepEqual(
      [after.point_x, after.point_y, after.point_z, after.event],
      [before.point_x, before.point_y, before.point_z, before.event],
    );
  });
});

test("a click fires through the pointer, and what it hits throws sparks", async () => {
  await withTank("chromium", { path: "?overlays=0#speed=20&look_y=1.5&look_z=0" }, async ({ page, state }) => {
    await page.mouse.click(MIDDLE.x, MIDDLE.y);
    await page.waitForFunction(() => tanklab.state().event === "fire" && tanklab.state().shot);
    const flying = await state();
    assert.equal(flying.orbit, 40);
    await page.waitForFunction(() => tanklab.state().sparks > 0 && tanklab.state().touches > 0, { timeout: 20000 });
  });
});
