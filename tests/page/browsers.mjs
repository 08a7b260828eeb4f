// The browsers that tests and benches drive, and how they are launched.
// The environment variables CHROME and FIREFOX name other browsers; TANKLAB_SITE another site than build/web.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import puppeteer from "puppeteer-core";

/** The browsers that tests run in, and what draws there:
    chromium          SwiftShader, Chromium's own software renderer
    chromium-mesa     Mesa's llvmpipe, which native tests draw with too
    firefox           Mesa's llvmpipe, in a window on a display of its own */
export const BROWSERS = ["chromium", "chromium-mesa", "firefox"];

export const SITE = process.env.TANKLAB_SITE ?? fileURLToPath(new URL("../../build/web", import.meta.url));

export const VIEWPORT = { width: 800, height: 600, deviceScaleFactor: 1 };
const LAUNCH_TIMEOUT = 60_000; // on two busy cores Firefox has taken 20 s

const CHROMIUM_FLAGS = [
  "--no-sandbox",
  "--disable-dev-shm-usage",
  "--ignore-gpu-blocklist",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--force-color-profile=srgb",
  "--hide-scrollbars",
];
const CHROMIUM_RENDERER = {
  chromium: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  "chromium-mesa": ["--use-angle=gl-egl"],
};
const FIREFOX_PREFERENCES = {
  "webgl.force-enabled": true,
  "app.update.enabled": false,
  "browser.shell.checkDefaultBrowser": false,
  "datareporting.policy.dataSubmissionEnabled": false,
  "gfx.color_management.mode": 0,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
};

function executable(fromEnvironment, names) {
  for (const name of [fromEnvironment, ...names].filter(Boolean)) {
    const found = spawnSync("sh", ["-c", 'command -v "$1"', "sh", name], { encoding: "utf8" }).stdout.trim();
    if (found) {
      return found;
    }
  }
  throw new Error(`none of these browsers is there: ${names.join(", ")}; scripts/setup test installs one`);
}

/** The oldest versions that puppeteer-core drives: Chromium's headless mode of today, WebDriver BiDi in Firefox. */
const OLDEST = { chromium: 112, firefox: 129 };

/** Says which browser cannot be driven, and why, where `program --version` tells of one that is too old. Gives what
    it tells. */
export function checkVersion(kind, program) {
  const told = spawnSync(program, ["--version"], { encoding: "utf8" }).stdout?.trim() ?? "";
  const major = Number(/(\d+)\.\d/.exec(told)?.[1]);
  if (major < OLDEST[kind]) {
    throw new Error(
      `${told} (${program}) is too old: the tests drive ${kind} ${OLDEST[kind]} and newer; name one in CHROME or FIREFOX`,
    );
  }
  return told;
}

/** Launches a browser, and where it does not start says which one it was. */
async function start(kind, program, options) {
  const told = checkVersion(kind, program);
  try {
    return await puppeteer.launch({
      executablePath: program,
      defaultViewport: VIEWPORT,
      timeout: LAUNCH_TIMEOUT,
      ...options,
    });
  } catch (error) {
    throw new Error(
      `${told} (${program}) does not start for puppeteer-core; one that is newer may want a newer puppeteer-core: ${error.message}`,
      { cause: error },
    );
  }
}

/** Starts an X display that nobody sees. Gives { name, stop() }. */
async function startDisplay() {
  const server = spawn("Xvfb", ["-displayfd", "3", "-screen", "0", "1600x1200x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  const [number] = await Promise.race([
    once(server.stdio[3], "data"),
    once(server, "exit").then(() => Promise.reject(new Error("Xvfb, the display for Firefox, does not start"))),
  ]);
  return { name: `:${String(number).trim()}`, stop: () => server.kill() };
}

/** Launches one of BROWSERS, with more Chromium flags if wanted. Gives puppeteer's browser; close it. */
export async function launch(name, { flags = [] } = {}) {
  if (name !== "firefox") {
    assert.ok(name in CHROMIUM_RENDERER, `no browser is called ${name}`);
    const program = executable(process.env.CHROME, [
      "chromium",
      "chromium-browser",
      "google-chrome",
      "google-chrome-stable",
    ]);
    return start("chromium", program, {
      headless: true,
      args: [...CHROMIUM_FLAGS, ...CHROMIUM_RENDERER[name], ...flags],
    });
  }
  const display = await startDisplay();
  // Firefox wants a home of its own: as root it refuses one that belongs to somebody else.
  const home = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-firefox-"));
  const cleanUp = () => {
    display.stop();
    fs.rmSync(home, { recursive: true, force: true, maxRetries: 5 });
  };
  try {
    const browser = await start("firefox", executable(process.env.FIREFOX, ["firefox", "firefox-esr"]), {
      browser: "firefox",
      headless: false,
      extraPrefsFirefox: FIREFOX_PREFERENCES,
      env: { ...process.env, DISPLAY: display.name, HOME: home, MOZ_CRASHREPORTER_DISABLE: "1" },
    });
    browser.process().once("exit", cleanUp);
    return browser;
  } catch (error) {
    cleanUp();
    throw error;
  }
}
