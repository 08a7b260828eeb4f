// Archives whose sizes do not fit into 32 bits, or stand behind the files: their list of files says it all.
import assert from "node:assert/strict";
import { test } from "node:test";
import { importWebModule } from "./web_module.mjs";
import { zipArchive } from "./zip_archive.mjs";

const { unzip } = await importWebModule("own_tank/unzip.js");

const GIGABYTE = 2 ** 30;
const LOCAL = 0x04034b50; // signatures
const ENTRY = 0x02014b50;
const END = 0x06054b50;
const END_64 = 0x06064b50;
const LOCATOR_64 = 0x07064b50;

const CONTENT = "v 0 0 0\n".repeat(5000);
const FILES = { "a.txt": Buffer.from("hello"), "tankbody.obj": Buffer.from(CONTENT) };
const STORED = { stored: true }; // so that nothing here depends on what Node.js unpacks
const ZIP_64 = zipArchive({ "tankbody.obj": Buffer.from(CONTENT) }, { ...STORED, zip64: true });
const IN_EXTRA = 46 + "tankbody.obj".length + 4; // of an entry of ZIP_64: size, packed size and place

/** Stands for a file of any size of which only some bytes are not 0. */
class HollowFile {
  constructor(at, bytes) {
    this.at = at;
    this.bytes = bytes;
    this.size = at + bytes.length;
  }

  slice(from, to) {
    const part = new Uint8Array(Math.min(to, this.size) - from);
    const [begin, end] = [Math.max(this.at, from), from + part.length];
    if (begin < end) {
      part.set(this.bytes.subarray(begin - this.at, end - this.at), begin - from);
    }
    return new Blob([part]);
  }
}

/** Unpacks the .obj files of an archive, and returns their texts. */
async function open(archive) {
  const files = await unzip(archive instanceof HollowFile ? archive : new Blob([archive]), {
    name: "a.zip",
    limitOf: (path) => (path.endsWith(".obj") ? 32 << 20 : 0),
    takeFromBudget: () => {},
  });
  return files.map(({ bytes }) => new TextDecoder().decode(bytes));
}

/** Returns where the first record with a signature begins. */
function placeOf(bytes, signature) {
  const view = new DataView(bytes.buffer);
  return bytes.findIndex((_, at) => at + 4 <= bytes.length && view.getUint32(at, true) === signature);
}

/** Returns the archive with a field of its first record with a signature changed, of 2, 4 or 8 bytes. */
function changed(bytes, signature, field, value, size = 8) {
  const copy = bytes.slice();
  const view = new DataView(copy.buffer);
  const at = placeOf(bytes, signature) + field;
  if (size === 8) {
    view.setBigUint64(at, BigInt(value), true);
  } else if (size === 4) {
    view.setUint32(at, value, true);
  } else {
    view.setUint16(at, value, true);
  }
  return copy;
}

for (const zip64 of [false, true]) {
  test(`an archive that was written as a stream is read, ${zip64 ? "with" : "without"} ZIP64`, async () => {
    const archive = zipArchive(FILES, { ...STORED, streamed: true, zip64 });
    const begin = new DataView(archive.buffer, placeOf(archive, LOCAL));
    const known = [begin.getUint32(14, true), ...(zip64 ? [] : [begin.getUint32(18, true), begin.getUint32(22, true)])];
    assert.ok(
      known.every((value) => value === 0),
      "checksum and sizes are not known yet where a file begins",
    );
    assert.deepEqual(await open(archive), [CONTENT]);
  });
}

test("a ZIP64 archive is read", async () => {
  const end = new DataView(ZIP_64.buffer, placeOf(ZIP_64, END));
  assert.deepEqual(
    [end.getUint16(10, true), end.getUint32(12, true), end.getUint32(16, true)],
    [0xffff, 0xffffffff, 0xffffffff],
  );
  assert.deepEqual(await open(ZIP_64), [CONTENT]);
});

test("a file that begins beyond 4 GB is found", async () => {
  const start = 5 * GIGABYTE;
  assert.deepEqual(await open(new HollowFile(start, zipArchive(FILES, { ...STORED, zip64: true, start }))), [CONTENT]);
});

/** Returns files of which only the last one is wanted. */
function manyFiles(count) {
  const others = Array.from({ length: count - 1 }, (_, i) => [`${i}.txt`, Buffer.alloc(0)]);
  return Object.fromEntries([...others, ["tankbody.obj", Buffer.from("v")]]);
}

test("of 65,535 files without ZIP64 the last one is found", async () => {
  assert.deepEqual(await open(zipArchive(manyFiles(65_535), STORED)), ["v"]);
});

test("of 70,000 files the last one is found, where ZIP64 has no more than their number", async () => {
  const archive = zipArchive(manyFiles(70_000), { ...STORED, zip64: true });
  const end64 = new DataView(archive.buffer, placeOf(archive, END_64));
  const withSize = changed(archive, END, 12, end64.getUint32(40, true), 4);
  assert.deepEqual(await open(changed(withSize, END, 16, end64.getUint32(48, true), 4)), ["v"]);
});

test("a list of files that is too long is not read", async () => {
  const end = changed(zipArchive({}), END, 12, 17 << 20, 4);
  await assert.rejects(
    open(new HollowFile(17 << 20, end)),
    /a\.zip is damaged: its list of files is not where it says/,
  );
});

const FAR = 2 ** 50;
const MISPLACED = /^Error: a\.zip is damaged: its list of files is not where it says/;
const BREAKS_OFF = /^Error: a\.zip is damaged: its list of files breaks off/;
for (const [name, archive, expected] of [
  ["the place of its end", changed(ZIP_64, LOCATOR_64, 8, FAR), MISPLACED],
  ["its end", changed(ZIP_64, END_64, 0, 0), MISPLACED],
  ["the place of its list", changed(ZIP_64, END_64, 48, FAR), MISPLACED],
  ["the size of its list", changed(ZIP_64, END_64, 40, FAR), MISPLACED],
  ["the number of its files", changed(ZIP_64, END_64, 32, FAR), BREAKS_OFF],
  ["the number of its parts", changed(ZIP_64, END_64, 16, 3, 4), /a\.zip is a part of an archive in several files/],
  ["the length of a file's sizes", changed(ZIP_64, ENTRY, IN_EXTRA - 2, 16, 2), BREAKS_OFF],
  ["the length of a file's extra fields", changed(ZIP_64, ENTRY, 30, 12, 2), BREAKS_OFF],
  [
    "the size of a file",
    changed(ZIP_64, ENTRY, IN_EXTRA, FAR),
    /tankbody\.obj in a\.zip has 1073741824 MB and at most 32 MB are read/,
  ],
  [
    "the packed size of a file",
    changed(ZIP_64, ENTRY, IN_EXTRA + 8, FAR),
    /tankbody\.obj in a\.zip is not where the archive says/,
  ],
  [
    "the place of a file",
    changed(ZIP_64, ENTRY, IN_EXTRA + 16, FAR),
    /tankbody\.obj in a\.zip is not where the archive says/,
  ],
  [
    "a file's size by a byte",
    changed(ZIP_64, ENTRY, IN_EXTRA, CONTENT.length - 1),
    /not as long as the archive says \(39999 bytes\)/,
  ],
  ["a checksum", changed(ZIP_64, ENTRY, 16, 1, 4), /tankbody\.obj in a\.zip is damaged: its checksum does not fit/],
]) {
  test(`what a ZIP64 archive has wrong is named: ${name}`, () => assert.rejects(open(archive), expected));
}
