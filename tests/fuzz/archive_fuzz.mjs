// Unpacks damaged archives, as a program with the arguments and the words of one of libFuzzer's:
//
//   node tests/fuzz/archive_fuzz.mjs [-max_total_time=SECONDS] [-runs=N] [-seed=N] [-timeout=SECONDS]
//     [-artifact_prefix=FOLDER/] [CORPUS ...]
//   node tests/fuzz/archive_fuzz.mjs FILE ...     unpacks these once
//
// What comes out otherwise than before is kept in the first folder of CORPUS. Exit status 1: something was found.
// -timeout is what one archive may take; the statistics of -print_final_stats=1 are printed anyway.
import { createHash, randomInt } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { Worker } from "node:worker_threads";

const LARGEST_INPUT = 1 << 20;
const HEAP = 512; // megabytes

const options = {
  max_total_time: "Infinity",
  runs: "Infinity",
  seed: String(randomInt(2 ** 31)),
  timeout: "10",
  artifact_prefix: "./",
  print_final_stats: "1",
};
const paths = [];
for (const argument of process.argv.slice(2)) {
  const [, name, value] = /^-(\w+)=(.*)$/s.exec(argument) ?? [];
  if (name in options) {
    options[name] = value;
  } else if (!name && fs.existsSync(argument)) {
    paths.push(argument);
  } else {
    console.error(`archive_fuzz: '${argument}' is neither an option nor there`);
    process.exit(2);
  }
}

async function unpackOnce(files) {
  const { check } = await import("./archive_check.mjs");
  for (const file of files) {
    const { files: given, sentence } = await check(new Uint8Array(fs.readFileSync(file)));
    console.log(`${file}: ${given ? `${given.length} files` : sentence}`);
  }
}

const nameOf = (bytes) => createHash("sha1").update(bytes).digest("hex");
const filesOf = (folder) =>
  fs.readdirSync(folder).map((name) => new Uint8Array(fs.readFileSync(path.join(folder, name))));

function fuzz(folders) {
  const progress = new Int32Array(new SharedArrayBuffer(8)); // inputs so far, and the length of the one at work
  const current = new Uint8Array(new SharedArrayBuffer(LARGEST_INPUT));
  const corpus = folders.flatMap(filesOf).filter((bytes) => bytes.length <= LARGEST_INPUT);
  const numbers = { runs: Number(options.runs), seconds: Number(options.max_total_time), seed: Number(options.seed) };
  console.log(`Seed: ${numbers.seed}`);
  const worker = new Worker(new URL("archive_worker.mjs", import.meta.url), {
    workerData: { ...numbers, corpus, progress, current },
    resourceLimits: { maxOldGenerationSizeMb: HEAP },
  });

  const found = (kind, reason) => {
    if (process.exitCode === 1) {
      return;
    }
    process.exitCode = 1;
    const bytes = current.slice(0, progress[1]);
    const file = `${options.artifact_prefix}${kind}-${nameOf(bytes)}`;
    fs.writeFileSync(file, bytes);
    console.log(`ERROR: ${reason}\nTest unit written to ${file}`);
  };
  let [round, since] = [0, Date.now()];
  const watch = setInterval(() => {
    if (round !== progress[0]) {
      [round, since] = [progress[0], Date.now()];
    } else if (Date.now() - since > Number(options.timeout) * 1000) {
      found("timeout", `an archive is unpacked for more than ${options.timeout} seconds`);
      worker.terminate();
    }
  }, 500);
  worker.on("message", (bytes) => {
    if (folders.length > 0) {
      fs.writeFileSync(path.join(folders[0], nameOf(bytes)), bytes);
    }
  });
  worker.on("error", (error) =>
    found("code" in error && error.code === "ERR_WORKER_OUT_OF_MEMORY" ? "oom" : "crash", error.message),
  );
  worker.on("exit", (code) => {
    clearInterval(watch);
    if (code !== 0) {
      found("timeout", "unpacking an archive waits for what never comes");
    }
    console.log(`stat::number_of_executed_units: ${progress[0]}`);
  });
}

if (paths.length > 0 && paths.every((file) => fs.statSync(file).isFile())) {
  await unpackOnce(paths);
} else {
  fuzz(paths);
}
