// The panels in windows from a small phone's to a large screen's: nothing sticks out, nothing lies over another.
import assert from "node:assert/strict";
import { test } from "node:test";
import { keepPicture, pixels } from "./harness.mjs";
import { withTank } from "./tanklab_page.mjs";

const WINDOWS = [
  { width: 360, height: 640 },
  { width: 800, height: 600 },
  { width: 1280, height: 800 },
  { width: 3840, height: 2160 },
];
const PANELS = ["tasks", "hits", "keys", "values"];

/** Returns, as sentences, what sticks out of the window or of its panel, and what overlaps. Runs in the page. */
function faultsOfLayout() {
  const faults = [];
  const name = (element) =>
    `${element.tagName.toLowerCase()} "${(element.textContent || element.className).trim().slice(0, 40)}"`;
  const visible = (element) =>
    element.checkVisibility({ visibilityProperty: true }) && element.getBoundingClientRect().width > 0;
  const sticksOut = (inner, outer) => inner.left < outer.left - 1 || inner.right > outer.right + 1;
  const overlap = (a, b) =>
    Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
    Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1;

  const bars = [...document.querySelectorAll("header > *, section, footer p")].filter(visible);
  for (const bar of bars) {
    const box = bar.getBoundingClientRect();
    if (sticksOut(box, { left: 0, right: innerWidth }) || box.top < -1 || box.bottom > innerHeight + 1) {
      faults.push(`${name(bar)} sticks out of the window`);
    }
    for (const other of bars) {
      if (
        other !== bar &&
        !bar.contains(other) &&
        !other.contains(bar) &&
        overlap(box, other.getBoundingClientRect())
      ) {
        faults.push(`${name(bar)} lies over ${name(other)}`);
      }
    }
    for (const inner of bar.querySelectorAll("*")) {
      if (visible(inner) && sticksOut(inner.getBoundingClientRect(), box)) {
        faults.push(`${name(inner)} sticks out of ${name(bar)}`);
      }
    }
  }
  // Texts: each run of letters against its neighbours in the document.
  for (const section of document.querySelectorAll("section:not([hidden])")) {
    const runs = [];
    const walker = document.createTreeWalker(section, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const text = node.textContent.trim();
      if (!text || !visible(node.parentElement) || node.parentElement.closest("option, .overview")) {
        continue;
      }
      const range = document.createRange();
      range.selectNodeContents(node);
      for (const box of range.getClientRects()) {
        runs.push({ box, text: text.slice(0, 40) });
      }
    }
    for (let i = 0; i < runs.length; ++i) {
      for (let j = i + 1; j < Math.min(i + 8, runs.length); ++j) {
        if (overlap(runs[i].box, { ...runs[j].box.toJSON(), top: runs[j].box.top + 2 })) {
          faults.push(`“${runs[i].text}” lies over “${runs[j].text}”`);
        }
      }
    }
  }
  return faults;
}

for (const viewport of WINDOWS) {
  test(`no panel sticks out or lies over another in ${viewport.width} x ${viewport.height}`, async () => {
    await withTank("chromium", { viewport, path: "#task=2.5" }, async ({ page }) => {
      for (const panel of PANELS) {
        await page.evaluate(
          (id) => document.getElementById(id).hidden && document.querySelector(`[data-panel="${id}"]`).click(),
          panel,
        );
        await page.waitForSelector(`#${panel}:not([hidden])`);
        await page.evaluate(() => document.querySelectorAll(".group").forEach((group) => (group.open = true)));
        await page.waitForFunction((id) => id !== "hits" || document.querySelector("#hits .level"), {}, panel);
        const faults = await page.evaluate(faultsOfLayout);
        if (faults.length > 0) {
          keepPicture(`panel-${panel}-${viewport.width}`, await pixels(page));
        }
        assert.deepEqual(faults, [], panel);
      }
    });
  });
}

test("whatever Tab comes to can be seen to have the focus", async () => {
  await withTank("chromium", { viewport: { width: 1280, height: 800 }, path: "#task=2.5" }, async ({ page }) => {
    for (const panel of ["tasks", "keys", "values"]) {
      await page.evaluate(
        (id) => document.getElementById(id).hidden && document.querySelector(`[data-panel="${id}"]`).click(),
        panel,
      );
      await page.focus(`[data-panel="${panel}"]`);
      const seen = new Set();
      for (let i = 0; i < 45; ++i) {
        await page.keyboard.press("Tab");
        const { key, shown } = await page.evaluate(() => {
          const target = document.activeElement;
          const ring = (element, pseudo) => {
            const { outlineStyle, outlineWidth } = getComputedStyle(element, pseudo);
            return outlineStyle !== "none" && parseFloat(outlineWidth) >= 1;
          };
          const isRadio = target.type === "radio";
          return {
            key: `${target.tagName} ${target.className} ${target.type ?? ""}`,
            shown:
              target === document.body ||
              target.id === "canvas" ||
              target.type === "range" || // its thumb has the ring, which styles do not tell
              ring(isRadio ? target.nextSibling : target),
          };
        });
        seen.add(key);
        assert.ok(shown, `${key} in ${panel}`);
      }
      assert.ok(seen.size >= 3, [...seen].join());
    }
  });
});

test("values are found by name, changed by keyboard and brought back", async () => {
  await withTank("chromium", { viewport: { width: 1280, height: 800 } }, async ({ page, state }) => {
    await page.click('[data-panel="values"]');
    const shown = () =>
      page.$$eval("#values .value", (rows) =>
        rows.filter((row) => row.checkVisibility()).map((row) => row.dataset.field),
      );
    await page.focus("#values .search");
    await page.keyboard.type("thresh");
    assert.deepEqual(await shown(), ["threshold"]);
    await page.focus("#value-threshold");
    await page.keyboard.down("Control");
    await page.keyboard.press("KeyA");
    await page.keyboard.up("Control");
    await page.keyboard.type("42.5");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => tanklab.state().threshold === 42.5);
    await page.waitForFunction(() => location.hash.includes("threshold=42.5"));
    await page.focus("#values .search");
    await page.keyboard.press("Escape");
    assert.equal(await page.$eval("#values .search", (search) => search.value), "");
    assert.ok(!(await shown()).includes("threshold"), "its group is folded again");
    const headings = await page.$$eval("#values h2", (all) => all.map((one) => one.textContent));
    assert.ok(headings.includes("Level of detail · 1 changed"), headings.join());
    const every = await page.evaluate(() =>
      tanklab
        .commands()
        .filter((c) => c.kind === "set" && c.fields.length === 1)
        .map((c) => c.name)
        .sort(),
    );
    assert.deepEqual(await page.$$eval("#values .value", (rows) => rows.map((row) => row.dataset.field).sort()), every);
    assert.equal((await state()).threshold, 42.5);
  });
});

test("a phone shows what is hit in a panel like the others", async () => {
  await withTank(
    "chromium",
    { viewport: { width: 390, height: 844, isMobile: true, hasTouch: true }, path: "#task=2.4" },
    async ({ page }) => {
      const open = () => page.$$eval("section:not([hidden])", (panels) => panels.map((panel) => panel.id));
      assert.deepEqual(await open(), ["tasks"]);
      await page.tap('[data-panel="hits"]');
      assert.deepEqual(await open(), ["hits"]);
      await page.tap('[data-panel="hits"]');
      assert.deepEqual(await open(), []);
    },
  );
});
