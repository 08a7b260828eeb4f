// The tasks of the lab: what to see, which keys to press, where it stands in the source, and whether it is right.
import { keycaps, keyLabels } from "./keycaps.js";

function element(name, className, text) {
  const made = document.createElement(name);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}

/** Shows what a check found. */
function showVerdict(entry, task) {
  const verdict = entry.querySelector(".verdict");
  verdict.className = `verdict ${task.passed === null ? "" : task.passed ? "passed" : "failed"}`;
  verdict.textContent = task.passed === null ? "" : task.passed ? "✓ Right" : "✗ Not right";
  entry.querySelector("ul").replaceChildren(...(task.evidence ?? []).map((sentence) => element("li", "", sentence)));
}

function makeEntry(task, commands, labels, program) {
  const entry = element("article", "task");
  entry.dataset.id = task.id;
  const title = element("h3");
  const link = element("a", "", `${task.id}  ${task.title}`);
  link.href = `#${task.link}`;
  title.append(link);

  const keys = element("div", "commands");
  for (const name of task.commands) {
    const command = commands.get(name);
    if (!command) continue;
    const one = element("span", "", `${command.title} `);
    one.append(keycaps(labels(command).slice(0, 1)));
    keys.append(one);
  }

  const buttons = element("div", "buttons");
  const check = element("button", "", "Check");
  check.type = "button";
  check.onclick = async () => showVerdict(entry, await program.check(task.id));
  buttons.append(check, element("span", "verdict"));
  entry.append(title, element("p", "", task.text), keys, element("div", "source", task.source), buttons, element("ul"));
  showVerdict(entry, task);
  return entry;
}

/** Fills the panel of tasks and marks the one that the state is about. */
export async function showTasks(program, states) {
  const panel = document.getElementById("tasks");
  const labels = await keyLabels();
  const commands = new Map(program.commands().map((command) => [command.name, command]));
  for (const task of program.tasks()) panel.append(makeEntry(task, commands, labels, program));
  states.listen((state) => {
    for (const entry of panel.querySelectorAll(".task")) entry.classList.toggle("current", entry.dataset.id === state.task);
  });
}
