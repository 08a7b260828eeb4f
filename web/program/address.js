// The address follows the state, and the state follows an address that somebody changes.
import { around } from "../base/elements.js";
import { dismiss, notify } from "../base/notices.js";

const PAUSE_MS = 500; // Safari refuses more than 100 changes in 30 s

/** Returns the whole address of the state. */
export function addressOf(program) {
  const link = program.link();
  return location.href.replace(/#.*$/s, "") + (link ? `#${link}` : "");
}

/** Opens a fragment and tells what is wrong with it. */
function open(program, fragment) {
  dismiss("link");
  for (const sentence of program.openLink(fragment)) {
    notify(sentence, { topic: "link" });
  }
}

/** Keeps the address's fragment and the state the same, without new entries in the history. */
export function followAddress(program) {
  let timer = 0;
  let known = location.hash; // as it was opened or written last
  const stop = () => {
    clearTimeout(timer);
    timer = 0;
  };
  const write = () => {
    stop();
    if (location.hash !== known) {
      return; // somebody changed it: hashchange is on its way
    }
    if (!program.newest) {
      return;
    }
    const link = program.link();
    if (location.hash === (link && `#${link}`)) {
      return;
    }
    try {
      history.replaceState(history.state, "", addressOf(program));
      known = location.hash;
    } catch {
      timer = setTimeout(write, PAUSE_MS); // the browser has had enough for now
    }
  };
  program.listen(() => {
    if (!timer) {
      timer = setTimeout(write, PAUSE_MS);
    }
  });
  addEventListener("pagehide", write);
  const openAddress = () => {
    stop(); // what waits to be written is older
    known = location.hash;
    open(program, known.slice(1));
  };
  addEventListener("hashchange", openAddress);
  // A link to where the address is already changes nothing there, but the state may have moved since.
  document.addEventListener("click", (event) => {
    const link = /** @type {HTMLAnchorElement | null} */ (around(event, "a[href^='#']"));
    if (link && link.hash === location.hash) {
      openAddress();
    }
  });
}
