// Damages archives and unpacks them, one after the other. archive_fuzz.mjs watches from outside: what does not hold is
// thrown out of here, and what was being unpacked then stands in memory that both see.
import { parentPort, workerData } from "node:worker_threads";
import { check, checkWhole } from "./archive_check.mjs";
import { damaged, generator } from "./archive_mutations.mjs";
import { seedArchives } from "./archive_seeds.mjs";

const LARGEST_CORPUS = 500;
const { runs, seconds, seed, corpus, progress, current } = workerData;

function begin(bytes) {
  current.set(bytes);
  progress[1] = bytes.length;
  Atomics.add(progress, 0, 1);
}

/** Returns what tells outcomes apart: files, none of them, or what was said, without names and numbers. */
function kindOf({ files, sentence }) {
  return files
    ? `files: ${files.length > 0}`
    : sentence
        .replace(/^.*a\.zip/s, "")
        .replace(/“.*”/s, "")
        .replace(/\d+/g, "0");
}

const seeds = seedArchives();
const inputs = [...seeds.map(({ bytes }) => bytes), ...corpus];
const kinds = new Set();
const random = generator(seed);
const until = performance.now() + seconds * 1000;

for (const whole of seeds) {
  begin(whole.bytes);
  await checkWhole(whole);
}
for (const bytes of inputs) {
  begin(bytes);
  kinds.add(kindOf(await check(bytes)));
}
while (progress[0] < runs && performance.now() < until) {
  const [bytes, other] = [inputs[random(inputs.length)], inputs[random(inputs.length)]];
  const input = damaged(bytes, random, other).slice(0, current.length);
  begin(input);
  const kind = kindOf(await check(input));
  if (kinds.has(kind) || inputs.length >= LARGEST_CORPUS) {
    continue;
  }
  kinds.add(kind);
  inputs.push(input);
  parentPort.postMessage(input);
}
