// The user's own tank: dropped on the page or chosen, read here and nowhere else. Nothing leaves the browser.
import { around, button, element } from "../base/elements.js";
import { dismiss, notify } from "../base/notices.js";
import { chosenFiles, droppedFiles } from "./brought_files.js";
import { readTankFiles } from "./tank_files.js";
import { TankSet } from "./tank_set.js";

const TOPIC = "own-tank";
const PROGRESS_MS = 200; // what is over sooner needs no word
const NEEDED =
  "This link shows a tank of somebody’s own files, which are not in it. Drop them on the page or choose them: tankLab.zip, tankLOD.zip or the folder tankobjs. Until then Tank Lab’s own stands in.";

/** Returns a hidden input for files, which choose() opens. */
function input(attributes, take) {
  const made = Object.assign(element("input"), { type: "file", multiple: true, hidden: true, ...attributes });
  made.onchange = () => {
    const files = [...made.files];
    made.value = ""; // so that the same files can be chosen again
    if (files.length > 0) {
      take(() => chosenFiles(files));
    }
  };
  return made;
}

/** Makes the dialog that tells what can be brought. */
function dialog(parts) {
  const made = element(
    "dialog",
    "panel own-tank",
    element("h2", "", "Your own tank"),
    element(
      "p",
      "",
      "Drop tankLab.zip, tankLOD.zip, the folder tankobjs or its files anywhere on the page, or choose them here. They stay on this computer.",
    ),
    element("div", "buttons", ...parts.choosers()),
    element(
      "div",
      "buttons",
      parts.back,
      button("quiet", "Close", () => made.close()),
    ),
  );
  made.setAttribute("aria-label", "Your own tank");
  made.onclick = (event) => event.target === made && made.close(); // beside it
  return made;
}

/** Lets files be dropped anywhere, and shows that they may. */
function joinDrop(take) {
  const sign = element("div", "", element("p", "panel", "Drop the tank’s files here"));
  sign.id = "drop";
  sign.hidden = true;
  document.body.append(sign);
  /** @type {(event: DragEvent) => DataTransfer | null} */
  const filesOf = ({ dataTransfer }) => (dataTransfer?.types.includes("Files") ? dataTransfer : null);
  addEventListener("dragover", (event) => {
    const files = filesOf(event);
    if (!files) {
      return;
    }
    event.preventDefault(); // or the browser would open the file
    files.dropEffect = "copy";
    sign.hidden = false;
  });
  addEventListener("dragleave", (event) => (sign.hidden ||= !event.relatedTarget)); // the window, not a part of it
  addEventListener("drop", (event) => {
    sign.hidden = true;
    const files = filesOf(event);
    if (!files) {
      return;
    }
    event.preventDefault();
    const found = droppedFiles(files);
    take(() => found);
  });
}

/** Who shows a tank of their own keeps it when they follow a link of the page, such as a task. */
function keepInLinks(program) {
  document.addEventListener("click", (event) => {
    const link = /** @type {HTMLAnchorElement | null} */ (around(event, "a[href^='#']"));
    const { tank, has_own_tank: has } = program.newest ?? {};
    if (!link || tank !== "own" || !has || event.ctrlKey || event.metaKey || event.shiftKey) {
      return;
    }
    event.preventDefault();
    location.hash = link.hash ? `${link.hash}&tank=own` : "#tank=own";
  });
}

/** Joins all of it to the page. parts: {canvas, program, act} */
export function joinOwnTank({ canvas, program, act }) {
  const manifest = program.assetManifest();
  const set = new TankSet(manifest);
  let busy = false;

  const tell = (sentence, field = null) => {
    dismiss(TOPIC);
    notify(sentence, { topic: TOPIC, field });
  };
  const show = async (files) => {
    const { files: all, missing } = set.add(files);
    if (missing) {
      set.keep(all);
      return tell(missing, choosers());
    }
    tell("Assembling the tank …");
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done))); // the sentence is seen first
    const { error, notes } = program.bringTank(all);
    if (error) {
      throw new Error(`${error.replace(/\.?$/, ".")} The tank stays as it was.`);
    }
    set.shown(all);
    tell(notes.join(" ") || "These are Tank Lab’s own files.");
    box.close();
    canvas.focus({ preventScroll: true });
  };
  const take = async (find) => {
    if (busy) {
      return;
    }
    busy = true;
    let told = performance.now();
    const progress = (sentence) => {
      if (performance.now() - told < PROGRESS_MS) {
        return;
      }
      told = performance.now();
      tell(sentence);
    };
    performance.mark("tanklab-files-brought");
    try {
      const found = await find();
      await show(await readTankFiles(found, manifest, progress));
      requestAnimationFrame(() => performance.mark("tanklab-own-tank-shown"));
    } catch (error) {
      tell(error.message, choosers());
    } finally {
      busy = false;
    }
  };

  const files = input({ accept: ".zip,.obj,.tga,.png,.jpg" }, take);
  files.id = "own-tank-files";
  const folder = input({ webkitdirectory: true }, take);
  folder.id = "own-tank-folder";
  const choosers = () => element("span", "buttons", ...chooserButtons());
  const chooserButtons = () => [
    button("strong", "Choose files", () => files.click()),
    button("", "Choose a folder", () => folder.click()),
  ];
  const back = button("quiet", "Back to Tank Lab’s tank", () => {
    act("tank", 0);
    box.close();
  });
  const box = dialog({ choosers: chooserButtons, back });
  const open = button("quiet", "Your own tank …", () => box.showModal());
  open.id = "own-tank";
  open.setAttribute("aria-haspopup", "dialog");
  document.querySelector("footer .lines")?.append(open);
  document.body.append(files, folder, box);
  joinDrop(take);
  keepInLinks(program);

  let asked = false;
  program.listen(({ tank, has_own_tank: has }) => {
    back.hidden = tank !== "own" || !has;
    const lacks = tank === "own" && !has;
    if (lacks && !asked) {
      tell(NEEDED, choosers());
    }
    if (!lacks && asked) {
      dismiss(TOPIC);
    }
    asked = lacks;
  });
}
