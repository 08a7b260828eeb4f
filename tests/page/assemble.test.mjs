// Putting the page together: what becomes of web/, assets/ and the program, and what is said of what lacks.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const SCRIPT = fileURLToPath(new URL("../../scripts/assemble-page.mjs", import.meta.url));

const PARTS = {
  "program/tanklab.js": "export default async function create(given) { return given; }\n",
  "program/tanklab.wasm": "\0asm",
  "assets/tankobjs/tankbody.obj": "v 0 0 0\n",
  "assets/texture.png": "picture",
  "assets/notes.txt": "not for the page",
  "web/index.html":
    '<html><head><link rel="icon" href="icon.svg"><link rel="stylesheet" href="style.css"></head>' +
    '<body><script type="module" src="main.js"></script></body></html>',
  "web/icon.svg": "<svg/>",
  "web/types.d.ts": "declare const nothing: null;",
  "web/style.css": "body { color: red; }\n",
  "web/main.js": 'import create from "tanklab";\nimport { text } from "./other.js";\nconsole.log(create, text);\n',
  "web/other.js": 'export const text = "</script>";\n',
};

/** Assembles these parts (path → content; null: leave it out) in a new folder.
    Gives { status, errors, read(file), files } of the site to a function. */
function assemble(changes, use) {
  const root = fs.mkdtempSync(path.join(os.tmpdir(), "tanklab-assemble-"));
  try {
    for (const [file, content] of Object.entries({ ...PARTS, ...changes })) {
      if (content === null) {
        continue;
      }
      fs.mkdirSync(path.dirname(path.join(root, file)), { recursive: true });
      fs.writeFileSync(path.join(root, file), content);
    }
    const at = (name) => path.join(root, name);
    const run = () =>
      spawnSync(
        process.execPath,
        [
          SCRIPT,
          "--web",
          at("web"),
          "--assets",
          at("assets"),
          "--program",
          at("program/tanklab.js"),
          "--out",
          at("site"),
        ],
        { encoding: "utf8" },
      );
    const { status, stderr } = run();
    const files = fs.existsSync(at("site")) ? fs.readdirSync(at("site"), { recursive: true }).map(String) : [];
    return use({
      status,
      errors: stderr,
      files,
      run,
      root,
      read: (file) => fs.readFileSync(at(`site/${file}`), "utf8"),
    });
  } finally {
    fs.rmSync(root, { recursive: true });
  }
}

const filesIn = (html) =>
  JSON.parse(/<script type="application\/json" id="tanklab-files">(.*?)<\/script>/s.exec(html)[1]);

test("the site's addresses are relative and change with the content", () => {
  assemble({}, ({ status, errors, read }) => {
    assert.equal(status, 0, errors);
    const html = read("index.html");
    const { program, assets } = filesIn(html);
    assert.deepEqual([program.name, program.bytes], ["tanklab.wasm", 4]);
    assert.match(program.url, /^tanklab\.wasm\?v=[0-9a-f]{8}$/);
    assert.deepEqual(
      assets.map(({ name, bytes }) => [name, bytes]),
      [
        ["tankbody.obj", 8],
        ["texture.png", 7],
      ],
    );
    assert.match(assets[0].url, /^assets\/tankobjs\/tankbody\.obj\?v=/);
    assert.match(html, /href="style\.css\?v=[0-9a-f]{8}"/);
    assert.match(html, /src="main\.js\?v=[0-9a-f]{8}"/);
    assert.deepEqual(JSON.parse(read("files.json")), filesIn(html));
    assemble({ "assets/tankobjs/tankbody.obj": "v 1 0 0\n" }, (other) => {
      assert.notEqual(filesIn(other.read("index.html")).assets[0].url, assets[0].url);
      assert.equal(filesIn(other.read("index.html")).program.url, program.url);
    });
  });
});

