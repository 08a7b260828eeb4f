// Which of many files make a tank, and their bytes.

const MOST_BYTES = 256 << 20; // of all files, unpacked
const MEGABYTE = 1 << 20;

export const baseName = (path) => path.split(/[/\\]/).at(-1).toLowerCase();
const isMacJunk = (path) => /(^|[/\\])(__MACOSX[/\\]|\._)/i.test(path);
const isZip = (path) => /\.zip$/i.test(path) && !isMacJunk(path);
const megabytes = (bytes) => Math.max(1, Math.round(bytes / MEGABYTE));

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

/** Fetches what unpacks archives, which few people need. */
async function fetchUnzip() {
  try {
    return (await import("./unzip.js")).unzip;
  } catch {
    // Firefox keeps the failure until the page is reloaded.
    throw new Error(
      "The part of the page that unpacks archives did not arrive. Check your connection and reload the page, or unpack the archive and drop the folder.",
    );
  }
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
    if (left < 0) {
      throw new Error(
        `The files come to more than ${megabytes(MOST_BYTES)} MB unpacked, more than a tank needs. Reduce them.`,
      );
    }
  };
  const wanted = found.filter(({ path }) => limitOf(path) > 0 || isZip(path));
  for (const { path, file } of wanted) {
    const limit = limitOf(path);
    if (limit && file.size > limit) {
      throw new Error(
        `${path} has ${megabytes(file.size)} MB and at most ${megabytes(limit)} MB are read; reduce the number of its polygons or pixels.`,
      );
    }
  }
  const files = [];
  for (const { path, file } of wanted) {
    let read = 0;
    const arrived = (count) => {
      read += count;
      show(`Reading ${path}: ${(read / MEGABYTE).toFixed(1)} MB`);
    };
    if (isZip(path)) {
      const unzip = await fetchUnzip();
      files.push(...(await unzip(file, { name: path, limitOf, takeFromBudget, arrived })));
    } else {
      takeFromBudget(file.size);
      files.push({ name: path, bytes: await readFile(path, file, arrived) });
    }
  }
  if (files.length === 0) {
    const what = found.length === 1 ? `${found[0].path} holds` : "The files dropped hold";
    throw new Error(
      `${what} nothing of a tank. Drop tankLab.zip, tankLOD.zip, the folder tankobjs or its files, such as ${manifest.meshes[0]}.`,
    );
  }
  return files;
}
