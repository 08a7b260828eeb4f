// Checks of the source tree that no compiler makes: which folder includes which, who calls OpenGL, the layout of the
// code, the rules and types of what is JavaScript, and that no file names a package registry's host.
//
//   node tests/layers/checks.mjs layers|format|hosts|modules [ROOT] [--write]
//
// --write has `format` and `modules` mend what can be, rather than say where that is due.
// Prints each violation as FILE:LINE: TEXT; the exit status is 1 where there is one, 2 where a check
// cannot be made.
import fs from "node:fs";
import path from "node:path";
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { checkLayout } from "./layout.mjs";
import { checkModules } from "./modules.mjs";

const THE_FIVE = ["mesh", "tank", "collision", "particles", "lod"];
const BELOW_APP = ["assets", "image", ...THE_FIVE, "base"];

/** What each folder of src/ may include besides itself, GLM and the standard library.
    folders: other folders of src/; headers: others', as a pattern of what stands between < and >;
    floors: its rooms from the ground up, "." being the folder itself: a room may include those of lower floors. */
const LAYERS = {
  base: { folders: [] },
  image: { folders: ["base"], headers: /^stb\/stb_image\.h$/ },
  mesh: { folders: ["base"], headers: /^fast_float\/fast_float\.h$/ },
  tank: { folders: ["base"] },
  collision: { folders: ["base"] },
  particles: { folders: ["base"] },
  lod: { folders: ["base"] },
  assets: { folders: ["base", "image", ...THE_FIVE] },
  app: { folders: BELOW_APP, floors: [["state"], ["links", "view"], ["commands"], ["simulation"], ["report"]] },
  legacygl: {
    folders: [],
    headers: /^(GL\/glu?\.h|legacygl\/legacygl\.h)$/,
    floors: [
      ["vertex", "glu"],
      ["backend"],
      ["state", "list"],
      ["shader"],
      ["cpu_pipeline"],
      ["draw"],
      ["context"],
      ["pixel"],
      ["entry"],
    ],
  },
  scene: {
    folders: ["app", ...BELOW_APP],
    headers: /^GL\/glu?\.h$/,
    floors: [["drawing"], ["tank", "markers", "particles"], ["surroundings"], ["."]],
  },
  checks: { folders: ["app", "legacygl", "scene", ...BELOW_APP], headers: /^legacygl\/legacygl\.h$/ },
  platform: {
    folders: ["app", "checks", "legacygl", "scene", ...BELOW_APP],
    headers: /./,
    floors: [["input", "files"], ["program"], ["offscreen", "desktop", "web"]],
  },
};