test("the one file refers to nothing, and its script does not end early", () => {
  assemble({}, ({ read }) => {
    const html = read("tanklab.html");
    assert.doesNotMatch(html, /(src|href)="(?!data:)/);
    const { program, assets } = filesIn(html);
    assert.equal(program.url, `data:application/wasm;base64,${Buffer.from("\0asm").toString("base64")}`);
    assert.equal(assets[1].url, `data:image/png;base64,${Buffer.from("picture").toString("base64")}`);
    const [, script] = /<script type="module">(.*?)<\/script>/s.exec(html);
    assert.match(script, /console\.log/);
  });
});

test("modules and other files end up where they belong, notes and sources nowhere", () => {
  assemble({}, ({ files }) => {
    for (const file of ["main.js", "icon.svg", "style.css", "tanklab.wasm", "assets/texture.png"]) {
      assert.ok(files.includes(file), file);
    }
    for (const file of ["other.js", "tanklab.js", "types.d.ts", "assets/notes.txt"]) {
      assert.ok(!files.includes(file), file);
    }
  });
});

const SPLIT = {
  "package.json": '{ "type": "module" }',
  "web/main.js":
    'globalThis.load = () => import("./room/rarely.js").then(({ text }) => text);\nconsole.log("first");\n',
  "web/room/rarely.js": 'import { text as other } from "../other.js";\nexport const text = `seldom ${other}`;\n',
};
const SELDOM = /seldom/;

/** Returns what a module prints that has run, and then what its load() gives. */
function runModule(code, folder) {
  const { stdout, stderr } = spawnSync(
    process.execPath,
    ["--input-type=module", "--eval", `${code}\nconsole.log(await load());`],
    { cwd: folder, encoding: "utf8" },
  );
  return stdout || stderr;
}

test("what is imported only when it is needed is a file of its own, and found from any folder", () => {
  assemble(SPLIT, ({ files, read, root }) => {
    const [later, ...more] = files.filter((file) => /^later\/.*\.js$/.test(file));
    assert.match(later, /^later\/rarely-[0-9A-Z]{8}\.js$/);
    assert.deepEqual(more, []);
    assert.doesNotMatch(read("main.js"), SELDOM);
    assert.match(read(later), SELDOM);
    fs.renameSync(path.join(root, "site"), path.join(root, "else where"));
    assert.equal(runModule('await import("./else where/main.js?v=1");', root), "first\nseldom </script>\n");
    assemble(SPLIT, (again) => assert.ok(again.files.includes(later), "its name is the same wherever it is made"));
    assemble({ ...SPLIT, "web/other.js": 'export const text = "changed";\n' }, (other) => {
      assert.ok(!other.files.includes(later), "its name changes with its content");
      assert.notEqual(other.read("main.js"), fs.readFileSync(path.join(root, "else where/main.js"), "utf8"));
    });
  });
});

test("the one file holds what is imported only when it is needed", () => {
  assemble(SPLIT, ({ read, root }) => {
    const [, script] = /<script type="module">(.*?)<\/script>/s.exec(read("tanklab.html"));
    fs.rmSync(path.join(root, "site"), { recursive: true });
    assert.equal(runModule(script, root), "first\nseldom </script>\n");
  });
});

test("a second run changes no file, and what is gone from the parts goes from the site", () => {
  assemble({}, ({ run, root }) => {
    const style = path.join(root, "site/style.css");
    fs.utimesSync(style, 1000, 1000);
    fs.rmSync(path.join(root, "assets/texture.png"));
    assert.equal(run().status, 0);
    assert.equal(fs.statSync(style).mtimeMs, 1000 * 1000);
    assert.ok(!fs.existsSync(path.join(root, "site/assets/texture.png")));
  });
});

/** @type {[string, Record<string, string | null>, RegExp][]} */
const LACKING = [
  ["index.html", { "web/index.html": null }, /web\/index\.html is missing/],
  ["a style that index.html names", { "web/style.css": null }, /web\/style\.css is missing, which index\.html names/],
  ["the script that index.html names", { "web/main.js": null }, /web\/main\.js is missing, which index\.html names/],
  ["a module that another imports", { "web/other.js": null }, /Could not resolve "\.\/other\.js"/],
  ["the program", { "program/tanklab.wasm": null }, /tanklab\.wasm is missing: build the target tanklab first/],
  ["models", { "assets/tankobjs/tankbody.obj": null, "assets/texture.png": null }, /assets holds no models/],
  ["a head in index.html", { "web/index.html": "<p>" }, /no <\/head>/],
];
for (const [name, changes, complaint] of LACKING) {
  test(`what lacks is named: ${name}`, () => {
    assemble(changes, ({ status, errors }) => {
      assert.notEqual(status, 0);
      assert.match(errors, complaint);
    });
  });
}

test("a folder with other things in it is left alone", () => {
  assemble({ "site/mine.txt": "mine" }, ({ status, errors, files }) => {
    assert.equal(status, 2);
    assert.match(errors, /holds something else than a page/);
    assert.deepEqual(files, ["mine.txt"]);
  });
});
