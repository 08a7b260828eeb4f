// Real keys, the mouse and the buttons, in a real browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { pixels } from "./harness.mjs";
import { BARE, drawn, holdKey, withTank } from "./tanklab_page.mjs";

const SMALL = { width: 320, height: 200 }; // quickly drawn

/** Returns how far a value went from one state to another; a wrapping one by the shorter way. */
function moved(command, before, after) {
  const difference = after - before;
  return command.wraps ? ((difference + 540) % 360) - 180 : difference;
}

test("every key that is held moves its values, and its opposite moves them back", async () => {
  await withTank("chromium", { viewport: SMALL }, async ({ page, state, problems }) => {
    const commands = await page.evaluate(() => tanklab.commands());
    await page.evaluate(() => tanklab.command("heading", 45)); // so that driving moves the tank along X and Z
    const fields = new Map(commands.filter((c) => c.kind === "set").map((c) => [c.name, c]));
    const directions = new Map();
    for (const command of commands.filter((c) => c.kind === "hold" && c.fields?.length)) {
      for (const code of command.keys) {
        const before = await state();
        const changed = (now) => command.fields.every((field) => now[field] !== before[field]);
        const after = await holdKey(page, code, changed);
        assert.ok(changed(after), `${code} does not ${command.title}: ${JSON.stringify(after)}`);
        await drawn(page);
        const still = await state();
        await drawn(page);
        assert.deepEqual(await state().then((s) => s.held), [], `${code} is let go of`);
        for (const field of command.fields) {
          assert.equal((await state())[field], still[field], `${field} stays after ${code}`);
          const sign = Math.sign(moved(fields.get(field), before[field], still[field]));
          const key = `${command.name} ${field}`;
          if (directions.has(key)) {
            assert.equal(sign, directions.get(key), `${code} as the other keys of ${command.name}`);
          }
          directions.set(key, sign);
        }
      }
    }
    for (const [one, other] of [
      ["turret_left", "turret_right"],
      ["gun_up", "gun_down"],
      ["secondary_gun_left", "secondary_gun_right"],
      ["secondary_gun_up", "secondary_gun_down"],
      ["wheels_forward", "wheels_backward"],
      ["turn_left", "turn_right"],
      ["orbit_left", "orbit_right"],
      ["zoom_in", "zoom_out"],
    ]) {
      for (const [key, sign] of directions) {
        if (key.startsWith(`${one} `)) {
          assert.equal(directions.get(key.replace(one, other)), -sign, `${one} against ${other}`);
        }
      }
    }
    assert.deepEqual(problems, []);
  });
});

test("the guns stop at their limits and Backspace brings the pose back", async () => {
  await withTank("chromium", { path: "#gun=18&secondary_gun=-115&turret=20" }, async ({ page, state }) => {
    assert.equal((await holdKey(page, "KeyR", (now) => now.gun >= 20)).gun, 20);
    assert.equal((await holdKey(page, "KeyG", (now) => now.secondary_gun <= -120)).secondary_gun, -120);
    await holdKey(page, "KeyR", () => false, 300);
    assert.equal((await state()).gun, 20, "and go no further");
    assert.equal((await holdKey(page, "Period", (now) => now.secondary_gun_pitch >= 60)).secondary_gun_pitch, 60);
    assert.equal((await holdKey(page, "Comma", (now) => now.secondary_gun_pitch <= -10)).secondary_gun_pitch, -10);
    await page.keyboard.press("Backspace");
    await page.waitForFunction(() => tanklab.state().gun === 0 && tanklab.state().turret === 0);
  });
});

test("turning the turret changes the picture where the turret is, and nowhere else", async () => {
  await withTank("chromium", { path: `${BARE}#distance=14` }, async ({ page }) => {
    const before = await pixels(page, "#canvas");
    await holdKey(page, "KeyQ", (now) => now.turret > 25);
    await drawn(page);
    const after = await pixels(page, "#canvas");
    const changed = (x0, y0, x1, y1) => {
      let count = 0;
      for (let y = Math.round(y0 * before.height); y < y1 * before.height; ++y) {
        for (let x = Math.round(x0 * before.width); x < x1 * before.width; ++x) {
          const i = (y * before.width + x) * 4;
          if ([0, 1, 2].some((c) => Math.abs(before.data[i + c] - after.data[i + c]) > 8)) {
            ++count;
          }
        }
      }
      return count;
    };
    assert.ok(changed(0.3, 0.25, 0.75, 0.6) > 2000, "the turret's part of the picture");
    assert.equal(changed(0, 0.9, 1, 1), 0, "the ground before the tank");
    assert.equal(changed(0, 0, 1, 0.08), 0, "the sky");
  });
});

test("dragging goes round the tank and the wheel goes nearer", async () => {
  await withTank("chromium", {}, async ({ page, state }) => {
    const before = await state();
    await page.mouse.move(300, 300);
    await page.mouse.down();
    await page.mouse.move(380, 330, { steps: 4 });
    await page.mouse.up();
    await page.waitForFunction((o) => tanklab.state().orbit !== o, {}, before.orbit);
    const dragged = await state();
    assert.notEqual(dragged.tilt, before.tilt);
    await page.mouse.wheel({ deltaY: -240 });
    await page.waitForFunction((d) => tanklab.state().distance < d, {}, before.distance);
    await page.mouse.wheel({ deltaY: 960 });
    await page.waitForFunction((d) => tanklab.state().distance > d, {}, before.distance);
  });
});

test("a row of the list of keys does what its key does, for as long as it is pressed", async () => {
  await withTank("chromium", { viewport: { width: 1200, height: 800 } }, async ({ page, state }) => {
    const row = await page.waitForSelector('#keys [data-command="turret_left"]', { visible: true });
    const { x, y, width, height } = await row.boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.waitForFunction(() => tanklab.state().turret > 5);
    assert.ok(
      await page.evaluate(() => document.querySelector('[data-command="turret_left"]').classList.contains("held")),
    );
    await page.mouse.up();
    await page.waitForFunction(() => tanklab.state().held.length === 0);
    const turned = (await state()).turret;
    await drawn(page);
    assert.equal((await state()).turret, turned);
  });
});

test("Tab leads out of the picture, and keys do nothing until it has the focus again", async () => {
  await withTank("chromium", {}, async ({ page, state }) => {
    assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
    await page.keyboard.press("Tab");
    assert.notEqual(await page.evaluate(() => document.activeElement.id), "canvas");
    assert.equal(await page.evaluate(() => document.getElementById("focus-hint").hidden), false);
    await holdKey(page, "KeyQ", () => false, 300);
    assert.equal((await state()).turret, 0);
    await page.mouse.click(300, 500);
    assert.ok((await holdKey(page, "KeyQ", (now) => now.turret > 0)).turret > 0);
  });
});

test("in Firefox the keys turn the turret, too", async () => {
  await withTank("firefox", {}, async ({ page, problems }) => {
    assert.ok((await holdKey(page, "KeyE", (now) => now.turret < 0, 20000)).turret < 0);
    assert.deepEqual(problems, []);
  });
});
