// Makes the page out of its parts.
//
//   node scripts/assemble-page.mjs --web DIR --assets DIR --program FILE/tanklab.js --out DIR
//
// Reads   web/index.html, the styles and modules it names, and whatever else lies in web/;
//         the models and pictures in assets/; tanklab.js and tanklab.wasm.
// Writes  a static site (relative addresses only, so that any path of any host serves it), and beside it
//         tanklab.html, the whole page in one file that opens without a server.
//
// What the page's author has to know:
// - index.html names its style by <link rel="stylesheet" href="style.css"> and its one entry module by
//   <script type="module" src="main.js">. Modules are bundled; each may import "tanklab", which
//   gives Emscripten's module factory (see scripts/cmake/WebPage.cmake), and must not await at top level.
// - The page finds what to load in an element that is put into the head:
//     <script type="application/json" id="tanklab-files">
//       {"program": {"name": "tanklab.wasm", "url": "tanklab.wasm?v=3f2a", "bytes": 123456},
//        "assets": [{"name": "tankbody.obj", "url": "assets/tankobjs/tankbody.obj?v=91bc", "bytes": 4711}]}
//   fetch(url) works in both forms of the page (in tanklab.html it is a data: address); bytes are what
//   arrives after decompression, for the progress bar. The bytes of the program go into the factory as
//   wasmBinary. The same list is written as files.json.
// - What a module names by import("...") is fetched when that is called: the site has it in later/, tanklab.html has it
//   inside.
import fs from "node:fs";
import path from "node:path";
import { createHash } from "node:crypto";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import esbuild from "esbuild";

const ASSET_TYPES = { ".obj": "text/plain", ".png": "image/png", ".jpg": "image/jpeg", ".tga": "image/x-tga" };
const TYPES = { ".svg": "image/svg+xml", ".png": "image/png", ".jpg": "image/jpeg", ".ico": "image/x-icon" };

const { values: given } = parseArgs({
  options: {
    web: { type: "string" },
    assets: { type: "string" },
    program: { type: "string" },
    out: { type: "string" },
  },
});
for (const name of ["web", "assets", "program", "out"]) {
  if (!given[name]) {
    stop([`--${name} is missing`]);
  }
}

function stop(messages) {
  for (const message of messages) {
    console.error(`assemble-page: ${message}`);
  }
  process.exit(2);
}

/** Returns the paths of all files below a folder, relative to it, sorted; none where there is no folder. */
function filesBelow(folder) {
  if (!fs.existsSync(folder)) {
    return [];
  }
  return fs
    .readdirSync(folder, { withFileTypes: true })
    .filter((entry) => !entry.name.startsWith("."))
    .flatMap((entry) =>
      entry.isDirectory()
        ? filesBelow(path.join(folder, entry.name)).map((file) => `${entry.name}/${file}`)
        : [entry.name],
    )
    .sort();
}

const local = (file) => path.join(given.web, file);
const versioned = (url, bytes) => `${url}?v=${createHash("sha256").update(bytes).digest("hex").slice(0, 8)}`;
const dataUrl = (type, bytes) => `data:${type};base64,${Buffer.from(bytes).toString("base64")}`;
const asJson = (value) => JSON.stringify(value).replaceAll("<", "\\u003c");

/** Bundles one module or style with all it imports. What a module imports only when it is needed stands in files of
    their own, unless inside is wanted. Gives [{file, content}], the paths those in the site, the entry first. */
async function bundle(file, inside) {
  const outdir = path.resolve(given.out);
  const result = await esbuild.build({
    absWorkingDir: path.resolve(given.web), // so that names with a hash are the same wherever this is built
    entryPoints: [file],
    outdir,
    outbase: ".",
    bundle: true,
    splitting: !inside && file.endsWith(".js"),
    chunkNames: "later/[name]-[hash]",
    minify: true,
    write: false,
    format: "esm",
    target: "es2022", // an older one brings helpers along, which the modules would share in a file of their own
    charset: "utf8",
    legalComments: "inline",
    logLevel: "warning",
    loader: { ".svg": "dataurl", ".png": "dataurl", ".woff2": "dataurl" },
    alias: { tanklab: path.resolve(given.program) },
  });
  const files = result.outputFiles.map((output) => ({
    file: path.relative(outdir, output.path).replaceAll(path.sep, "/"),
    content: Buffer.from(output.contents),
  }));
  return files.sort((one, other) => Number(other.file === file) - Number(one.file === file));
}

/** Replaces each match of a pattern by what an async function of the match returns. */
async function replaceEach(text, pattern, replacement) {
  let result = "";
  let end = 0;
  for (const match of text.matchAll(pattern)) {
    result += text.slice(end, match.index) + (await replacement(match));
    end = match.index + match[0].length;
  }
  return result + text.slice(end);
}

/** Makes a folder hold exactly the given files; what has not changed keeps its time.
    A folder with other things in it, which this never wrote, is left alone. */
function writeFolder(folder, files) {
  const before = filesBelow(folder);
  if (before.length > 0 && !before.includes("files.json")) {
    stop([`${folder} holds something else than a page`]);
  }
  for (const stale of before.filter((file) => !files.has(file))) {
    fs.rmSync(path.join(folder, stale));
  }
  for (const [file, content] of files) {
    const target = path.join(folder, file);
    const bytes = Buffer.from(content);
    if (fs.existsSync(target) && fs.readFileSync(target).equals(bytes)) {
      continue;
    }
    fs.mkdirSync(path.dirname(target), { recursive: true });
    fs.writeFileSync(target, bytes);
  }
}

const missing = [];
const site = new Map(); // path in the site → content

// --- The program and its files -------------------------------------------------------------------------

