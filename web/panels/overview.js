// All verdicts at a glance: a tile for each task, how many passed, and a button that checks them all.
import { button, element } from "../base/elements.js";
import { markOf, verdictOf } from "./verdict.js";

/** Makes a tile that opens a task and shows its verdict. */
function tile({ task }) {
  const made = element("a", "tile");
  made.href = `#${task.link}`;
  return made;
}

function counted(entries) {
  const count = (passed) => entries.filter((entry) => entry.passed === passed).length;
  const [passed, failed] = [count(true), count(false)];
  const open = entries.length - passed - failed;
  const parts = [];
  if (passed) {
    parts.push(open ? `${passed} passed` : `${passed} of ${entries.length} passed`);
  }
  if (failed) {
    parts.push(`${failed} failed`);
  }
  if (open) {
    parts.push(`${open} not checked`);
  }
  return { text: parts.join(", "), failed, isDone: open === 0 };
}

/** Returns {box, update(current)}: the overview of the entries, and what brings it up to date. update returns
    "" or, once all are checked, how many passed. onAllChecked is called when "Check all" has ended. */
export function overview(entries, onAllChecked) {
  const tiles = entries.map(tile);
  const summary = element("span", "verdict");
  summary.setAttribute("role", "status");
  const progress = element("progress");
  progress.max = entries.length;
  progress.setAttribute("aria-label", "Checked");
  let running = false;
  const all = button("strong", "Check all", async () => {
    all.disabled = true;
    running = true;
    for (const [i, entry] of entries.entries()) {
      progress.value = i;
      summary.textContent = `Checking ${entry.task.id} …`;
      await entry.check();
    }
    progress.value = entries.length;
    running = false;
    onAllChecked();
    all.disabled = false;
  });
  let current = null;
  const update = (id = current) => {
    current = id;
    const { text, failed, isDone } = counted(entries);
    for (const [i, { task, passed }] of entries.entries()) {
      tiles[i].className = `tile ${verdictOf(passed)}`;
      tiles[i].textContent = task.id + markOf(passed);
      tiles[i].title = `${task.id} ${task.title}: ${verdictOf(passed) || "not checked"}`;
      tiles[i].setAttribute("aria-label", tiles[i].title);
      if (task.id === current) {
        tiles[i].setAttribute("aria-current", "true");
      } else {
        tiles[i].removeAttribute("aria-current");
      }
    }
    progress.hidden = !running;
    if (!running) {
      summary.textContent = text;
      summary.className = `verdict ${failed ? "failed" : isDone ? "passed" : ""}`;
    }
    return isDone && !running ? text : "";
  };
  return {
    box: element(
      "div",
      "overview",
      element("div", "check-all", all, summary),
      progress,
      element("div", "tiles", ...tiles),
    ),
    update,
  };
}
