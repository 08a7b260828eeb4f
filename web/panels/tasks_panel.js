// The lab's tasks and the handout's figures.
import { byId } from "../base/elements.js";
import { foldedGroup } from "../controls/groups.js";
import { overview } from "./overview.js";
import { TaskEntry } from "./task_entry.js";

const TITLE = document.title;
const PAUSE_MS = 100; // between two looks at the evidence

/** Fills the panel; the open entry follows the state. */
export function showTasks({ program, layout, act }) {
  const panel = byId("tasks");
  const commands = new Map(program.commands().map((command) => [command.name, command]));
  const parts = { program, commands, layout, act };
  const entries = program.tasks().map((task) => new TaskEntry(task, parts, () => update()));
  const figures = program.figures().map((figure) => new TaskEntry(figure, parts));
  const { box, update: updateOverview } = overview(entries, () => update());
  const folded = foldedGroup(
    "Figures of the handout",
    "figures",
    figures.map((entry) => entry.box),
  );
  panel.append(box, ...entries.map((entry) => entry.box), folded);

  let current = null;
  function update() {
    const said = updateOverview(current?.task.id ?? null);
    document.title = [
      said,
      current && `${current.isFigure ? "Figure " : ""}${current.task.id} ${current.task.title}`,
      TITLE,
    ]
      .filter(Boolean)
      .join(" · ");
  }
  function open(entry) {
    current?.setCurrent(false);
    current = entry;
    current?.setCurrent(true);
    if (current?.isFigure) {
      folded.open = true;
    }
    update();
  }
  const reveal = () => panel.hidden || current?.box.scrollIntoView({ block: "nearest" });
  const follow = (status) => {
    if (!status) {
      return;
    }
    const all = status.figure ? figures : entries;
    const entry = all.find(({ task }) => task.id === (status.task ?? status.figure)) ?? null;
    const isNew = entry !== current;
    if (isNew) {
      open(entry);
    }
    if (!panel.hidden) {
      current?.showEvidence();
    }
    if (isNew) {
      reveal();
    }
  };
  update();
  program.listen(follow, PAUSE_MS);
  panel.addEventListener("shown", () => {
    follow(program.newest);
    reveal();
  });
}
