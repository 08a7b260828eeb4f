// The address and the state: each follows the other.
import assert from "node:assert/strict";
import { test } from "node:test";
import { differentPixels, pixels } from "./harness.mjs";
import { BARE, drawn, holdKey, withTank } from "./tanklab_page.mjs";

const SMALL = { width: 320, height: 200 }; // quickly drawn
const LINK = "#turret=30&gun=8&distance=14.5&orbit=-35.25";

test("a link opened twice gives the same state and the same pixels", async () => {
  const seen = [];
  for (let i = 0; i < 2; ++i) {
    await withTank("chromium", { path: BARE + LINK }, async ({ page, state, problems }) => {
      const { tick, revision, hash, ...rest } = await state(); // of time, which goes on
      seen.push({ state: rest, picture: await pixels(page, "#canvas") });
      assert.deepEqual(problems, []);
    });
  }
  assert.equal(seen[0].state.turret, 30);
  assert.equal(seen[0].state.orbit, -35.25);
  assert.deepEqual(seen[0].state, seen[1].state);
  assert.equal(differentPixels(seen[0].picture, seen[1].picture), 0);
});

test("the address follows the state without filling the history, and gives the state back", async () => {
  await withTank("chromium", {}, async ({ page, state }) => {
    const entries = await page.evaluate(() => history.length);
    await holdKey(page, "KeyQ", (now) => now.turret > 10);
    await holdKey(page, "KeyR", (now) => now.gun > 3);
    await page.waitForFunction(() => location.hash.includes("turret=") && location.hash.slice(1) === tanklab.link());
    assert.equal(await page.evaluate(() => history.length), entries);
    const { turret, gun } = await state();
    await page.reload();
    await page.evaluate(() => tanklab.ready.then(() => true));
    const again = await state();
    assert.deepEqual([again.turret, again.gun], [turret, gun]);
  });
});

test("an address that the reader changes is loaded, and what it has wrong is said", async () => {
  await withTank("chromium", {}, async ({ page, state }) => {
    await page.evaluate(() => (location.hash = "#turret=45&gun=much&colour=red&secondary_gun=500"));
    await page.waitForFunction(() => tanklab.state().turret === 45);
    await page.waitForFunction(() => document.querySelectorAll(".notice").length === 3);
    const said = await page.evaluate(() =>
      [...document.querySelectorAll(".notice p")].map((n) => n.textContent).join("\n"),
    );
    for (const named of ["gun", "colour", "secondary_gun"]) {
      assert.ok(said.includes(named), said);
    }
    const now = await state();
    assert.deepEqual([now.gun, now.secondary_gun], [0, 120]);
    await page.click(".notice button");
    assert.equal(await page.evaluate(() => document.querySelectorAll(".notice").length), 2);
  });
});

test("the Share button copies the address of what is shown", async () => {
  await withTank("chromium", { path: LINK }, async ({ page, context, url }) => {
    await context.overridePermissions(new URL(url).origin, [
      "clipboard-read",
      "clipboard-write",
      "clipboard-sanitized-write",
    ]);
    await page.click("#share");
    await page.waitForFunction(() => document.getElementById("share").textContent === "Copied");
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(new URL(copied).hash.slice(1), await page.evaluate(() => tanklab.link()));
    assert.ok(copied.startsWith(new URL(url).origin));
  });
});

test("window.tanklab refuses bad input with a sentence and changes nothing", async () => {
  await withTank("chromium", {}, async ({ page, state }) => {
    const before = await state();
    const said = await page.evaluate(() =>
      [
        ["nonsense", 1],
        ["turret", NaN],
        ["turret", Infinity],
      ].map(([name, value]) => {
        try {
          tanklab.command(name, value);
          return "";
        } catch (error) {
          return error.message;
        }
      }),
    );
    for (const sentence of said) {
      assert.match(sentence, /\w+ .*\./);
    }
    assert.equal((await state()).turret, before.turret);
    await assert.rejects(
      page.evaluate(() => tanklab.check("9.9")),
      /9\.9/,
    );
  });
});

test("the checks of the tasks pass, and leave state and picture as they were", async () => {
  await withTank("chromium", { path: BARE + LINK }, async ({ page, state }) => {
    const before = { state: (await state()).link, picture: await pixels(page, "#canvas") };
    for (const id of ["1.1", "1.2", "1.3", "1.4"]) {
      const task = await page.evaluate((i) => tanklab.check(i), id);
      assert.equal(task.passed, true, `${id}: ${JSON.stringify(task.evidence)}`);
      assert.ok(task.evidence.length > 0);
    }
    await drawn(page);
    assert.equal((await state()).link, before.state);
    assert.equal(differentPixels(before.picture, await pixels(page, "#canvas")), 0);
  });
});

/** Opens a link of a shot and returns what follows, by the tick it was seen at, until enough sparks were seen or
    the animation is over. */
const watch = (page, fragment) =>
  page.evaluate(
    (opened) =>
      new Promise((done) => {
        const seen = {};
        let withSparks = 0;
        const look = () => {
          const { link, shot, sparks, inside, touches } = tanklab.state();
          const tick = new URLSearchParams(link).get("tick");
          if (tick === null || withSparks === 20) {
            return done(seen);
          }
          seen[tick] = JSON.stringify({ shot, sparks, inside, touches });
          if (sparks > 10) {
            ++withSparks;
          }
          requestAnimationFrame(look);
        };
        tanklab.openLink(opened);
        look();
      }),
    fragment,
  );

test("a link of a shot under way replays it: the same flight and the same sparks, tick by tick", async () => {
  const link = "task=2.6&speed=30&event=fire&tick=1";
  let first;
  await withTank("chromium", { viewport: SMALL }, async ({ page }) => (first = await watch(page, link)));
  await withTank("chromium", { viewport: SMALL, path: `#${link}` }, async ({ page }) => {
    const withSparks = Object.values(first).filter((seen) => JSON.parse(seen).sparks > 10);
    assert.ok(withSparks.length >= 3, `${Object.keys(first)}`);
    for (const [tick, seen] of Object.entries(first)) {
      const again = await page.evaluate(
        (fragment) => {
          tanklab.openLink(fragment); // what passed since then does not count
          const { shot, sparks, inside, touches } = tanklab.state();
          return { link: tanklab.link(), seen: JSON.stringify({ shot, sparks, inside, touches }) };
        },
        link.replace(/tick=\d+/, `tick=${tick}`),
      );
      assert.equal(new URLSearchParams(again.link).get("tick"), tick);
      assert.equal(again.seen, seen, `at tick ${tick}`);
    }
  });
});