const STANDARD_OR_GLM = /^([a-z_0-9]+|(stddef|stdint|math|string|stdlib|stdio|assert|float|limits)\.h|glm\/.+)$/;
const ES_HEADER = /^(GLES[23]\/.+|webgl\/.+|emscripten\/html5_webgl\.h)$/;
const MAY_INCLUDE_ES = /^src\/legacygl\/backend\/es3_\w+\.(h|cpp)$/;
const PUBLIC_HEADER = /^src\/legacygl\/include\//;
const MAY_CALL_GL = /^src\/(scene|legacygl)\//;
const GL_CALL = /(?<![\w.>])(?<!::)(?:::)?(glu?[A-Z]\w*)\s*\(/g;
const CODE = /\.(c|h|cpp)$/;

// In pieces, so that this file names none.
const HOSTS = [
  ["registry", "npmjs", "org"],
  ["registry", "yarnpkg", "com"],
  ["unpkg", "com"],
  ["cdn", "jsdelivr", "net"],
  ["deb", "debian", "org"],
  ["security", "debian", "org"],
  ["archive", "ubuntu", "com"],
  ["security", "ubuntu", "com"],
  ["pypi", "org"],
  ["files", "pythonhosted", "org"],
  ["crates", "io"],
  ["proxy", "golang", "org"],
].map((labels) => labels.join("."));

/** Returns the tree's files that are committed or about to be, relative to the root; without git, all. */
export function sourceFiles(root) {
  const git = spawnSync("git", ["-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"], {
    encoding: "utf8",
  });
  if (git.status === 0) {
    return git.stdout
      .split("\0")
      .filter((file) => file && fs.existsSync(path.join(root, file)))
      .sort();
  }
  const below = (folder) =>
    fs.readdirSync(path.join(root, folder), { withFileTypes: true }).flatMap((entry) => {
      const file = path.posix.join(folder, entry.name);
      if (entry.isDirectory()) {
        return [".git", "build", "node_modules"].includes(entry.name) ? [] : below(file);
      }
      return entry.isFile() ? [file] : [];
    });
  return below(".").sort();
}

/** Returns C or C++ text with comments and what strings hold turned into spaces; lines stay where they are. */
export function withoutComments(text) {
  const pattern = /\/\/[^\n]*|\/\*[\s\S]*?\*\/|R"([^(\s]*)\([\s\S]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'/g;
  return text.replace(pattern, (match, delimiter, at) => {
    const lineStart = text.lastIndexOf("\n", at) + 1;
    const isInclude = match.startsWith('"') && /^\s*#\s*include\s*$/.test(text.slice(lineStart, at));
    return isInclude ? match : match.replace(/[^\n]/g, " ");
  });
}

/** Returns the floor of a file of a folder that has floors, or -1 where no floor has its room. */
function floorOf(floors, file) {
  const rooms = file.split("/").slice(1, -1);
  return floors.findIndex((floor) => floor.includes(rooms[0] ?? "."));
}

function violationsOfFloors(file, folder, target) {
  const { floors } = LAYERS[folder];
  if (!floors) {
    return [];
  }
  const [room, other] = [file.slice("src/".length), target].map((name) => path.posix.dirname(name));
  if (room === other || floorOf(floors, target) < floorOf(floors, file.slice("src/".length))) {
    return [];
  }
  return [`${room}/ may not include ${other}/ ("${target}")`];
}

function violationsOfInclude(file, folder, include) {
  const [, quote, target] = include;
  const rule = LAYERS[folder];
  if (quote === '"') {
    const other = target.split("/")[0];
    if (!target.includes("/") || !(other in LAYERS)) {
      return [`"${target}" is not rooted at src/`];
    }
    if (other === folder) {
      return violationsOfFloors(file, folder, target);
    }
    if (rule.folders.includes(other)) {
      return [];
    }
    return [`${folder}/ may not include ${other}/ ("${target}")`];
  }
  if (ES_HEADER.test(target)) {
    return MAY_INCLUDE_ES.test(file) ? [] : [`<${target}>: only src/legacygl/backend/es3_* includes OpenGL ES`];
  }
  if (STANDARD_OR_GLM.test(target) || rule.headers?.test(target)) {
    return [];
  }
  return [`${folder}/ may not include <${target}>`];
}

/** Returns the violations of the table of layers: {file, line, text}. */
export function checkLayers(root) {
  const violations = [];
  for (const file of sourceFiles(root).filter((name) => name.startsWith("src/") && CODE.test(name))) {
    const folder = file.split("/")[1];
    if (!(folder in LAYERS)) {
      violations.push({ file, line: 1, text: `the table of layers does not know src/${folder}/` });
      continue;
    }
    const { floors } = LAYERS[folder];
    if (floors && floorOf(floors, file.slice("src/".length)) < 0 && !PUBLIC_HEADER.test(file)) {
      violations.push({ file, line: 1, text: `no floor of src/${folder}/ has the room of this file` });
      continue;
    }
    const lines = withoutComments(fs.readFileSync(path.join(root, file), "utf8")).split("\n");
    lines.forEach((content, index) => {
      const found = [];
      const include = /^\s*#\s*include\s*(["<])([^">]+)[">]/.exec(content);
      if (include) {
        found.push(...violationsOfInclude(file, folder, include));
      }
      if (!MAY_CALL_GL.test(file)) {
        for (const [, name] of content.matchAll(GL_CALL)) {
          found.push(`only scene/ and legacygl/ call OpenGL (${name})`);
        }
      }
      for (const text of found) {
        violations.push({ file, line: index + 1, text });
      }
    });
  }
  return violations;
}

/** Returns where a text file names the host of a package registry. */
export function checkHosts(root) {
  const violations = [];
  for (const file of sourceFiles(root)) {
    const full = path.join(root, file);
    if (!fs.statSync(full).isFile() || fs.statSync(full).size > 4e6) {
      continue;
    }
    const text = fs.readFileSync(full, "latin1").toLowerCase();
    for (const host of HOSTS) {
      for (let at = text.indexOf(host); at >= 0; at = text.indexOf(host, at + 1)) {
        violations.push({
          file,
          line: text.slice(0, at).split("\n").length,
          text: `names a registry's host (${host})`,
        });
      }
    }
  }
  return violations;
}

/** Returns where code is not laid out as .clang-format says; with `write`, lays it out so first.
    The clang-format is npm's, so that every system has the same one: versions differ in how they lay code out.
    Its API is used and not its program, which does not see files below /tmp. */
export async function checkFormat(root, write = false) {
  const files = sourceFiles(root).filter((file) => CODE.test(file));
  if (files.length === 0) {
    return [];
  }
  const { format } = await import("@wasm-fmt/clang-format").catch((error) => {
    throw new Error(`clang-format does not start (${error.message}); scripts/setup web installs it`);
  });
  const style = fs.readFileSync(path.join(root, ".clang-format"), "utf8");
  const how = { program: "clang-format", command: "checks.mjs format --write", write };
  return checkLayout(root, files, (text, file) => format(text, file, style), how);
}

const CHECKS = {
  layers: checkLayers,
  format: checkFormat,
  hosts: checkHosts,
  modules: (root, write) => checkModules(root, sourceFiles(root), write),
};

if (process.argv[1] && fs.realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const write = process.argv.includes("--write");
  const [name, root = fileURLToPath(new URL("../..", import.meta.url))] = process.argv
    .slice(2)
    .filter((given) => given !== "--write");
  if (!(name in CHECKS)) {
    console.error(`checks: there is no check '${name}': ${Object.keys(CHECKS).join(", ")}`);
    process.exit(2);
  }
  try {
    const violations = await CHECKS[name](root, write);
    for (const { file, line, text } of violations) {
      console.log(`${file}:${line}: ${text}`);
    }
    console.log(violations.length === 0 ? `${name}: nothing to object` : `${name}: ${violations.length} violations`);
    process.exitCode = violations.length === 0 ? 0 : 1;
  } catch (error) {
    console.error(`checks: ${error.message}`);
    process.exitCode = 2;
  }
}
