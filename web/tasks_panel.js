// The lab's tasks: what to see, which keys to press, where it stands in the source, and whether it is right.
import { commandButton } from "./command_button.js";
import { button, element } from "./elements.js";
import { keycaps, keyLabels } from "./key_labels.js";
import { notify } from "./notices.js";

const TITLE = document.title;

/** Returns a turn of the browser, in which it can show what has changed. */
const painted = () => new Promise((resolve) => setTimeout(resolve, 30));

class Entry {
  constructor(task, commands, { program, layout, act }) {
    this.task = task;
    this.program = program;
    this.mark = element("span", "mark"); // beside the title
    this.verdict = element("span", "verdict"); // in words
    this.verdict.setAttribute("role", "status");
    this.evidence = element("ul", "evidence");
    this.checking = button("", "Check", () => this.check());
    this.checking.setAttribute("aria-label", `Check ${task.id}, ${task.title}`);

    const show = element("a", "button strong", "Show");
    show.href = `#${task.link}`;
    show.setAttribute("aria-label", `Show ${task.id}, ${task.title}`);
    const keys = task.commands
      .map((name) => commands.get(name))
      .filter(Boolean)
      .map((command) => commandButton(command, "chip", [keycaps(keyLabels(command, layout).slice(0, 1)), command.title], act));
    this.box = element(
      "details",
      "task",
      element("summary", "", element("span", "id", task.id), element("h3", "", task.title), this.mark),
      element("p", "", task.text),
      element("div", "chips", ...keys),
      element("p", "source", "In ", element("code", "", task.source)),
      element("div", "buttons", show, this.checking, this.verdict),
      this.evidence,
    );
    this.box.dataset.id = task.id;
    this.show(task);
  }

  /** Shows what a check found, or that there was none. */
  show({ passed, evidence }) {
    const checked = passed === true || passed === false;
    const result = !checked ? "" : passed ? "passed" : "failed";
    this.mark.textContent = !checked ? "" : passed ? "✓" : "✗";
    this.mark.title = result;
    this.mark.className = `mark ${result}`;
    this.verdict.textContent = checked ? `${this.mark.textContent} ${result}` : "";
    this.verdict.className = `verdict ${result}`;
    this.evidence.replaceChildren(...(evidence ?? []).map((sentence) => element("li", "", sentence)));
  }

  async check() {
    this.verdict.className = "verdict";
    this.verdict.textContent = "checking …";
    this.checking.disabled = true;
    await painted();
    try {
      const result = await this.program.check(this.task.id);
      this.show(result);
      if (result.passed === null) this.verdict.textContent = "no check";
      return result.passed;
    } catch (error) {
      this.show({ passed: null });
      notify(error.message, { topic: "command" });
      return null;
    } finally {
      this.checking.disabled = false;
    }
  }
}

/** Makes the line above the tasks that checks them all. */
function checkAll(entries) {
  const summary = element("span", "verdict");
  summary.setAttribute("role", "status");
  const all = button("", "Check all", async () => {
    all.disabled = true;
    let passed = 0;
    for (const [i, entry] of entries.entries()) {
      summary.textContent = `${i} of ${entries.length} …`;
      if (await entry.check()) ++passed;
    }
    summary.className = `verdict ${passed === entries.length ? "passed" : "failed"}`;
    summary.textContent = `${passed} of ${entries.length} passed`;
    all.disabled = false;
  });
  return element("div", "check-all", all, summary);
}

/** Opens the entry that the state is about, and names it in the page's title. */
function markCurrent(entries, id) {
  for (const entry of entries) {
    const current = entry.task.id === id;
    if (current) {
      entry.box.open = true;
      entry.box.setAttribute("aria-current", "true");
      entry.box.scrollIntoView({ block: "nearest" });
    } else if (entry.box.hasAttribute("aria-current")) {
      entry.box.open = false;
      entry.box.removeAttribute("aria-current");
    }
  }
  const task = entries.find((entry) => entry.task.id === id)?.task;
  document.title = task ? `${task.id} ${task.title} · ${TITLE}` : TITLE;
}

/** Fills the panel with what tasks() returns: the tasks, and the handout's figures if they are there. */
export function showTasks(parts) {
  const { program } = parts;
  const panel = document.getElementById("tasks");
  const commands = new Map(program.commands().map((command) => [command.name, command]));
  const entries = program.tasks().map((task) => new Entry(task, commands, parts));
  const figures = entries.filter((entry) => entry.task.kind === "figure");
  const tasks = entries.filter((entry) => entry.task.kind !== "figure");
  panel.append(checkAll(tasks), ...tasks.map((entry) => entry.box));
  if (figures.length > 0) panel.append(element("h2", "", "Figures of the handout"), ...figures.map((entry) => entry.box));

  let shown;
  program.listen((state) => {
    const id = state.task ?? state.figure;
    if (id === shown) return;
    shown = id;
    markCurrent(entries, id);
  });
}
