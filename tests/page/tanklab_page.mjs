// What tests of Tank Lab's own page share.
import { withPage } from "./harness.mjs";

/** Hides what lies over the picture and switches antialiasing off, for pictures that are compared. */
export const BARE = "?antialias=0&overlays=0";

/** Opens the page, waits until the tank is there, and hands it to an async function, as withPage does. */
export async function withTank(browser, options, use) {
  const before = async (page, address) => {
    // Nothing fades then, and nobody waits for it.
    if (browser !== "firefox") {
      await page.emulateMediaFeatures([{ name: "prefers-reduced-motion", value: "reduce" }]);
    }
    await options.before?.(page, address);
  };
  return withPage(browser, { ...options, before }, async (given) => {
    const { page } = given;
    await page.waitForFunction("window.tanklab?.ready");
    await page.evaluate(() => tanklab.ready.then(() => true));
    await page.waitForSelector("body.ready");
    await page.waitForFunction('document.getElementById("loading").hidden');
    return use({ ...given, state: () => page.evaluate(() => tanklab.state()) });
  });
}

/** Returns after the page has drawn what is so now. */
export async function drawn(page) {
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))),
  );
}

/** Presses a real key until a condition on the state holds, or the time is over; returns the last state. */
export async function holdKey(page, code, until, milliseconds = 8000) {
  await page.keyboard.down(code);
  let state = await page.evaluate(() => tanklab.state());
  for (const end = Date.now() + milliseconds; Date.now() < end && !until(state);) {
    await drawn(page);
    state = await page.evaluate(() => tanklab.state());
  }
  await page.keyboard.up(code);
  return state;
}
