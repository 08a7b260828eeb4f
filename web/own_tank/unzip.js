/*! Unpacks with fflate, © 2020 Arjun Barrett and contributors, MIT licence, https://github.com/101arrowz/fflate */
// Takes files out of a zip archive. Nothing that an archive says of itself
// is believed: what comes out is counted as it comes.
import { Inflate } from "fflate";

const END = 0x06054b50; // signatures: APPNOTE.TXT 6.3.10, 4.3
const ENTRY = 0x02014b50;
const LOCAL = 0x04034b50;
const END_SIZE = 22;
const LONGEST_COMMENT = 0xffff;
const LARGEST_DIRECTORY = 16 << 20;
const STORED = 0;
const DEFLATED = 8;
const READ_BYTES = 1 << 18; // of the archive at a time; the page stays alive in between
const PUSH_BYTES = 1 << 14; // unpacks to 16 MB at the most

const megabytes = (bytes) => Math.max(1, Math.round(bytes / (1 << 20)));
const viewOf = async (blob, from, to) => new DataView(await blob.slice(from, to).arrayBuffer());

const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) crc = CRC_TABLE[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  return ~crc >>> 0;
}

/** Finds the directory. Returns {count, offset, size}. */
async function findDirectory(blob, name) {
  const from = Math.max(0, blob.size - END_SIZE - LONGEST_COMMENT);
  const tail = await viewOf(blob, from, blob.size);
  for (let at = tail.byteLength - END_SIZE; at >= 0; --at) {
    if (tail.getUint32(at, true) !== END || at + END_SIZE + tail.getUint16(at + 20, true) > tail.byteLength) continue;
    const [count, size, offset] = [tail.getUint16(at + 10, true), tail.getUint32(at + 12, true), tail.getUint32(at + 16, true)];
    if (tail.getUint16(at + 4, true) !== 0) throw new Error(`${name} is a part of an archive in several files; pack it as one.`);
    if (count === 0xffff || offset === 0xffffffff) throw new Error(`${name} is a ZIP64 archive, which is not read here; unpack it and drop the folder.`);
    if (offset + size > from + at || size > LARGEST_DIRECTORY) throw new Error(`${name} is damaged: its list of files is not where it says. Copy or download it again.`);
    return { count, offset, size };
  }
  const begins = blob.size >= 4 && (await viewOf(blob, 0, 4)).getUint32(0, true) === LOCAL;
  throw new Error(
    begins ? `${name} is cut short: the list of its files is missing. Copy or download it again.` : `${name} is no zip archive. Drop tankLab.zip, tankLOD.zip or the folder tankobjs.`,
  );
}

/** Reads the directory: [{path, flags, method, crc, packed, size, offset}]. */
async function readDirectory(blob, name) {
  const { count, offset, size } = await findDirectory(blob, name);
  const view = await viewOf(blob, offset, offset + size);
  const decoder = new TextDecoder();
  const entries = [];
  for (let at = 0, i = 0; i < count; ++i) {
    if (at + 46 > size || view.getUint32(at, true) !== ENTRY) throw new Error(`${name} is damaged: its list of files breaks off. Copy or download it again.`);
    const [nameLength, extraLength, commentLength] = [28, 30, 32].map((field) => view.getUint16(at + field, true));
    const end = at + 46 + nameLength;
    if (end > size) throw new Error(`${name} is damaged: its list of files breaks off. Copy or download it again.`);
    entries.push({
      path: decoder.decode(new Uint8Array(view.buffer, at + 46, nameLength)),
      flags: view.getUint16(at + 8, true),
      method: view.getUint16(at + 10, true),
      crc: view.getUint32(at + 16, true),
      packed: view.getUint32(at + 20, true),
      size: view.getUint32(at + 24, true),
      offset: view.getUint32(at + 42, true),
    });
    at = end + extraLength + commentLength;
  }
  return entries;
}

/** Tells whether a path leads out of the folder that an archive would be unpacked in. */
const leadsOut = (path) => /^[/\\]|^[a-z]:/i.test(path) || path.split(/[/\\]/).includes("..");

/** Unpacks one entry, all of it or nothing. label: its name for people. */
async function unpack(blob, entry, { label, takeFromBudget, arrived }) {
  if (entry.flags & 0x2041) throw new Error(`${label} is encrypted. Unpack the archive with its password and drop the folder.`);
  if (entry.method !== STORED && entry.method !== DEFLATED) {
    throw new Error(`${label} is packed in a way that is not read here (method ${entry.method}). Unpack the archive and drop the folder.`);
  }
  const local = entry.offset + 30 <= blob.size ? await viewOf(blob, entry.offset, entry.offset + 30) : null;
  const begin = local?.getUint32(0, true) === LOCAL ? entry.offset + 30 + local.getUint16(26, true) + local.getUint16(28, true) : NaN;
  if (!(begin + entry.packed <= blob.size)) throw new Error(`${label} is not where the archive says: it is damaged. Copy or download it again.`);

  const bytes = new Uint8Array(entry.size);
  let filled = 0;
  const lies = () => new Error(`${label} is not as long as the archive says (${entry.size} bytes): it is damaged or made to do harm. Download it again from where you trust it.`);
  const take = (chunk) => {
    if (filled + chunk.length > entry.size) throw lies();
    takeFromBudget(chunk.length);
    bytes.set(chunk, filled);
    filled += chunk.length;
    arrived(chunk.length);
  };
  const inflate = entry.method === DEFLATED ? new Inflate(take) : null;
  for (let at = 0; at < entry.packed; at += READ_BYTES) {
    const part = new Uint8Array(await blob.slice(begin + at, begin + Math.min(entry.packed, at + READ_BYTES)).arrayBuffer());
    for (let from = 0; from < part.length; from += PUSH_BYTES) {
      const piece = part.subarray(from, from + PUSH_BYTES);
      if (!inflate) {
        take(piece);
        continue;
      }
      try {
        inflate.push(piece, at + from + piece.length >= entry.packed);
      } catch (error) {
        // fflate's own errors have a code; ours are sentences already.
        throw error?.code === undefined ? error : new Error(`${label} cannot be unpacked (${error.message}): it is damaged. Copy or download it again.`);
      }
    }
  }
  if (filled !== entry.size) throw lies();
  if (crc32(bytes) !== entry.crc) throw new Error(`${label} is damaged: its checksum does not fit. Copy or download it again.`);
  return bytes;
}

/** Unpacks the wanted files of an archive: [{name: path, bytes}]. Throws an Error with a sentence.
    name: of the archive. limitOf(path): how many bytes the file may have; 0 where it is not wanted.
    takeFromBudget(count): throws when that is too much in all. arrived(count): is told what was unpacked. */
export async function unzip(blob, { name, limitOf, takeFromBudget, arrived = () => {} }) {
  const entries = await readDirectory(blob, name);
  const out = entries.find(({ path }) => leadsOut(path));
  if (out) throw new Error(`${name} holds the path “${out.path.slice(0, 80)}”, which leads out of it; an honest archive has none. Pack the files again, or drop the folder.`);
  const files = [];
  for (const entry of entries) {
    const limit = limitOf(entry.path);
    if (!limit) continue;
    const label = `${entry.path} in ${name}`;
    if (entry.size > limit) throw new Error(`${label} has ${megabytes(entry.size)} MB and at most ${megabytes(limit)} MB are read; reduce it.`);
    files.push({ name: `${name}/${entry.path}`, bytes: await unpack(blob, entry, { label, takeFromBudget, arrived }) });
  }
  return files;
}
