// Loads the program, starts it in the state that the address describes, and joins it to the page.
import { byId } from "./base/elements.js";
import { dismiss, notify } from "./base/notices.js";
import { lightHeld } from "./controls/command_button.js";
import { readKeyboardLayout } from "./controls/key_labels.js";
import { joinOwnTank } from "./own_tank/own_tank.js";
import { showHits } from "./panels/hits_panel.js";
import { showKeys } from "./panels/keys_panel.js";
import { joinPanels } from "./panels/panels.js";
import { showTasks } from "./panels/tasks_panel.js";
import { showValues } from "./panels/values_panel.js";
import { followFocus } from "./picture/focus.js";
import { namePanes } from "./picture/pane_names.js";
import { followStatus } from "./picture/status_line.js";
import { followAddress } from "./program/address.js";
import { LoadFailure, showFailure } from "./program/failure.js";
import { hideProgress, loadFiles, showProgress } from "./program/load.js";
import { Program } from "./program/program.js";
import { joinShareButton } from "./program/share.js";

const canvas = byId("canvas");
const bare = new URLSearchParams(location.search).get("overlays") === "0"; // for pictures that are compared
document.body.classList.toggle("bare", bare);

function requireWebGl2() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) {
    throw new LoadFailure(
      "This browser has no WebGL 2",
      "Tank Lab draws with WebGL 2, which this browser does not have or has switched off.",
      "Open the page in a current Firefox, Chrome, Edge or Safari, or switch graphics acceleration on in the browser’s settings.",
    );
  }
  gl.getExtension("WEBGL_lose_context")?.loseContext(); // a browser has few to give
}

/** Notes what takes how long, for scripts/bench, and lets people see the picture and use it. */
function reveal() {
  performance.mark("tanklab-first-frame");
  for (const element of document.querySelectorAll("[inert]")) {
    element.removeAttribute("inert");
  }
  document.body.classList.replace("loading", "ready");
  hideProgress();
  canvas.focus({ preventScroll: true });
}

async function start(program) {
  const loading = loadFiles();
  loading.catch(() => {}); // told below, unless there is no WebGL to need the files for
  requireWebGl2();
  const [{ wasm, assets }, layout] = await Promise.all([loading, readKeyboardLayout()]);
  showProgress(1, "Starting the program");
  await program.open(canvas, wasm, assets);

  const parts = { program, layout, act: (name, value) => attempt(() => program.command(name, value)) };
  showTasks(parts);
  showHits(parts);
  showKeys(parts);
  showValues(parts);
  lightHeld(program);
  followStatus(program);
  namePanes(program);
  // The panels take their room before the first frame, so that nothing jumps.
  joinPanels({ canvas, program, bare, task: /(^|[#&;])(task|figure)=/.test(location.hash) });
  followAddress(program);
  joinShareButton(program);
  joinOwnTank({ canvas, ...parts });
  followFocus(canvas);

  program.start(location.hash.slice(1));
  requestAnimationFrame(reveal);
}

/** Does something a person asked for; what the program answers is told, not thrown. */
function attempt(action) {
  try {
    action();
    dismiss("command");
  } catch (error) {
    notify(error.message, { topic: "command" });
  }
}

const program = new Program();
const tanklab = program.forScripts();
tanklab.ready = start(program).then(() => tanklab);
tanklab.ready.catch((error) => showFailure(error)); // whoever waits for it is told, too
window.tanklab = tanklab;
