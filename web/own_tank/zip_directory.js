// The list of files at the end of a zip archive, ZIP64 or not. Only there sizes and checksums are always right: who
// writes an archive as a stream does not know them yet where a file begins, and says them behind it.

const END = 0x06054b50; // signatures: APPNOTE.TXT 6.3.10, 4.3
const END_64 = 0x06064b50;
const LOCATOR_64 = 0x07064b50;
const ENTRY = 0x02014b50;
const LOCAL = 0x04034b50;
const END_SIZE = 22;
const END_64_SIZE = 56;
const LOCATOR_64_SIZE = 20;
const ENTRY_SIZE = 46;
const LOCAL_SIZE = 30;
const EXTRA_64 = 1; // 4.5.3
const STANDS_IN_64 = { short: 0xffff, long: 0xffffffff }; // what a field has whose value ZIP64 has elsewhere
const LONGEST_COMMENT = 0xffff;
const LARGEST_DIRECTORY = 16 << 20;

const viewOf = async (blob, from, to) => new DataView(await blob.slice(from, to).arrayBuffer());
const uint64 = (view, at) => Number(view.getBigUint64(at, true)); // beyond 2^53 not exact, and beyond any archive

const misplaced = (name) =>
  new Error(`${name} is damaged: its list of files is not where it says. Copy or download it again.`);
const breaksOff = (name) => new Error(`${name} is damaged: its list of files breaks off. Copy or download it again.`);

/** Reads what ZIP64 has beside the end record at a place: {disk, count, size, offset, at}, or null where it has nothing. */
async function readEnd64(blob, end, name) {
  const before = end - LOCATOR_64_SIZE;
  const locator = before >= 0 ? await viewOf(blob, before, end) : null;
  if (locator?.getUint32(0, true) !== LOCATOR_64) {
    return null;
  }
  const at = uint64(locator, 8);
  const record = at + END_64_SIZE <= before ? await viewOf(blob, at, at + END_64_SIZE) : null;
  if (record?.getUint32(0, true) !== END_64) {
    throw misplaced(name);
  }
  return {
    disk: record.getUint32(16, true),
    count: uint64(record, 32),
    size: uint64(record, 40),
    offset: uint64(record, 48),
    at,
  };
}

/** Finds the directory. Returns {count, offset, size}. */
async function findDirectory(blob, name) {
  const from = Math.max(0, blob.size - END_SIZE - LONGEST_COMMENT);
  const tail = await viewOf(blob, from, blob.size);
  for (let at = tail.byteLength - END_SIZE; at >= 0; --at) {
    if (tail.getUint32(at, true) !== END || at + END_SIZE + tail.getUint16(at + 20, true) > tail.byteLength) {
      continue;
    }
    const [disk, count] = [tail.getUint16(at + 4, true), tail.getUint16(at + 10, true)];
    const [size, offset] = [tail.getUint32(at + 12, true), tail.getUint32(at + 16, true)];
    const is64 = [disk, count].includes(STANDS_IN_64.short) || [size, offset].includes(STANDS_IN_64.long);
    const end = (is64 && (await readEnd64(blob, from + at, name))) || { disk, count, size, offset, at: from + at };
    if (end.disk !== 0) {
      throw new Error(`${name} is a part of an archive in several files; pack it as one.`);
    }
    if (end.offset + end.size > end.at || end.size > LARGEST_DIRECTORY) {
      throw misplaced(name);
    }
    return end;
  }
  const begins = blob.size >= 4 && (await viewOf(blob, 0, 4)).getUint32(0, true) === LOCAL;
  throw new Error(
    begins
      ? `${name} is cut short: the list of its files is missing. Copy or download it again.`
      : `${name} is no zip archive. Drop tankLab.zip, tankLOD.zip or the folder tankobjs.`,
  );
}

/** Takes the values of an entry that do not fit into 32 bits from its extra fields. Returns whether they are there. */
function take64(entry, view, from, to) {
  const wanted = ["size", "packed", "offset"].filter((key) => entry[key] === STANDS_IN_64.long);
  for (let at = from; wanted.length > 0 && at + 4 <= to; at += 4 + view.getUint16(at + 2, true)) {
    if (view.getUint16(at, true) !== EXTRA_64) {
      continue;
    }
    if (8 * wanted.length > view.getUint16(at + 2, true) || at + 4 + 8 * wanted.length > to) {
      return false;
    }
    wanted.forEach((key, i) => (entry[key] = uint64(view, at + 4 + 8 * i)));
    break;
  }
  return true; // or it is a file of 4 GB less a byte, which needs no ZIP64
}

/** Reads the directory of an archive: [{path, flags, method, crc, packed, size, offset}]. Throws an Error with a
    sentence. */
export async function readDirectory(blob, name) {
  const { count, offset, size } = await findDirectory(blob, name);
  const view = await viewOf(blob, offset, offset + size);
  const decoder = new TextDecoder();
  const entries = [];
  for (let at = 0, i = 0; i < count; ++i) {
    if (at + ENTRY_SIZE > size || view.getUint32(at, true) !== ENTRY) {
      throw breaksOff(name);
    }
    const [nameLength, extraLength, commentLength] = [28, 30, 32].map((field) => view.getUint16(at + field, true));
    const extra = at + ENTRY_SIZE + nameLength;
    if (extra + extraLength > size) {
      throw breaksOff(name);
    }
    const entry = {
      path: decoder.decode(new Uint8Array(view.buffer, at + ENTRY_SIZE, nameLength)),
      flags: view.getUint16(at + 8, true),
      method: view.getUint16(at + 10, true),
      crc: view.getUint32(at + 16, true),
      packed: view.getUint32(at + 20, true),
      size: view.getUint32(at + 24, true),
      offset: view.getUint32(at + 42, true),
    };
    if (!take64(entry, view, extra, extra + extraLength)) {
      throw breaksOff(name);
    }
    entries.push(entry);
    at = extra + extraLength + commentLength;
  }
  return entries;
}

/** Returns the packed content of an entry, or null where it is not in the archive. */
export async function contentOf(blob, { offset, packed }) {
  const local = offset + LOCAL_SIZE <= blob.size ? await viewOf(blob, offset, offset + LOCAL_SIZE) : null;
  if (local?.getUint32(0, true) !== LOCAL) {
    return null;
  }
  const begin = offset + LOCAL_SIZE + local.getUint16(26, true) + local.getUint16(28, true);
  return begin + packed <= blob.size ? blob.slice(begin, begin + packed) : null;
}