const wasmPath = given.program.replace(/\.js$/, ".wasm");
for (const file of [given.program, wasmPath]) {
  if (!fs.existsSync(file)) {
    stop([`${file} is missing: build the target tanklab first`]);
  }
}
const wasm = fs.readFileSync(wasmPath);
site.set("tanklab.wasm", wasm);

const assets = filesBelow(given.assets)
  .filter((file) => path.extname(file).toLowerCase() in ASSET_TYPES)
  .map((file) => ({ name: path.basename(file), file, bytes: fs.readFileSync(path.join(given.assets, file)) }));
if (assets.length === 0) {
  missing.push(`${given.assets} holds no models`);
}
for (const { file, bytes } of assets) {
  site.set(`assets/${file}`, bytes);
}

const describe = (address) => ({
  program: { name: "tanklab.wasm", url: address("tanklab.wasm", wasm, "application/wasm"), bytes: wasm.length },
  assets: assets.map(({ name, file, bytes }) => ({
    name,
    url: address(`assets/${file}`, bytes, ASSET_TYPES[path.extname(file).toLowerCase()]),
    bytes: bytes.length,
  })),
});
const filesOfSite = describe((file, bytes) => versioned(file, bytes));
const filesInside = describe((file, bytes, type) => dataUrl(type, bytes));

site.set("files.json", `${JSON.stringify(filesOfSite, null, 1)}\n`);

// --- The page ------------------------------------------------------------------------------------------

const attribute = (tag, name) => new RegExp(`\\s${name}="([^"]*)"`).exec(tag)?.[1];
const isLocal = (address) => address && !/^([a-z]+:|\/|#)/i.test(address);
const bundled = new Set(["index.html"]);

/** Bundles what a tag of index.html names and puts it into the site, unless it is to stand inside. Returns its content;
    null where it is not there. */
async function bundleNamed(file, inside) {
  if (!fs.existsSync(local(file))) {
    missing.push(`web/${file} is missing, which index.html names`);
    return null;
  }
  bundled.add(file);
  const files = await bundle(file, inside);
  if (!inside) {
    for (const { file: target, content } of files) {
      site.set(target, content);
    }
  }
  return files[0].content;
}

/** Returns index.html with its scripts and styles bundled; inside: all in the one file, else beside it. */
async function makeHtml(source, inside) {
  let html = await replaceEach(source, /<link\b[^>]*>/g, async ([tag]) => {
    const file = attribute(tag, "href");
    if (!isLocal(file)) {
      return tag;
    }
    if (attribute(tag, "rel") === "stylesheet") {
      const style = await bundleNamed(file, inside);
      if (!style) {
        return "";
      }
      if (inside) {
        return `<style>${style}</style>`;
      }
      return tag.replace(`"${file}"`, `"${versioned(file, style)}"`);
    }
    if (!inside || !fs.existsSync(local(file))) {
      return tag;
    }
    return tag.replace(
      `"${file}"`,
      `"${dataUrl(TYPES[path.extname(file)] ?? "text/plain", fs.readFileSync(local(file)))}"`,
    );
  });
  html = await replaceEach(html, /<script\b[^>]*\ssrc="[^"]*"[^>]*>\s*<\/script>/g, async ([tag]) => {
    const file = attribute(tag, "src");
    if (!isLocal(file)) {
      return tag;
    }
    const script = await bundleNamed(file, inside);
    if (!script) {
      return "";
    }
    if (inside) {
      return `<script type="module">${script}</script>`;
    }
    return tag.replace(`"${file}"`, `"${versioned(file, script)}"`);
  });
  if (inside) {
    html = await replaceEach(html, /<img\b[^>]*>/g, async ([tag]) => {
      const file = attribute(tag, "src");
      if (!isLocal(file) || !fs.existsSync(local(file))) {
        return tag;
      }
      return tag.replace(
        `"${file}"`,
        `"${dataUrl(TYPES[path.extname(file)] ?? "image/png", fs.readFileSync(local(file)))}"`,
      );
    });
  }
  const files = inside ? filesInside : filesOfSite;
  // Fetching starts before the script has arrived; the addresses are the ones that it will ask for.
  const early = inside
    ? ""
    : [files.program, ...files.assets]
        .map(({ url }) => `<link rel="preload" as="fetch" crossorigin href="${url}">\n`)
        .join("");
  const list = `${early}<script type="application/json" id="tanklab-files">${asJson(files)}</script>\n`;
  if (!html.includes("</head>")) {
    stop(["web/index.html has no </head> to put the list of files before"]);
  }
  return html.replace("</head>", () => `${list}</head>`);
}

if (fs.existsSync(local("index.html"))) {
  const source = fs.readFileSync(local("index.html"), "utf8");
  site.set("index.html", await makeHtml(source, false));
  site.set("tanklab.html", await makeHtml(source, true));
  for (const file of filesBelow(given.web)) {
    if (bundled.has(file) || [".js", ".mjs", ".ts", ".css", ".html", ".md"].includes(path.extname(file))) {
      continue;
    }
    site.set(file, fs.readFileSync(local(file)));
  }
} else {
  missing.push(`${local("index.html")} is missing`);
}

writeFolder(given.out, site);
const size = (bytes) => `${(bytes / 1024).toFixed(1)} KB`;
const script = Buffer.concat(
  [...site].filter(([file]) => file.endsWith(".js") && !file.startsWith("later/")).map(([, bytes]) => bytes),
);
for (const [name, bytes] of Object.entries({ program: wasm, script })) {
  const [plain, zipped] = [bytes, gzipSync(bytes, { level: 9 })].map(({ length }) => size(length).padStart(10));
  console.log(`${name.padEnd(8)} ${plain} ${zipped} gzipped`);
}
if (missing.length > 0) {
  stop([...new Set(missing)]);
}
