// The archives that fuzzing starts from: one for each way of packing that is met with.
import { zipArchive } from "../page/zip_archive.mjs";

const bytes = (text) => new Uint8Array(Buffer.from(text));
const triangle = bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
const grid = bytes(Array.from({ length: 200 }, (_, i) => `v ${i % 17} ${(i * i) % 23} ${i / 8}\n`).join(""));
const tank = { "tankbody.obj": grid, "tankgun.obj": triangle, "readme.txt": bytes("The lab's tank.\n") };
const many = Object.fromEntries(
  Array.from({ length: 120 }, (_, i) => [`part${i}.obj`, triangle.subarray(0, i % triangle.length)]),
);

/** What the archives hold, and how each is packed.
    @type {[Record<string, Uint8Array>, Parameters<typeof zipArchive>[1]][]} */
const PACKED = [
  [tank, {}],
  [tank, { stored: true }],
  [tank, { streamed: true }],
  [tank, { stored: true, streamed: true }],
  [tank, { stored: true, zip64: true }],
  [tank, { streamed: true, zip64: true }],
  [
    {
      "Lab 3/tank/": bytes(""),
      [`Lab 3/tank/${"deeper/".repeat(20)}tankbody.obj`]: grid,
      "Lab 3/größer.obj": triangle,
    },
    {},
  ],
  [many, {}],
  [many, { stored: true }],
  [{ "empty.obj": bytes("") }, { stored: true }],
  [{}, {}],
  [{ "tankbody.obj": new Uint8Array(200_000) }, { comment: "PK\u0005\u0006 is no end" }],
];

/** Returns [{entries, bytes}]. */
export const seedArchives = () => PACKED.map(([entries, how]) => ({ entries, bytes: zipArchive(entries, how) }));
