// Takes files out of a zip archive. Nothing that an archive says of itself is believed: what comes out is counted as it
// comes.
//
// The browser unpacks: zip.js would bring 23 KB gzipped for that, and every browser of the tests has deflate-raw.
import { contentOf, readDirectory } from "./zip_directory.js";

const STORED = 0;
const DEFLATED = 8;
const ENCRYPTED = 0x2041; // flags
const PIECE_BYTES = 1 << 14; // unpacks to 16 MB at the most

const megabytes = (bytes) => Math.max(1, Math.round(bytes / (1 << 20)));

const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; ++bit) {
    crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return crc;
});

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) {
    crc = CRC_TABLE[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  }
  return ~crc >>> 0;
}

/** Tells whether a path leads out of the folder that an archive would be unpacked in. */
const leadsOut = (path) => /^[/\\]|^[a-z]:/i.test(path) || path.split(/[/\\]/).includes("..");

/** Makes what unpacks. Not every browser has it that has WebGL 2. */
function inflater() {
  try {
    return new DecompressionStream("deflate-raw");
  } catch {
    throw new Error(
      "This browser cannot unpack archives. Unpack the archive yourself and drop the folder, or use a current Firefox, Chrome, Edge or Safari.",
    );
  }
}

/** Returns a stream of the content in small pieces, of which each is unpacked and counted before the next. */
function inPieces(content) {
  const cut = new TransformStream({
    transform(part, controller) {
      for (let from = 0; from < part.length; from += PIECE_BYTES) {
        controller.enqueue(part.subarray(from, from + PIECE_BYTES));
      }
    },
  });
  return content.stream().pipeThrough(cut);
}

/** Unpacks one entry, all of it or nothing. label: its name for people. */
async function unpack(blob, entry, { label, takeFromBudget, arrived }) {
  if (entry.flags & ENCRYPTED) {
    throw new Error(`${label} is encrypted. Unpack the archive with its password and drop the folder.`);
  }
  if (entry.method !== STORED && entry.method !== DEFLATED) {
    throw new Error(
      `${label} is packed in a way that is not read here (method ${entry.method}). Unpack the archive and drop the folder.`,
    );
  }
  const content = await contentOf(blob, entry);
  if (!content) {
    throw new Error(`${label} is not where the archive says: it is damaged. Copy or download it again.`);
  }

  const bytes = new Uint8Array(entry.size);
  let filled = 0;
  const lies = () =>
    new Error(
      `${label} is not as long as the archive says (${entry.size} bytes): it is damaged or made to do harm. Download it again from where you trust it.`,
    );
  const take = (part) => {
    if (filled + part.length > entry.size) {
      throw lies();
    }
    takeFromBudget(part.length);
    bytes.set(part, filled);
    filled += part.length;
    arrived(part.length);
  };
  const unpacked = entry.method === DEFLATED ? inPieces(content).pipeThrough(inflater()) : content.stream();
  const reader = unpacked.getReader();
  const next = () =>
    reader.read().catch((error) => {
      if (error instanceof DOMException) {
        throw error; // the archive itself cannot be read any more
      }
      throw new Error(`${label} cannot be unpacked (${error.message}): it is damaged. Copy or download it again.`);
    });
  try {
    for (let part = await next(); !part.done; part = await next()) {
      take(part.value);
    }
  } finally {
    reader.cancel().catch(() => {}); // what is left is not wanted any more
  }
  if (filled !== entry.size) {
    throw lies();
  }
  if (crc32(bytes) !== entry.crc) {
    throw new Error(`${label} is damaged: its checksum does not fit. Copy or download it again.`);
  }
  return bytes;
}

/** Unpacks the wanted files of an archive: [{name: path, bytes}]. Throws an Error with a sentence.
    name: of the archive. limitOf(path): how many bytes the file may have; 0 where it is not wanted.
    takeFromBudget(count): throws when that is too much in all. arrived(count): is told what was unpacked. */
export async function unzip(blob, { name, limitOf, takeFromBudget, arrived = () => {} }) {
  const entries = await readDirectory(blob, name);
  const out = entries.find(({ path }) => leadsOut(path));
  if (out) {
    throw new Error(
      `${name} holds the path “${out.path.slice(0, 80)}”, which leads out of it; an honest archive has none. Pack the files again, or drop the folder.`,
    );
  }
  const files = [];
  for (const entry of entries) {
    const limit = limitOf(entry.path);
    if (!limit) {
      continue;
    }
    const label = `${entry.path} in ${name}`;
    if (entry.size > limit) {
      throw new Error(
        `${label} has ${megabytes(entry.size)} MB and at most ${megabytes(limit)} MB are read; reduce it.`,
      );
    }
    files.push({ name: `${name}/${entry.path}`, bytes: await unpack(blob, entry, { label, takeFromBudget, arrived }) });
  }
  return files;
}
