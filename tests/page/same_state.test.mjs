// One result everywhere: what a link gives natively and on the page is the same, sparks and all, to the last bit.
import assert from "node:assert/strict";
import path from "node:path";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { withTank } from "./tanklab_page.mjs";

const SHOTS = [
  "speed=40&event=fire&tick=30",
  "turret=33.33&heading=-120.5&speed=20&event=fire&tick=75&seed=77",
  "particles=fountain&amount=5000&event=open&tick=200",
  "particles=sparks&event=open&tick=45&seed=9",
  "probe=line&heading=77.7&turret=-150&gun=19.99&x=12.345&z=-7.5",
];

/** Returns the state of a link by the native program. */
function native(link) {
  const program = path.join(process.env.TANKLAB_NATIVE, "tanklab-render");
  const done = spawnSync(program, [`#${link}`, "--state"], { encoding: "utf8" });
  assert.equal(done.status, 0, done.stderr);
  return JSON.parse(done.stdout);
}

/** Returns the state on the page just after it has opened a link, before time goes on. */
const opened = (page, link) => page.evaluate((fragment) => (tanklab.openLink(fragment), tanklab.state()), link);

/** Leaves out what tells of the way there: changes, what was printed, which spheres were computed, and the sparks of
    the shot before, which burn out; those of the shot under way are in the hash. */
function comparable({ revision, hits: { count, ...hits }, evidence, sparks, ...state }) {
  return { ...state, hits, evidence: evidence.filter(({ label }) => !/recomputed$|^Sparks alight$/.test(label)) };
}

test("every task, every figure and shots in flight are the same on the page as natively", async () => {
  await withTank("chromium", {}, async ({ page }) => {
    const tasks = await page.evaluate(() => tanklab.tasks().map((task) => task.link));
    const links = [...tasks, ...SHOTS];
    assert.ok(links.length >= 13 + SHOTS.length);
    for (const link of links) {
      const [here, there] = [await opened(page, link), native(link)];
      assert.match(here.hash, /^[0-9a-f]{16}$/);
      assert.deepEqual(comparable(here), comparable(there), link);
    }
  });
});
