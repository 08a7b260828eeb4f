// The checks of the source tree, each seen to pass on a tree that obeys and to fail on one that does not.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { spawnSync } from "node:child_process";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { checkFormat, checkHosts, checkLayers, withoutComments } from "./checks.mjs";

const SCRIPT = fileURLToPath(new URL("checks.mjs", import.meta.url));

const folders = [];
after(() => folders.forEach((folder) => fs.rmSync(folder, { recursive: true })));

/** Lays out files (path → content) in a new folder, which goes when the tests end, and hands it to a function. */
function withTree(files, use) {
  const root = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-layers-"));
  folders.push(root);
  for (const [file, content] of Object.entries(files)) {
    fs.mkdirSync(path.dirname(path.join(root, file)), { recursive: true });
    fs.writeFileSync(path.join(root, file), content);
  }
  return use(root);
}

const violations = (check, files) =>
  withTree(files, (root) => check(root).map(({ file, line, text }) => `${file}:${line}: ${text}`));

const OBEYS = {
  "src/mesh/a.cpp":
    '#include "mesh/a.h"\n#include <vector>\n#include <glm/glm.hpp>\n#include <fast_float/fast_float.h>\n',
  "src/tank/a.h": "#pragma once\n#include <cmath>\n/// The matrix of glRotate(angle, axis).\n",
  "src/app/commands/a.cpp":
    '#include "tank/a.h"\n#include "mesh/a.h"\n#include "lod/b.h"\n#include "app/state/a.h"\n#include "app/commands/b.h"\n',
  "src/legacygl/backend/es3_functions.cpp": "#include <GLES3/gl3.h>\n",
  "src/legacygl/entry/a.cpp": "#include <GL/gl.h>\nvoid f() { glEnable(1); }\n",
  "src/scene/a.cpp": '#include "app/a.h"\n#include <GL/glu.h>\nvoid f() { glEnd(); gluLookAt(); }\n',
  "src/platform/web/a.cpp": '#include "legacygl/a.h"\n#include "scene/a.h"\n#include <SDL.h>\nauto s = "glEnd()";\n',
};

test("a tree that obeys the table of layers has no violations", () => {
  assert.deepEqual(violations(checkLayers, OBEYS), []);
});

/** What is wrong, and how: the file, its line, and what is said.
    @type {Record<string, [string, string, RegExp]>} */
const VIOLATIONS = {
  "one of the five includes another": [
    "src/collision/a.cpp",
    '#include "mesh/a.h"',
    /collision\/ may not include mesh\//,
  ],
  "a lower layer includes a higher one": ["src/tank/a.cpp", '#include "app/a.h"', /tank\/ may not include app\//],
  "legacygl knows of tanks": ["src/legacygl/draw/a.cpp", '#include "tank/a.h"', /legacygl\/ may not include tank\//],
  "scene knows which renderer it has": [
    "src/scene/a.cpp",
    '#include "legacygl/a.h"',
    /scene\/ may not include legacygl\//,
  ],
  "an include is not rooted at src/": ["src/app/state/a.cpp", '#include "b.h"', /not rooted at src/],
  "app includes OpenGL": ["src/app/state/a.cpp", "#include <GL/gl.h>", /app\/ may not include <GL\/gl\.h>/],
  "scene includes SDL": ["src/scene/a.cpp", "#include <SDL.h>", /may not include <SDL\.h>/],
  "a file of legacygl outside its backend includes OpenGL ES": [
    "src/legacygl/draw/a.cpp",
    "#include <GLES3/gl3.h>",
    /only src\/legacygl\/backend/,
  ],
  "platform includes WebGL": ["src/platform/web/a.cpp", "#include <webgl/webgl1.h>", /only src\/legacygl\/backend/],
  "platform calls OpenGL": ["src/platform/web/a.cpp", "void f() { glFlush(); }", /\(glFlush\)/],
  "app calls GLU, globally qualified": ["src/app/state/a.cpp", "void f() { ::gluLookAt (1); }", /\(gluLookAt\)/],
  "a folder is in no table": ["src/sound/a.cpp", "", /does not know src\/sound\//],
  "a room includes one of a higher floor": [
    "src/app/state/a.cpp",
    '#include "app/commands/a.h"',
    /app\/state\/ may not include app\/commands\//,
  ],
  "a room includes another of its floor": [
    "src/legacygl/list/a.cpp",
    '#include "legacygl/state/a.h"',
    /legacygl\/list\/ may not include legacygl\/state\//,
  ],
  "a file lies beside the rooms of its folder": ["src/app/b.cpp", "", /no floor of src\/app\/ has the room/],
  "a folder has a room that is on no floor": ["src/app/attic/b.cpp", "", /no floor of src\/app\/ has the room/],
};
for (const [name, [file, line, expected]] of Object.entries(VIOLATIONS)) {
  test(`a violation is found: ${name}`, () => {
    const found = violations(checkLayers, { ...OBEYS, [file]: `// first\n${line}\n` });
    assert.equal(found.length, 1, found.join("\n"));
    assert.match(found[0], expected);
    assert.ok(found[0].startsWith(`${file}:`), found[0]);
  });
}

test("comments and strings are no code, whatever they hold", () => {
  const kept = withoutComments(
    'a /* glEnd() \n */ b // glEnd()\n"glEnd()" \'"\' c R"x(glEnd() ")x" d\n#include "mesh/a.h"\n',
  );
  assert.equal(kept.replace(/[ ]+/g, " "), 'a \n b \n c d\n#include "mesh/a.h"\n');
});

test("a member function whose name begins with gl is no call of OpenGL", () => {
  assert.deepEqual(
    violations(checkLayers, { "src/app/state/a.cpp": "void f() { a.glX(); b->glY(); C::glZ(); }\n" }),
    [],
  );
});

test("a registry's host is found in any file, in any case", () => {
  const host = ["Registry", "npmjs", "org"].join(".");
  const found = violations(checkHosts, {
    "a.txt": "nothing\n",
    "package-lock.json": `{\n "resolved": "https://${host}/x"\n}`,
  });
  assert.equal(found.length, 1);
  assert.match(found[0], /^package-lock\.json:2: /);
});

test("code that clang-format would change is found, and only that; writing lays it out", () =>
  withTree(
    { ".clang-format": "BasedOnStyle: LLVM\n", "src/a.cpp": "int a;\n", "src/b.cpp": "int a;\nint  b ;\n" },
    async (root) => {
      const found = await checkFormat(root);
      assert.deepEqual(
        found.map(({ file, line }) => `${file}:${line}`),
        ["src/b.cpp:2"],
      );
      assert.deepEqual(await checkFormat(root, true), []);
      assert.deepEqual(await checkFormat(root), []);
      assert.equal(fs.readFileSync(path.join(root, "src/b.cpp"), "utf8"), "int a;\nint b;\n");
    },
  ));

test("the exit status is 1 for violations, 0 for none, 2 for a check that is not known", () => {
  const run = (check, files) => withTree(files, (root) => spawnSync(process.execPath, [SCRIPT, check, root]).status);
  assert.equal(run("layers", { ...OBEYS, "src/app/state/z.cpp": '#include "scene/a.h"\n' }), 1);
  assert.equal(run("layers", OBEYS), 0);
  assert.equal(run("nonsense", OBEYS), 2);
});
