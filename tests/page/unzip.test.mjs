// Unpacking, without a browser: what an archive says of itself is not believed.
import assert from "node:assert/strict";
import { test } from "node:test";
import { inflateRawSync } from "node:zlib";
import { importWebModule } from "./web_module.mjs";
import { zipArchive } from "./zip_archive.mjs";

const { unzip } = await importWebModule("own_tank/unzip.js");

// Node.js has had deflate-raw since 20.12, and the browsers for longer.
try {
  new DecompressionStream("deflate-raw");
} catch {
  globalThis.DecompressionStream = class extends TransformStream {
    constructor() {
      const parts = [];
      super({
        transform: (part) => void parts.push(part),
        flush: (controller) => controller.enqueue(inflateRawSync(Buffer.concat(parts))),
      });
    }
  };
}

const MEGABYTE = 1 << 20;
const text = (words) => new TextEncoder().encode(words);

/** Unpacks the .obj files of an archive. */
function open(bytes, { limit = 32 * MEGABYTE, budget = 256 * MEGABYTE } = {}) {
  let left = budget;
  return unzip(bytes.size === undefined ? new Blob([bytes]) : bytes, {
    name: "a.zip",
    limitOf: (path) => (path.endsWith(".obj") ? limit : 0),
    takeFromBudget: (count) => {
      left -= count;
      if (left < 0) {
        throw new Error("too much");
      }
    },
  });
}

/** Returns the archive with a field of its directory's only entry changed. */
function changed(bytes, field, value, size = 4) {
  const copy = bytes.slice();
  const view = new DataView(copy.buffer);
  for (let at = 0; at < copy.length - 4; ++at) {
    if (view.getUint32(at, true) === 0x02014b50) {
      if (size === 4) {
        view.setUint32(at + field, value, true);
      } else {
        view.setUint16(at + field, value, true);
      }
    }
  }
  return copy;
}

const FILES = { "x/tankbody.obj": text("v 0 0 0\n".repeat(5000)), "x/readme.txt": text("hello") };
const honest = zipArchive(FILES);
const stored = zipArchive({ "tankbody.obj": text("v 0 0 0\n") }, { stored: true });
const deflated = zipArchive({ "tankbody.obj": text("v 0 0 0\n".repeat(5000)) });

test("the wanted files come out, packed or stored, and others stay", async () => {
  const files = await open(honest);
  assert.deepEqual(
    files.map(({ name }) => name),
    ["a.zip/x/tankbody.obj"],
  );
  assert.equal(new TextDecoder().decode(files[0].bytes), "v 0 0 0\n".repeat(5000));
  assert.equal(new TextDecoder().decode((await open(stored))[0].bytes), "v 0 0 0\n");
});

test("a comment behind an archive may look like the end of one", async () => {
  assert.equal(
    (await open(zipArchive({ "tankbody.obj": text("v") }, { comment: "PK\u0005\u0006 is no end" })))[0].bytes.length,
    1,
  );
});

test("an archive that is none is named", async () => {
  for (const bytes of [new Uint8Array(0), text("no zip"), new Uint8Array(70000)]) {
    await assert.rejects(open(bytes), /^Error: a\.zip is no zip archive\. Drop /);
  }
});

test("an archive that is cut short is named", async () => {
  await assert.rejects(open(honest.slice(0, honest.length - 30)), /a\.zip is cut short.*download it again/);
});

test("an encrypted file is named", async () => {
  await assert.rejects(open(changed(deflated, 8, 1, 2)), /tankbody\.obj in a\.zip is encrypted\..*password/);
});

test("another way of packing is named", async () => {
  await assert.rejects(open(changed(deflated, 10, 14, 2)), /method 14/);
});

test("a file that is longer or shorter than the archive says is refused as it comes", async () => {
  for (const size of [10, 39_999, 40_001, 1 << 20]) {
    await assert.rejects(
      open(changed(deflated, 24, size)),
      new RegExp(`not as long as the archive says \\(${size} bytes\\)`),
    );
  }
  await assert.rejects(open(changed(stored, 24, 7)), /not as long/);
});

test("a file that would be too long is refused before it is unpacked", async () => {
  await assert.rejects(
    open(changed(deflated, 24, 100 * MEGABYTE)),
    /tankbody\.obj in a\.zip has 100 MB and at most 32 MB are read/,
  );
});

test("what all files come to is counted while they come", async () => {
  const zeros = new Uint8Array(20 * MEGABYTE);
  const bomb = zipArchive({ "1.obj": zeros, "2.obj": zeros, "3.obj": zeros });
  assert.ok(bomb.length < MEGABYTE);
  await assert.rejects(open(bomb, { budget: 50 * MEGABYTE }), /too much/);
  assert.equal((await open(bomb)).length, 3);
});

test("a path that leads out of the archive is named, wherever it is", async () => {
  for (const path of ["../tankbody.obj", "a/../../b.txt", "/etc/passwd", "C:\\tankbody.obj", "a\\..\\b"]) {
    await assert.rejects(open(zipArchive({ "tankbody.obj": text("v"), [path]: text("v") })), /leads out/);
  }
  assert.equal((await open(zipArchive({ "a..b/tankbody.obj": text("v") }))).length, 1);
});

test("damaged content is named", async () => {
  for (const at of [60, 65, 70]) {
    const bytes = deflated.slice();
    bytes[at] ^= 0x5a;
    await assert.rejects(open(bytes), /tankbody\.obj in a\.zip .*(damaged|not as long)/);
  }
  await assert.rejects(open(changed(deflated, 16, 1)), /checksum/);
  await assert.rejects(open(changed(deflated, 42, 1 << 30)), /not where the archive says/);
  await assert.rejects(open(changed(deflated, 20, 1 << 30)), /not where the archive says/);
});

test("no bytes make it hang or fail without a sentence", async () => {
  let seed = 1;
  const random = (below) => (seed = (seed * 48271) % 2147483647) % below;
  for (const original of [honest, zipArchive(FILES, { streamed: true, zip64: true })]) {
    for (let round = 0; round < 300; ++round) {
      const bytes = original.slice();
      for (let i = 0; i <= random(4); ++i) {
        bytes[random(bytes.length)] = random(256);
      }
      await open(bytes).catch((error) => assert.match(error.message, /a\.zip/, error.stack));
    }
  }
});

test("a browser that cannot unpack is told so, and takes what is not packed", async () => {
  const { DecompressionStream } = globalThis;
  delete globalThis.DecompressionStream;
  try {
    await assert.rejects(
      open(deflated),
      /^Error: This browser cannot unpack archives\. Unpack the archive yourself and drop the folder/,
    );
    assert.equal((await open(stored)).length, 1);
  } finally {
    globalThis.DecompressionStream = DecompressionStream;
  }
});

test("an archive that is taken away while it is read is not called damaged", async () => {
  const blob = new Blob([deflated]);
  const gone = new DOMException("The file is gone.", "NotReadableError");
  const failing = { stream: () => new ReadableStream({ pull: (controller) => controller.error(gone) }) };
  const content = 30 + "tankbody.obj".length;
  const vanishing = { size: blob.size, slice: (from, to) => (from === content ? failing : blob.slice(from, to)) };
  await assert.rejects(open(vanishing), gone);
});
