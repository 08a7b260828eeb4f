// Fetches the program and the tank's files, and shows how much of them is there.
import { byId } from "../base/elements.js";
import { LoadFailure } from "./failure.js";

const screen = byId("loading");
const track = /** @type {HTMLElement} */ (screen.querySelector(".track"));
const bar = /** @type {HTMLElement} */ (track.firstElementChild);

/** Shows a share from 0 to 1 and what is going on. */
export function showProgress(share, what) {
  const percent = Math.floor(100 * Math.min(1, share));
  track.setAttribute("aria-valuenow", String(percent));
  track.setAttribute("aria-valuetext", `${what}, ${percent} %`);
  bar.style.transform = `scaleX(${percent / 100})`;
  byId("loading-what").textContent = what;
  byId("loading-share").textContent = `${percent} %`;
}

/** Fades the screen out, and takes it away. */
export function hideProgress() {
  const fade = matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : 500; // as in style.css, and a little
  setTimeout(() => (screen.hidden = true), fade);
}

function missing(name, why) {
  return new LoadFailure(
    "A file is missing",
    `The file ${name} did not arrive: ${why}.`,
    "Check your connection, and that the server has the file in its place, then reload the page.",
  );
}

/** Fetches one file. arrived(count) is called as its bytes arrive, decompressed, as the list counts them. */
async function fetchFile({ name, url }, arrived) {
  let response;
  try {
    response = await fetch(url);
  } catch {
    throw missing(name, "the server cannot be reached");
  }
  if (!response.ok) {
    throw missing(name, `the server answered “${`${response.status} ${response.statusText}`.trim()}”`);
  }
  const parts = [];
  try {
    const reader = /** @type {ReadableStream<Uint8Array<ArrayBuffer>>} */ (response.body).getReader();
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      parts.push(part.value);
      arrived(part.value.length);
    }
  } catch {
    throw missing(name, "the connection broke off");
  }
  return { name, bytes: new Uint8Array(await new Blob(parts).arrayBuffer()) };
}

/** Fetches all that the page's list of files names. Returns {wasm, assets: [{name, bytes}]}. */
export async function loadFiles() {
  // scripts/assemble-page.mjs puts the list into the page; in the page of one file the addresses are data.
  const { program, assets } = JSON.parse(byId("tanklab-files").textContent);
  const all = [program, ...assets];
  const total = all.reduce((sum, file) => sum + file.bytes, 0);
  const waiting = new Set(all);
  let loaded = 0;
  const show = () => {
    const [next] = waiting;
    showProgress(loaded / total, next === program ? "Loading the program" : next ? `Loading ${next.name}` : "Loaded");
  };
  show();
  const files = await Promise.all(
    all.map(async (file) => {
      const fetched = await fetchFile(file, (count) => {
        loaded += count;
        show();
      });
      waiting.delete(file);
      show();
      return fetched;
    }),
  );
  return { wasm: files[0].bytes, assets: files.slice(1) };
}
