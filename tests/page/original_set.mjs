// Files like the lab's own, made here: their names, bounding boxes, numbers of triangles and the quirks that
// docs/architecture.md lists; tests/assets/users_tank_test.cpp holds the program to each of these.
import { zipArchive } from "./zip_archive.mjs";

/** @type {Record<string, {box: [number[], number[]], steps: number}>} */
const HIGH = {
  tankbody: {
    box: [
      [-39.4, -19, -92.9],
      [39.4, 17.9, 79.1],
    ],
    steps: 11,
  },
  tankturret: {
    box: [
      [-35, -3, -64.4],
      [35.5, 92.4, 39.6],
    ],
    steps: 11,
  },
  tankmaingun: {
    box: [
      [-59.9, 102.6, 9.5],
      [-47.1, 116.2, 97.4],
    ],
    steps: 6,
  },
  tanksecondarygun: {
    box: [
      [-3.1, 0.3, -2.6],
      [3.5, 9, 34.2],
    ],
    steps: 2,
  },
  tankwheel: {
    box: [
      [-14, -7.5, -7],
      [0.9, 7.4, 7.8],
    ],
    steps: 3,
  },
};

/** Returns an OBJ text: a box, each of its sides of steps x steps squares. */
export function boxObj([minimum, maximum], steps, textured) {
  const lines = ["# exported", "g part", "s 1"];
  let vertices = 0;
  for (let axis = 0; axis < 3; ++axis) {
    for (const upper of [false, true]) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const first = vertices + 1;
      for (let i = 0; i <= steps; ++i) {
        for (let j = 0; j <= steps; ++j) {
          const corner = [...(upper ? maximum : minimum)];
          corner[u] = minimum[u] + (i / steps) * (maximum[u] - minimum[u]);
          corner[v] = minimum[v] + (j / steps) * (maximum[v] - minimum[v]);
          const normal = [0, 0, 0];
          normal[axis] = (upper ? 1 : -1) * (0.2 + (3.6 * ((vertices * 7) % 31)) / 30);
          lines.push(`v ${corner.join(" ")}`, `vn ${normal.join(" ")}`);
          if (textured) {
            lines.push(`vt ${i / steps} ${j / steps} 0`);
          }
          ++vertices;
        }
      }
      const index = (n) => (textured ? `${n}/${n}/${n}` : `${n}//${n}`);
      for (let i = 0; i < steps; ++i) {
        for (let j = 0; j < steps; ++j) {
          const a = first + i * (steps + 1) + j;
          const b = a + steps + 1;
          for (const [p, q, r] of [
            [a, b, b + 1],
            [a, b + 1, a + 1],
          ]) {
            lines.push(`f ${[p, ...(upper ? [q, r] : [r, q])].map(index).join(" ")}`);
          }
        }
      }
    }
  }
  return `${lines.join("\n")}\n`;
}

/** Returns a run-length encoded TGA of 1024 x 1024 whose header has its rows the wrong way round: red above,
    blue below, each row `noise` packets. */
export function originalTga() {
  const header = [0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 4, 24, 0];
  const row = (upper) => Array.from({ length: 8 }, () => [255, upper ? 0 : 200, 0, upper ? 200 : 0]).flat();
  return Uint8Array.from([...header, ...Array.from({ length: 1024 }, (_, y) => row(y < 512)).flat()]);
}

const bytesOf = (text) => new TextEncoder().encode(text);

/** Returns the five high files, as {name: bytes}. */
export function highFiles() {
  return Object.fromEntries(
    Object.entries(HIGH).map(([name, { box, steps }]) => [`${name}.obj`, bytesOf(boxObj(box, steps, true))]),
  );
}

/** Returns the five low files, as {name: bytes}. */
export function lowFiles() {
  return Object.fromEntries(
    Object.entries(HIGH).map(([name, { box }]) => [`${name}Low.obj`, bytesOf(boxObj(box, 1, false))]),
  );
}

const inFolder = (folder, files) =>
  Object.fromEntries(Object.entries(files).map(([name, bytes]) => [`${folder}/${name}`, bytes]));

/** Returns archives like the lab's; a Mac packs without going back to write sizes down. */
export const tankLab = () =>
  zipArchive(
    {
      ...inFolder("tankLab/tankobjs", highFiles()),
      "tankLab/texture.tga": originalTga(),
      "tankLab/readme.txt": bytesOf("Lab 3"),
      "__MACOSX/tankLab/tankobjs/._tankbody.obj": bytesOf("\u0005\u0016\u0007"),
    },
    { streamed: true },
  );
export const tankLod = () => zipArchive(inFolder("tankobjs", lowFiles()));
