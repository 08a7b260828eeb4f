// What goes wrong is said, with what to do; what comes back comes back.
import assert from "node:assert/strict";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { test } from "node:test";
import { differentPixels, pixels, SITE, withPage } from "./harness.mjs";
import { BARE, drawn, withTank } from "./tanklab_page.mjs";

/** Answers requests for a file with something else. */
const answering = (file, answer) => async (page) => {
  await page.setRequestInterception(true);
  page.on("request", (request) => (request.url().includes(file) ? request.respond(answer) : request.continue()));
};

/** Opens a page that cannot start and returns what it says. */
async function failure(options) {
  return withPage("chromium", options, async ({ page }) => {
    await page.waitForSelector("#failure:not([hidden])");
    const rejected = await page.evaluate(() =>
      tanklab.ready.then(
        () => "",
        (error) => error.message,
      ),
    );
    const said = await page.evaluate(() => document.getElementById("failure").innerText);
    assert.ok(rejected && said.includes(rejected), `tanklab.ready says it, too: ${rejected}`);
    return said;
  });
}

test("a missing file is named, with the server's answer", async () => {
  const said = await failure({ before: answering("tankturret.obj", { status: 404, body: "" }) });
  assert.match(said, /tankturret\.obj/);
  assert.match(said, /404/);
});

test("a malformed model is named with its line", async () => {
  const body = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n";
  const said = await failure({ before: answering("tankwheel.obj", { status: 200, body, contentType: "text/plain" }) });
  assert.match(said, /tankwheel\.obj:4/);
});

test("a damaged picture is named", async () => {
  const said = await failure({
    before: answering("texture.jpg", { status: 200, body: "no picture", contentType: "image/jpeg" }),
  });
  assert.match(said, /texture\.jpg/);
});

test("a browser without WebGL 2 is told so", async () => {
  const before = (page) =>
    page.evaluateOnNewDocument(() => {
      const real = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = /** @type {any} */ (
        function (kind, ...rest) {
          return kind === "webgl2" ? null : real.call(this, kind, ...rest);
        }
      );
    });
  assert.match(await failure({ before }), /WebGL 2/);
});

test("after a lost context the picture comes back by itself", async () => {
  await withTank("chromium", { path: `${BARE}#turret=40` }, async ({ page }) => {
    const before = await pixels(page, "#canvas");
    await page.evaluate(async () => {
      const extension = document.querySelector("canvas").getContext("webgl2").getExtension("WEBGL_lose_context");
      const event = (name) =>
        new Promise((done) => document.querySelector("canvas").addEventListener(name, done, { once: true }));
      const lost = event("webglcontextlost");
      extension.loseContext();
      await lost;
      await new Promise((done) => setTimeout(done, 300));
      tanklab.command("gun", 15); // Life goes on without a picture.
      const restored = event("webglcontextrestored");
      extension.restoreContext();
      await restored;
    });
    await drawn(page);
    await drawn(page);
    const raised = await pixels(page, "#canvas");
    assert.ok(differentPixels(before, raised, 8) > 200, "the gun was raised meanwhile");
    await page.evaluate(() => tanklab.command("gun", 0));
    await drawn(page);
    assert.equal(differentPixels(before, await pixels(page, "#canvas")), 0);
  });
});

test("the page in one file works without a server", async () => {
  const url = pathToFileURL(path.join(SITE, "tanklab.html")).href + "#turret=25";
  await withTank("chromium", { url }, async ({ state, problems }) => {
    assert.equal((await state()).turret, 25);
    assert.deepEqual(problems, []);
  });
});
