// Loads the program, starts it in the state that the address describes, and joins it to the page.
import { watchAddress } from "./address.js";
import { fail, LoadFailure } from "./failure.js";
import { followFocus } from "./focus.js";
import { showKeys } from "./keys_panel.js";
import { loadFiles } from "./load.js";
import { notify } from "./notices.js";
import { joinPanels } from "./panels.js";
import { startProgram } from "./program.js";
import { joinShareButton } from "./share.js";
import { showTasks } from "./tasks_panel.js";
import { showValues } from "./values_panel.js";

const canvas = document.getElementById("canvas");
const query = new URLSearchParams(location.search);

function hasWebGl2() {
  return Boolean(document.createElement("canvas").getContext("webgl2"));
}

async function start() {
  if (!hasWebGl2()) {
    throw new LoadFailure(
      "This browser has no WebGL 2",
      "Tank Lab draws with WebGL 2, which this browser does not have or has switched off.",
      "Open the page in a current Firefox, Chrome, Edge or Safari, or switch hardware acceleration on in the settings.",
    );
  }
  const files = await loadFiles();
  const { program, states } = await startProgram(canvas, files, notify);
  await joinPanels();
  await showKeys(program, states);
  showValues(program, states);
  showTasks(program, states);
  watchAddress(program, states, notify);
  joinShareButton(program, notify);
  followFocus(canvas, program);
  if (query.get("overlays") === "0") for (const element of document.querySelectorAll(".overlay")) element.hidden = true;
  return program;
}

// What scripts and graders use; `ready` first, the rest once it has resolved.
const ready = start();
window.tanklab = { ready };
ready.then(
  (program) => {
    Object.assign(window.tanklab, program);
    requestAnimationFrame(() => {
      performance.mark("tanklab-first-frame");
      document.body.classList.add("ready");
      canvas.focus({ preventScroll: true });
      setTimeout(() => (document.getElementById("loading").hidden = true), 400);
    });
  },
  (error) => fail(error),
);
ready.catch(() => {}); // Told above; whoever waits for it is told, too.
