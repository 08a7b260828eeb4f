// What has to hold of unpacking, whatever an archive holds.
import { importWebModule } from "../page/web_module.mjs";
import { seedArchives } from "./archive_seeds.mjs";

const { unzip } = await importWebModule("own_tank/unzip.js");

const MEGABYTE = 1 << 20;
const LARGEST_FILE = MEGABYTE;
const BUDGET = 4 * MEGABYTE;
const MOST_MEMORY = 64 * MEGABYTE; // a list of files may have 16 MB
const LONGEST_SENTENCE = 1000;
const NAME = "a.zip";
const isWanted = (path) => /\.obj$/i.test(path);

// The checksum leaves nothing through but what was packed.
const textOf = (bytes) => Buffer.from(bytes).toString("latin1");
const packed = new Set(seedArchives().flatMap(({ entries }) => Object.values(entries).map(textOf)));

class Broken extends Error {}

/** Returns where an error comes from, without the text of the module that it comes from. */
const originOf = (error) =>
  String(error?.stack ?? error).replace(/data:text\/javascript;base64,[^:)]*/g, "unpacker.js");

function checkError(error) {
  const own =
    error instanceof Error &&
    !("code" in error) &&
    !/^(Type|Range|Reference|Syntax|URI|Eval)Error$/.test(error.constructor.name);
  if (!own) {
    throw new Broken(`an error that is not the unpacker's own: ${originOf(error)}`);
  }
  if (!/[.!?]$/.test(error.message) || !error.message.includes(NAME)) {
    throw new Broken(`no sentence that names the archive: ${error.message}`);
  }
  if (error.message.length > LONGEST_SENTENCE) {
    throw new Broken(`a sentence of ${error.message.length} characters`);
  }
}

function checkFile({ name, bytes }) {
  if (!name.startsWith(`${NAME}/`) || !isWanted(name)) {
    throw new Broken(`a file that was not wanted: ${name}`);
  }
  if (name.split(/[/\\]/).includes("..")) {
    throw new Broken(`a path that leads out: ${name}`);
  }
  if (bytes.length > LARGEST_FILE) {
    throw new Broken(`${name} has ${bytes.length} bytes, more than the limit`);
  }
  if (!packed.has(textOf(bytes))) {
    throw new Broken(`${name} has bytes that nobody packed`);
  }
}

/** Unpacks an archive of any bytes that damage made of seeds. Returns what came of it: {files} or {sentence}. Throws
    what does not hold. */
export async function check(bytes) {
  const before = process.memoryUsage().arrayBuffers;
  let taken = 0;
  const takeFromBudget = (count) => {
    taken += count;
    if (taken > BUDGET) {
      throw new Error(`${NAME} has too much in all.`);
    }
  };
  const result = {};
  try {
    result.files = await unzip(new Blob([bytes]), {
      name: NAME,
      limitOf: (path) => (isWanted(path) ? LARGEST_FILE : 0),
      takeFromBudget,
    });
  } catch (error) {
    checkError(error);
    result.sentence = error.message;
  }
  const memory = process.memoryUsage().arrayBuffers - before;
  if (memory > MOST_MEMORY) {
    throw new Broken(`${Math.round(memory / MEGABYTE)} MB of memory were used`);
  }
  result.files?.forEach(checkFile);
  return result;
}

/** Unpacks an archive that is whole. Throws where it gives anything else than it holds, or nothing. */
export async function checkWhole({ entries, bytes }) {
  const { files, sentence } = await check(bytes);
  if (!files) {
    throw new Broken(`a whole archive is refused: ${sentence}`);
  }
  const given = files.map((file) => [file.name, textOf(file.bytes)]);
  const expected = Object.entries(entries)
    .filter(([path]) => isWanted(path))
    .map(([path, content]) => [`${NAME}/${path}`, textOf(content)]);
  if (JSON.stringify(given) !== JSON.stringify(expected)) {
    throw new Broken("a whole archive gives something else than it holds");
  }
}
