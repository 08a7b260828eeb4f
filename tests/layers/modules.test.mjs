// The check of the JavaScript, seen to pass on a tree that obeys and to fail on one that does not.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { checkModules } from "./modules.mjs";

const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const SETTINGS = ["eslint.config.mjs", "tsconfig.json", "tsconfig.web.json", "package.json", ".editorconfig"];

const OBEYS = {
  "web/base/a.js": "export const a = 1;\n",
  "web/panels/b.js": 'import { a } from "../base/a.js";\n\nconsole.log(a, document.title);\n',
  "scripts/c.mjs": 'import fs from "node:fs";\n\nconsole.log(fs.readFileSync(process.argv[1], "utf8"));\n',
  "tests/page/d.mjs": "export const title = (page) => page.evaluate(() => document.title);\n",
};

/** Each breaks one rule: its content, and what is said of it.
    @type {Record<string, [string, ...RegExp[]]>} */
const VIOLATIONS = {
  "web/base/braces.js": ["export const f = (x) => {\n  if (x) return 1;\n  return 2;\n};\n", /Expected \{ after 'if'/],
  "web/base/equal.js": ["export const f = (x) => x == 1;\n", /Expected '==='/],
  "web/base/global.js": ["leaked = 1;\n", /'leaked' is not defined\. \(no-undef\)/, /Cannot find name 'leaked'/],
  "web/base/null.js": ['document.getElementById("a").remove();\n', /Object is possibly 'null'\. \(TS2531\)/],
  "web/base/room.js": ['import "../panels/b.js";\n', /base\/ does not know that room/],
  "web/base/node.js": ["console.log(process.argv);\n", /'process' is not defined/, /Cannot find name 'process'/],
  "web/base/unused.js": ["const a = 1;\n", /'a' is assigned a value but never used/],
  "scripts/layout.mjs": ["console.log('a');\n", /is not as prettier lays it out \(npm run lint:fix does it\)/],
  "tests/page/type.mjs": [
    "export const f = () => Math.abs('a');\n",
    /prettier/,
    /not assignable .* 'number'\. \(TS2345\)/,
  ],
};

let folder;
before(() => {
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-modules-"));
  for (const name of SETTINGS) {
    fs.copyFileSync(path.join(ROOT, name), path.join(folder, name));
  }
  fs.symlinkSync(path.join(ROOT, "node_modules"), path.join(folder, "node_modules"));
});
after(() => fs.rmSync(folder, { recursive: true }));

/** Puts files into the tree and checks them: {file: what is said of it, a line each}. */
async function violations(files, write) {
  for (const [file, content] of Object.entries(files)) {
    fs.mkdirSync(path.dirname(path.join(folder, file)), { recursive: true });
    fs.writeFileSync(path.join(folder, file), content);
  }
  const found = {};
  for (const { file, line, text } of await checkModules(folder, Object.keys(files), write)) {
    (found[file] ??= []).push(`${line}: ${text}`);
  }
  return found;
}

test("a tree that obeys has no violations", async () => {
  assert.deepEqual(await violations(OBEYS), {});
});

test("what breaks a rule is found, and nothing else; writing mends what can be", async () => {
  const broken = Object.fromEntries(Object.entries(VIOLATIONS).map(([file, [content]]) => [file, content]));
  const found = await violations({ ...OBEYS, ...broken });
  assert.deepEqual(Object.keys(found).sort(), Object.keys(VIOLATIONS).sort());
  for (const [file, [, ...expected]] of Object.entries(VIOLATIONS)) {
    assert.equal(found[file].length, expected.length, found[file].join("\n"));
    for (const pattern of expected) {
      assert.ok(
        found[file].some((said) => pattern.test(said)),
        `${file}: ${found[file]}`,
      );
    }
  }
  const left = await violations(broken, true);
  assert.ok(!("web/base/braces.js" in left || "scripts/layout.mjs" in left), JSON.stringify(left));
  assert.match(fs.readFileSync(path.join(folder, "web/base/braces.js"), "utf8"), /if \(x\) \{\n {4}return 1;\n {2}\}/);
});
