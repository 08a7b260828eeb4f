// The address follows the state, and the state follows an address that the reader changes.

const PAUSE_MS = 500; // Browsers refuse more than some hundred changes a minute.

/** Keeps the fragment of the address and the state the same, without a new entry in the history. */
export function watchAddress(program, states, notify) {
  let written = location.hash.slice(1);
  let timer = 0;
  const write = () => {
    timer = 0;
    const link = program.link();
    if (link === written) return;
    written = link;
    try {
      history.replaceState(history.state, "", link ? `#${link}` : location.pathname + location.search);
    } catch {
      // A browser that has had enough for now; the next change tries again.
    }
  };
  states.listen(() => {
    if (timer === 0) timer = setTimeout(write, PAUSE_MS);
  });
  addEventListener("pagehide", write);
  addEventListener("hashchange", () => {
    const fragment = location.hash.slice(1);
    if (fragment === written) return;
    for (const sentence of program.openLink(fragment)) notify(sentence);
    written = fragment;
  });
}
