// Files that people drop on the page or choose: which of them make a tank, and their bytes.
import { importLater } from "./later.js";

const MOST_FILES = 10_000;
const DEEPEST_FOLDER = 12;
const MOST_BYTES = 256 << 20; // of all files, unpacked
const MEGABYTE = 1 << 20;

export const baseName = (path) => path.split(/[/\\]/).at(-1).toLowerCase();
const isMacJunk = (path) => /(^|[/\\])(__MACOSX[/\\]|\._)/i.test(path);
const isZip = (path) => /\.zip$/i.test(path) && !isMacJunk(path);
const megabytes = (bytes) => Math.max(1, Math.round(bytes / MEGABYTE));

const tooMany = () => new Error(`There are more than ${MOST_FILES.toLocaleString("en")} files. Drop the folder tankobjs itself, or tankLab.zip.`);

async function walk(entry, path, depth, found) {
  if (entry.isFile) {
    if (found.length >= MOST_FILES) throw tooMany();
    found.push({ path, file: await new Promise((done, fail) => entry.file(done, fail)) });
    return;
  }
  if (depth > DEEPEST_FOLDER) return;
  const reader = entry.createReader();
  for (;;) {
    const some = await new Promise((done, fail) => reader.readEntries(done, fail)); // never all at once
    if (some.length === 0) return;
    for (const inner of some) await walk(inner, `${path}/${inner.name}`, depth + 1, found);
  }
}

/** Returns the files of a drop, those in folders with them: [{path, file}]. Call it within the event: the
    browser forgets what was dropped when it is over. */
export function droppedFiles(transfer) {
  const dropped = [...transfer.items]
    .filter((item) => item.kind === "file")
    .map((item) => ({ entry: item.webkitGetAsEntry?.(), file: item.getAsFile() }));
  return (async () => {
    const found = [];
    for (const { entry, file } of dropped) {
      try {
        if (entry) await walk(entry, entry.name, 0, found);
        else if (file) found.push({ path: file.name, file });
      } catch (error) {
        if (!(error instanceof DOMException)) throw error;
        throw new Error(`${entry.name} cannot be read: ${error.message.replace(/\.?$/, ".")} Drop it again, or choose it with the button.`);
      }
    }
    return found;
  })();
}

/** Returns the files that were chosen: [{path, file}]. */
export function chosenFiles(list) {
  if (list.length > MOST_FILES) throw tooMany();
  return [...list].map((file) => ({ path: file.webkitRelativePath || file.name, file }));
}

async function readFile(path, file, arrived) {
  const parts = [];
  try {
    const reader = file.stream().getReader();
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      parts.push(part.value);
      arrived(part.value.length);
    }
  } catch (error) {
    throw new Error(`${path} cannot be read (${error.message}). Is it still there? Drop it again.`);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** Reads what of the files belongs to a tank, out of archives, too: [{name, bytes}]. manifest: see
    Program.assetManifest. show(sentence): is told what is going on. Throws an Error with a sentence. */
export async function readTankFiles(found, manifest, show) {
  const limits = new Map([
    ...manifest.meshes.map((name) => [name.toLowerCase(), manifest.largest_mesh]),
    ...manifest.texture.map((name) => [name.toLowerCase(), manifest.largest_texture]),
  ]);
  const limitOf = (path) => (isMacJunk(path) ? 0 : (limits.get(baseName(path)) ?? 0));
  let left = MOST_BYTES;
  const takeFromBudget = (count) => {
    left -= count;
    if (left < 0) throw new Error(`The files come to more than ${megabytes(MOST_BYTES)} MB unpacked, more than a tank needs. Reduce them.`);
  };
  const wanted = found.filter(({ path }) => limitOf(path) > 0 || isZip(path));
  for (const { path, file } of wanted) {
    const limit = limitOf(path);
    if (limit && file.size > limit) throw new Error(`${path} has ${megabytes(file.size)} MB and at most ${megabytes(limit)} MB are read; reduce the number of its polygons or pixels.`);
  }
  const files = [];
  for (const { path, file } of wanted) {
    let read = 0;
    const arrived = (count) => {
      read += count;
      show(`Reading ${path}: ${(read / MEGABYTE).toFixed(1)} MB`);
    };
    if (isZip(path)) {
      const { unzip } = await importLater("unzip");
      files.push(...(await unzip(file, { name: path, limitOf, takeFromBudget, arrived })));
    } else {
      takeFromBudget(file.size);
      files.push({ name: path, bytes: await readFile(path, file, arrived) });
    }
  }
  if (files.length === 0) {
    const what = found.length === 1 ? `${found[0].path} holds` : "The files dropped hold";
    throw new Error(`${what} nothing of a tank. Drop tankLab.zip, tankLOD.zip, the folder tankobjs or its files, such as ${manifest.meshes[0]}.`);
  }
  return files;
}
