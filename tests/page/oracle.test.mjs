// The oracle's scenes through legacygl as WebAssembly, held against the pictures that the native build draws.
// The native program draws them anew for each run, so that no picture is an old one.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { spawnSync } from "node:child_process";
import { after, before, test } from "node:test";
import { keepPicture, printRenderer, withPage } from "./harness.mjs";

const drawer = path.join(process.env.TANKLAB_NATIVE, "tests/oracle/oracle_emulated");

let folder;
before(() => {
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-oracle-"));
  const done = spawnSync(drawer, [folder], { encoding: "utf8" });
  assert.equal(done.status, 0, `${drawer}: ${done.error ?? done.stderr}`);
});
after(() => fs.rmSync(folder, { recursive: true }));

/** Counts the pixels in which a channel is off by more than `tolerance`. */
function pixelsOff(one, other, tolerance) {
  assert.equal(one.length, other.length, "the pictures are of different sizes");
  let count = 0;
  for (let i = 0; i < one.length; i += 4) {
    if ([0, 1, 2, 3].some((channel) => Math.abs(one[i + channel] - other[i + channel]) > tolerance)) {
      ++count;
    }
  }
  return count;
}

/** Gives a scene's bytes as keepPicture wants them. Pictures are as wide as four thirds of their height, or 640. */
function topFirst(rgba) {
  const width = rgba.length === 640 * 400 * 4 ? 640 : 160;
  const row = width * 4;
  const rows = Array.from({ length: rgba.length / row }, (_, y) => rgba.subarray(y * row, (y + 1) * row));
  return { width, height: rows.length, data: Buffer.concat(rows.reverse()) };
}

/** Gives the first line that two texts do not share, as a list of at most one sentence. */
function firstOther(text, reference) {
  const [lines, expected] = [text, reference].map((each) => each.split("\n"));
  const at = lines.findIndex((line, i) => line !== expected[i]);
  return at < 0 && lines.length === expected.length ? [] : [`tells '${lines.at(at)}' instead of '${expected.at(at)}'`];
}

/** Draws every scene in a browser and holds it to the native picture. shareOf gives by a scene's name which share
    of all pixels may be off by more than `tolerance`. exceptions names scenes in which it may be some more, and
    how many; one that no scene needs any more fails, too. What scenes tell beside their pictures is to be the same
    but for those of tellsOther, which tell of the renderer itself. */
async function compare(browser, tolerance, shareOf, exceptions = {}, tellsOther = []) {
  await withPage(browser, { folder: process.env.TANKLAB_ORACLE_PAGE }, async ({ page, problems }) => {
    await printRenderer(page, browser);
    await page.waitForFunction("window.drawScene");
    const names = await page.evaluate("sceneNames()");
    const native = fs.readdirSync(folder).filter((file) => file.endsWith(".rgba"));
    assert.deepEqual(
      [...names].sort(),
      native.map((file) => file.replace(".rgba", "")).sort(),
      "the builds have other scenes",
    );
    const failures = Object.keys(exceptions)
      .filter((name) => !names.includes(name))
      .map((name) => `${name}: there is no such scene`);
    let same = 0;
    for (const [index, name] of names.entries()) {
      const { problem, told, pixels } = await page.evaluate((i) => drawScene(i), index);
      const reference = fs.readFileSync(path.join(folder, `${name}.rgba`));
      const picture = Buffer.from(pixels, "base64");
      if (problem) {
        failures.push(`${name}: ${problem}`);
      }
      if (!tellsOther.includes(name)) {
        failures.push(
          ...firstOther(told, fs.readFileSync(path.join(folder, `${name}.txt`), "utf8")).map(
            (line) => `${name} ${line}`,
          ),
        );
      }
      if (picture.equals(reference)) {
        ++same;
      }
      const usual = (shareOf(name) * reference.length) / 4;
      const count = pixelsOff(picture, reference, tolerance);
      if (count > (exceptions[name] ?? usual)) {
        failures.push(`${name}: ${count} pixels differ by more than ${tolerance}`);
        keepPicture(`oracle-${name}-${browser}`, topFirst(picture));
        keepPicture(`oracle-${name}-native`, topFirst(reference));
      }
      if (name in exceptions && count <= usual) {
        failures.push(`${name} needs no exception any more`);
      }
    }
    console.log(`${browser}: ${same} of ${names.length} scenes are the native ones to the byte`);
    assert.deepEqual(failures, []);
    assert.deepEqual(problems, []);
  });
}

// Firefox draws lines of one pixel only: wider ones come as triangles, whose colours differ by a few of 255.
const IN_FIREFOX = { polygon_mode_wide_lines: 178 };

test("Chromium on Mesa draws every scene as the native build does, to the byte", () =>
  compare("chromium-mesa", 0, () => 0));
test("Firefox draws every scene as the native build does, to the byte", () =>
  compare("firefox", 0, () => 0, IN_FIREFOX));

// Where SwiftShader rasterises otherwise than Mesa, in pixels. A line lies a pixel beside Mesa's:
const LINES = {
  glu_sphere_line: 206,
  glu_sphere_silhouette: 167,
  glu_cylinder_line: 155,
  glu_cylinder_silhouette: 145,
  glu_disk_line: 126,
  glu_disk_silhouette: 66,
  glu_partial_disk_line: 78,
  glu_partial_disk_silhouette: 48,
  clipped_wireframe_shows_the_cut: 134,
  polygon_mode_cut_by_the_view_volume: 87,
  polygon_mode_fogged_and_textured: 63,
  polygon_mode_from_a_list: 57,
  polygon_mode_front_lines_back_points_clockwise: 61,
  polygon_mode_lights_two_sides: 152,
  polygon_mode_line_with_culled_front_faces: 64,
  polygon_mode_lit_flat_torus: 323,
  polygon_mode_lit_torus: 50,
  polygon_stipple_leaves_lines_and_points_alone: 173,
  smooth_lines_blended: 139,
  smooth_stippled_lines: 41,
  smooth_wide_lines_blended: 72,
};
// A pixel whose centre lies on the edge between two texels shows the other one:
const TEXEL_EDGES = {
  texture_nearest: 40,
  texture_unpacking: 409,
  texture_changed_between_draws: 140,
  texture_client_formats_and_types: 1195,
  texture_coordinates_of_no_vertex: 452, // the column at the right, whose coordinates are interpolated
  texture_copies: 101,
  texture_internal_formats: 907,
  texture_packed_types: 576,
  texture_sub_images: 300,
};
// So does one on the edge of a triangle, of which a small picture of many small things has many:
const OUTLINES = { glu_sphere_fill: 67, glu_cylinder_fill: 53, glu_disk_fill: 42, glu_partial_disks_of_all_angles: 42 };

// The program's own scenes stand on the ground, whose grid is all lines, and lines lie a pixel beside Mesa's: how
// many pixels that is depends on the model, so that it is no number of a scene but a share. pictures.test.mjs holds
// the tank without the grid.
const ON_THE_GRID = /^(task|figure|particles|program|tank|view|shadow)_/;

// Depths of another rasteriser, and limits.
const OF_THE_RENDERER = [
  "depths_are_read_in_every_type",
  "unproject_what_the_depth_says_is_under_the_pointer",
  "viewport_is_cut_to_the_greatest",
  "limits_and_ranges",
];

test("SwiftShader draws every scene within the design's bound, and what stands on the ground's grid within ten times it", () =>
  compare(
    "chromium",
    8,
    (name) => (ON_THE_GRID.test(name) ? 0.02 : 0.002),
    { ...LINES, ...TEXEL_EDGES, ...OUTLINES },
    OF_THE_RENDERER,
  ));
