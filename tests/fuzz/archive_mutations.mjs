// Damages archives at random, from a seed: the same seed gives the same archives.

const SIGNATURES = [0x02014b50, 0x04034b50, 0x05054b50, 0x06054b50, 0x06064b50, 0x07064b50, 0x08074b50];
const TELLING = [0, 1, 2, 8, 14, 0x7f, 0xff, 0x800, 0x7fff, 0xffff, 0x10000, 0x7fffffff, 0xfffffffe, 0xffffffff];

/** Returns a function that gives numbers from 0 to below its argument (mulberry32). */
export function generator(seed) {
  let state = seed >>> 0;
  return (below) => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32) * below) | 0;
  };
}

const viewOf = (bytes) => new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
const joined = (...parts) => new Uint8Array(Buffer.concat(parts));

/** Returns where the headers of an archive begin. */
function headers(bytes) {
  const view = viewOf(bytes);
  const found = [];
  for (let at = 0; at + 4 <= bytes.length; ++at) {
    if (bytes[at] === 0x50 && SIGNATURES.includes(view.getUint32(at, true))) {
      found.push(at);
    }
  }
  return found;
}

/** Puts a number that readers trip over into a field of a header, or anywhere. */
function overwrite(bytes, random) {
  const begins = headers(bytes);
  const base =
    begins.length > 0 && random(4) > 0 ? begins[random(begins.length)] + 2 * random(28) : random(bytes.length);
  const size = [1, 2, 4, 8][random(4)];
  const old = base + size <= bytes.length ? bytes[base] : 0;
  const value = random(3) === 0 ? old + random(9) - 4 : TELLING[random(TELLING.length)];
  const copy = bytes.slice();
  for (let i = 0; i < size && base + i < copy.length; ++i) {
    copy[base + i] = i < 4 ? value >>> (8 * i) : 0;
  }
  return copy;
}

const WAYS = [
  overwrite,
  overwrite,
  overwrite,
  (bytes, random) => {
    const copy = bytes.slice();
    copy[random(copy.length)] ^= 1 << random(8);
    return copy;
  },
  (bytes, random) => {
    const copy = bytes.slice();
    copy[random(copy.length)] = random(256);
    return copy;
  },
  (bytes, random) => bytes.slice(0, random(bytes.length)),
  (bytes, random) => {
    const at = random(bytes.length);
    return joined(bytes.subarray(0, at), bytes.subarray(Math.min(bytes.length, at + 1 + random(40))));
  },
  // a piece of this archive, or of another one, comes in
  (bytes, random, other) => {
    const from = random(2) === 0 ? bytes : other;
    const at = random(bytes.length);
    const begin = random(from.length);
    return joined(bytes.subarray(0, at), from.subarray(begin, begin + 1 + random(400)), bytes.subarray(at));
  },
  // the front of this one and the end of another one
  (bytes, random, other) => joined(bytes.subarray(0, random(bytes.length)), other.subarray(random(other.length))),
];

/** Returns the archive damaged at one to four places. */
export function damaged(bytes, random, other) {
  let result = bytes;
  for (let i = 1 + random(4); i > 0 && result.length > 0; --i) {
    result = WAYS[random(WAYS.length)](result, random, other);
  }
  return result;
}
