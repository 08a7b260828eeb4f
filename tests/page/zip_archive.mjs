// Writes zip archives for tests, as different writers make them. (APPNOTE.TXT 6.3.10, 4.3 and 4.5.3)
import { deflateRawSync, gzipSync } from "node:zlib";

const STORED = 0;
const DEFLATED = 8;
const STREAMED = 1 << 3; // the flag that sizes and checksum stand behind the data
const UTF_8 = 1 << 11;
const NEEDS_64 = 45; // the version that reads ZIP64
const [SHORT, LONG] = [0xffff, 0xffffffff]; // stand where ZIP64 has the value elsewhere

/** Returns the bytes of numbers: [size in bytes, value] each, the lowest byte first. */
function bytesOf(...fields) {
  const bytes = Buffer.alloc(fields.reduce((sum, [size]) => sum + size, 0));
  let at = 0;
  for (const [size, value] of fields) {
    if (size === 8) {
      bytes.writeBigUInt64LE(BigInt(value), at);
    } else {
      bytes.writeUIntLE(value, at, size);
    }
    at += size;
  }
  return bytes;
}

const crcOf = (content) => gzipSync(content, { level: 0 }).subarray(-8).readUInt32LE(); // gzip ends with it
const extra64 = (...values) => bytesOf([2, 1], [2, 8 * values.length], ...values.map((value) => [8, value]));

/** Returns what stands in the archive at a place for one file: {local, data, descriptor, entry}. */
function parts(path, content, at, { stored, streamed, zip64 }) {
  const name = Buffer.from(path);
  const data = stored ? Buffer.from(content) : deflateRawSync(content);
  const [crc, packed, size] = [crcOf(content), data.length, content.length];
  const version = zip64 ? NEEDS_64 : 20;
  const common = [
    [2, version],
    [2, UTF_8 | (streamed ? STREAMED : 0)],
    [2, stored ? STORED : DEFLATED],
    [4, 0x21 << 16],
  ];
  const known = streamed ? [0, 0, 0] : [crc, packed, size];
  const localSizes = zip64 ? [LONG, LONG] : known.slice(1);
  const localExtra = zip64 ? extra64(known[2], known[1]) : Buffer.alloc(0);
  const entrySizes = zip64 ? [LONG, LONG] : [packed, size];
  const entryExtra = zip64 ? extra64(size, packed, at) : Buffer.alloc(0);
  const wide = zip64 ? 8 : 4;
  return {
    local: Buffer.concat([
      bytesOf(
        [4, 0x04034b50],
        ...common,
        [4, known[0]],
        ...localSizes.map((value) => [4, value]),
        [2, name.length],
        [2, localExtra.length],
      ),
      name,
      localExtra,
    ]),
    data,
    descriptor: streamed ? bytesOf([4, 0x08074b50], [4, crc], [wide, packed], [wide, size]) : Buffer.alloc(0),
    entry: Buffer.concat([
      bytesOf([4, 0x02014b50], [2, version], ...common, [4, crc], ...entrySizes.map((value) => [4, value])),
      bytesOf([2, name.length], [2, entryExtra.length], [2, 0], [2, 0], [2, 0], [4, 0], [4, zip64 ? LONG : at]),
      name,
      entryExtra,
    ]),
  };
}

/** Returns an archive of files: {path: bytes}.
    stored: the files are not packed. streamed: the writer could not go back, so that sizes and checksums stand behind
    each file and in the directory only. zip64: all sizes, places and counts are of 64 bits. comment: of the archive.
    start: where its first byte will stand in what it is put in. */
export function zipArchive(files, { stored = false, streamed = false, zip64 = false, comment = "", start = 0 } = {}) {
  const before = [];
  const entries = [];
  let at = start;
  for (const [path, content] of Object.entries(files)) {
    const { local, data, descriptor, entry } = parts(path, content, at, { stored, streamed, zip64 });
    before.push(local, data, descriptor);
    entries.push(entry);
    at += local.length + data.length + descriptor.length;
  }
  const directory = Buffer.concat(entries);
  const count = entries.length;
  const end64 = [
    bytesOf(
      [4, 0x06064b50],
      [8, 44],
      [2, NEEDS_64],
      [2, NEEDS_64],
      [4, 0],
      [4, 0],
      [8, count],
      [8, count],
      [8, directory.length],
      [8, at],
    ),
    bytesOf([4, 0x07064b50], [4, 0], [8, at + directory.length], [4, 1]),
  ];
  const counts = zip64 ? [SHORT, SHORT, LONG, LONG] : [count, count, directory.length, at];
  const end = bytesOf([4, 0x06054b50], [2, 0], [2, 0], ...counts.map((value, i) => [i < 2 ? 2 : 4, value]), [
    2,
    Buffer.byteLength(comment),
  ]);
  return new Uint8Array(Buffer.concat([...before, directory, ...(zip64 ? end64 : []), end, Buffer.from(comment)]));
}
