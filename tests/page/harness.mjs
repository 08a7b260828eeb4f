// What page tests share: browsers, the server, and pictures.
//
// A page test is a file NAME.test.mjs in this folder, run by `node --test` and known to CTest as page/NAME:
//
//   import { BROWSERS, withPage, pixels, differentPixels } from "./harness.mjs";
//   for (const browser of BROWSERS) {
//     test(`turns the turret in ${browser}`, async () => {
//       await withPage(browser, { path: "#turret=30" }, async ({ page, problems }) => {
//         ...
//         assert.deepEqual(problems, []);
//       });
//     });
//   }
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after } from "node:test";
import { fileURLToPath } from "node:url";
import { PNG } from "pngjs";
import { serve } from "../../scripts/serve.mjs";
import { launch, SITE, VIEWPORT } from "./browsers.mjs";

export { BROWSERS, checkVersion, SITE } from "./browsers.mjs";

const running = new Map(); // what launch() gives, by the browser's name; a test file has each once
after(async () => {
  for (const browser of running.values()) {
    await (await browser).close();
  }
});

/** Opens a session with nothing remembered from another one. Gives {browser, context, close()}. */
async function openSession(name, flags) {
  if (flags) {
    const browser = await launch(name, { flags });
    return { browser, context: browser.defaultBrowserContext(), close: () => browser.close() };
  }
  if (!running.has(name)) {
    running.set(name, launch(name));
  }
  const browser = await running.get(name);
  const context = await browser.createBrowserContext();
  return { browser, context, close: () => context.close() };
}

/** Opens a page in a session of its own, hands it to an async function, and closes it whatever happens.
    path: what follows the site's address, such as "#turret=30"; url: another address instead;
    folder: another folder to serve; viewport: its size and device-pixel ratio.
    before: called with the page before it loads anything, to listen or to break something.
    flags: for a browser of its own, besides those of launch().
    The function gets { page, browser, context, url, problems }; problems gathers, as text, what the page's console calls
    an error, exceptions nobody caught, and requests that failed.
    @param {string} name
    @param {{path?: string, url?: string, folder?: string, viewport?: object, before?: Function, flags?: string[]}} options
    @param {Function} use */
export async function withPage(name, { path: rest = "", url, folder = SITE, viewport, before, flags } = {}, use) {
  const server = url ? null : await serve(folder);
  const { browser, context, close } = await openSession(name, flags);
  try {
    const page = await context.newPage();
    if (viewport) {
      await page.setViewport({ ...VIEWPORT, ...viewport });
    }
    const problems = [];
    page.on("console", (message) => {
      const where = message.location()?.url;
      if (message.type() === "error") {
        problems.push(`console: ${message.text()}${where ? ` (${where})` : ""}`);
      }
    });
    page.on("pageerror", (error) => problems.push(`exception: ${error.message}`));
    page.on("requestfailed", (request) => {
      // Chromium calls a fetch aborted whose stream was read to its end before the connection said so.
      const reason = request.failure()?.errorText;
      if (!/ABORTED/.test(reason)) {
        problems.push(`request: ${request.url()} ${reason}`);
      }
    });
    const address = url ?? server.url + rest;
    if (before) {
      await before(page, address);
    }
    await page.goto(address);
    return await use({ page, browser, context, url: address, problems });
  } finally {
    await close();
    await server?.close();
  }
}

/** Takes a picture of the page or of one element. Gives { width, height, data }: rows top first, RGBA. */
export async function pixels(page, selector) {
  const target = selector ? await page.waitForSelector(selector) : page;
  return PNG.sync.read(Buffer.from(await target.screenshot({ type: "png" })));
}

/** Reads a PNG file, as pixels() gives it. */
export const readPicture = (file) => PNG.sync.read(fs.readFileSync(file));

/** Writes a picture to build/test/pictures/NAME.png, where people look when a test failed. Returns the path. */
export function keepPicture(name, picture) {
  const file = fileURLToPath(new URL(`../../build/test/pictures/${name}.png`, import.meta.url));
  fs.mkdirSync(path.dirname(file), { recursive: true });
  const png = new PNG({ width: picture.width, height: picture.height });
  Buffer.from(picture.data).copy(png.data);
  fs.writeFileSync(file, PNG.sync.write(png));
  return file;
}

/** Counts the pixels in which any of red, green and blue differs by more than `tolerance` of 255.
    Pictures of different sizes have no pixel in common: that is an error. */
export function differentPixels(one, other, tolerance = 0) {
  assert.deepEqual([one.width, one.height], [other.width, other.height], "the pictures are of different sizes");
  let count = 0;
  for (let i = 0; i < one.data.length; i += 4) {
    const off = [0, 1, 2].some((channel) => Math.abs(one.data[i + channel] - other.data[i + channel]) > tolerance);
    if (off) {
      ++count;
    }
  }
  return count;
}

/** Returns the colour [red, green, blue] of a pixel; y counts from the top. */
export function pixelAt(picture, x, y) {
  return [...picture.data.subarray((y * picture.width + x) * 4, (y * picture.width + x) * 4 + 3)];
}

/** Returns what WebGL says draws in this browser, and prints it: pictures depend on it. */
export async function printRenderer(page, name) {
  const renderer = await page.evaluate(() => {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) {
      return "no WebGL 2";
    }
    const extension = gl.getExtension("WEBGL_debug_renderer_info");
    const text = gl.getParameter(extension ? extension.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return text;
  });
  console.log(`${name} ${(await page.browser().version()).replace(/^.*\//, "")}: ${renderer}`);
  return renderer;
}
