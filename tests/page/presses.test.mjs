// Keys that do something once: each pressed for real, and what it does to the state.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn, withTank } from "./tanklab_page.mjs";

const SMALL = { width: 320, height: 200 }; // quickly drawn

// The commands that go to the next choice of a field, and the field.
const CHOICES = {
  next_tank: "tank",
  toggle_ground: "ground",
  next_handle: "handle",
  next_probe: "probe",
  next_spheres: "spheres",
  next_fit: "fit",
  toggle_triangles: "triangles",
  next_particles: "particles",
  next_detail: "detail",
  next_parts: "parts",
  next_axis: "axis",
  toggle_wireframe: "wireframe",
  next_view: "view",
};

/** Returns a table of what the other keys do: from (a link to press them in), and done(before, after, fields). */
function effects() {
  const isReset = (groups) => (before, after, fields) => {
    const own = fields.filter((field) => groups.includes(field.group));
    assert.ok(
      own.some((field) => before[field.name] !== after[field.name]),
      "something was to be brought back",
    );
    for (const field of own) {
      assert.equal(after[field.name], field.choices ? field.choices[field.default] : field.default, field.name);
    }
  };
  const opens = (kind, id) => (before, after) => assert.equal(after[kind], id);
  const fires = (before, after) => {
    assert.equal(after.event, "fire");
    assert.ok(after.shot, "the projectile flies");
  };
  return {
    reset_pose: {
      from: "turret=20&gun=5&heading=30&wheels_left=9",
      done: isReset(["Turret, guns and wheels", "Tank"]),
    },
    reset_view: { from: "orbit=1&tilt=50&distance=30", done: isReset(["Camera"]) },
    reset_projectile: { from: "point_x=1&line_ay=9&handle=line_b", done: isReset(["Projectile"]) },
    fire: { from: "speed=10", done: fires },
    fire_at_aim: { from: "speed=10", done: fires },
    print_report: {
      from: "probe=point",
      done: (before, after) => assert.equal(after.hits.count, before.hits.count + 1),
    },
    note_threshold: { from: "distance=33", done: (before, after) => assert.equal(after.threshold, 33) },
    next_task_1: { from: "task=1.1", done: opens("task", "1.2") },
    next_task_2: { from: "task=2.6", done: opens("task", "2.1") },
    next_task_3: { from: "", done: opens("task", "3.1") },
    next_figure: { from: "figure=5d", done: opens("figure", "6") },
  };
}

/** Opens a fragment, presses a key, and returns the states before and after, and how long the key was down for. */
async function press(page, fragment, code) {
  const before = await page.evaluate((link) => {
    tanklab.openLink(link);
    return tanklab.state();
  }, fragment);
  await page.keyboard.press(code);
  await drawn(page); // sparks change the state, too: what counts is that a frame has taken the key
  await page.waitForFunction((revision) => tanklab.state().revision !== revision, {}, before.revision);
  return { before, after: await page.evaluate(() => tanklab.state()) };
}

test("every key that is pressed does once what its row says", async () => {
  await withTank("chromium", { viewport: SMALL }, async ({ page, problems }) => {
    const commands = await page.evaluate(() => tanklab.commands());
    const fields = commands.filter((command) => command.kind === "set" && command.fields.length === 1);
    const table = effects();
    let pressed = 0;
    for (const command of commands.filter(({ kind, keys }) => kind === "press" && keys.length > 0)) {
      for (const code of command.keys) {
        ++pressed;
        const choice = fields.find(({ name }) => name === CHOICES[command.name]);
        if (!choice) {
          assert.ok(command.name in table, `this test does not know what ${command.name} does`);
          const { before, after } = await press(page, table[command.name].from, code);
          table[command.name].done(before, after, fields);
          continue;
        }
        let place = choice.default;
        await page.evaluate(() => tanklab.openLink(""));
        for (let i = 0; i < choice.choices.length; ++i) {
          await page.keyboard.press(code);
          place = (place + 1) % choice.choices.length;
          await page.waitForFunction(
            (name, value) => tanklab.state()[name] === value,
            { timeout: 5000 },
            choice.name,
            choice.choices[place],
          );
        }
        assert.equal(place, choice.default, `${code} goes through all of ${choice.name}`);
      }
    }
    assert.ok(pressed >= 20, String(pressed));
    assert.deepEqual(problems, []);
  });
});

test("no key has two commands, and a key with Ctrl is left to the browser", async () => {
  await withTank("chromium", { viewport: SMALL }, async ({ page, state }) => {
    const keys = await page.evaluate(() => tanklab.commands().flatMap((command) => command.keys));
    assert.equal(new Set(keys).size, keys.length);
    const before = await state();
    await page.keyboard.down("Control");
    await page.keyboard.press("KeyH");
    await page.keyboard.up("Control");
    await drawn(page);
    assert.equal((await state()).spheres, before.spheres);
  });
});

test("the projectile is fired by Space, throws sparks where it touches, and they go out", async () => {
  await withTank("chromium", { viewport: SMALL, path: "#task=2.6" }, async ({ page }) => {
    await page.keyboard.press("Space");
    await page.waitForFunction(() => tanklab.state().event === "fire" && tanklab.state().shot);
    await page.waitForFunction(() => tanklab.state().sparks > 0, { timeout: 20000 });
    await page.waitForFunction(() => tanklab.state().sparks === 0 && tanklab.state().touches > 0, { timeout: 30000 });
  });
});

test("going away and back past the threshold switches the level once each way", async () => {
  await withTank("chromium", { viewport: SMALL, path: "#task=3.3" }, async ({ page, state }) => {
    assert.deepEqual([(await state()).level, (await state()).level_switches], ["high", 0]);
    await page.keyboard.down("PageDown");
    await page.waitForFunction(() => tanklab.state().distance > 1.15 * tanklab.state().threshold);
    await page.keyboard.up("PageDown");
    await drawn(page);
    assert.deepEqual([(await state()).level, (await state()).level_switches], ["low", 1]);
    await page.keyboard.down("PageUp");
    await page.waitForFunction(() => tanklab.state().distance < 0.8 * tanklab.state().threshold);
    await page.keyboard.up("PageUp");
    await drawn(page);
    assert.deepEqual([(await state()).level, (await state()).level_switches], ["high", 2]);
  });
});
