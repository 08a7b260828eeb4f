// Fetches the program and its models, and shows how far that is.
import { LoadFailure } from "./failure.js";

const bar = document.getElementById("loading");
const fill = bar.querySelector(".fill");
const text = document.getElementById("loading-text");

/** Shows a share from 0 to 1 and what is being loaded. */
function show(share, what) {
  const percent = Math.round(100 * Math.min(1, share));
  bar.setAttribute("aria-valuenow", String(percent));
  bar.setAttribute("aria-valuetext", `${what}, ${percent} %`);
  fill.style.width = `${percent}%`;
  text.textContent = what;
}

/** Fetches one file; calls arrived(bytes) as its parts arrive. */
async function fetchFile({ name, url }, arrived) {
  const unreachable = (why) =>
    new LoadFailure(
      "A file is missing",
      `The file ${name} did not arrive: ${why}.`,
      "Check the connection, or that the file lies beside the page on the server, and load the page again.",
    );
  let response;
  try {
    response = await fetch(url);
  } catch {
    throw unreachable("the server cannot be reached");
  }
  if (!response.ok) throw unreachable(`the server answered ${response.status} ${response.statusText}`.trim());
  const parts = [];
  const reader = response.body.getReader();
  try {
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      parts.push(part.value);
      arrived(part.value.length);
    }
  } catch {
    throw unreachable("the connection broke");
  }
  return { name, bytes: new Uint8Array(await new Blob(parts).arrayBuffer()) };
}

/** Fetches all that the page's list of files names. Returns {wasm, assets: [{name, bytes}]}. */
export async function loadFiles() {
  const list = JSON.parse(document.getElementById("tanklab-files").textContent);
  const all = [list.program, ...list.assets];
  const total = all.reduce((sum, file) => sum + file.bytes, 0);
  let loaded = 0;
  const waiting = new Set(all.map((file) => file.name));
  const describe = () => {
    const [next] = waiting;
    if (next === list.program.name) return "Loading the program";
    return next ? `Loading the tank: ${next}` : "Starting";
  };
  show(0, describe());
  const files = await Promise.all(
    all.map(async (file) => {
      const fetched = await fetchFile(file, (bytes) => {
        loaded += bytes;
        show(loaded / total, describe());
      });
      waiting.delete(file.name);
      show(loaded / total, describe());
      return fetched;
    }),
  );
  return { wasm: files[0].bytes, assets: files.slice(1) };
}
