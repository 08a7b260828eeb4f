// A task or figure in the list: a link that opens it, and below that, while it is open, what to see, which keys
// to press, the evidence, where it stands in the source, and whether it is right.
import { button, element } from "../base/elements.js";
import { notify } from "../base/notices.js";
import { commandRows } from "../controls/command_rows.js";
import { evidenceList } from "./evidence.js";
import { markOf, showVerdict, verdictOf, verdictPlace } from "./verdict.js";

/** Returns a turn of the browser, in which it can show what has changed. */
const painted = () => new Promise((resolve) => setTimeout(resolve, 30));

export class TaskEntry {
  /** parts: {program, commands, layout, act}, commands by their names. changed: called after each check. */
  constructor(task, parts, changed = () => {}) {
    this.task = task;
    this.program = parts.program;
    this.changed = changed;
    this.isFigure = task.kind === "figure";

    this.mark = element("span", "mark");
    this.head = element("a", "head", element("span", "id", task.id), element("h3", "", task.title), this.mark);
    this.head.href = `#${task.link}`;
    this.live = evidenceList(parts.commands.get("axis"), parts.act);
    this.verdict = verdictPlace();
    this.found = element("ul", "found");
    const commands = task.commands.map((name) => parts.commands.get(name)).filter(Boolean);
    this.card = element(
      "div",
      "card",
      element("p", "", task.text),
      element("div", "rows", ...commandRows(commands, parts)),
      this.live.list,
    );
    const again = element("a", "button", "Start over");
    again.href = this.head.href;
    const buttons = element("div", "buttons", again);
    if (!this.isFigure) {
      this.checking = button("", "Check", async () => {
        await this.check();
        this.found.scrollIntoView({ block: "nearest" });
      });
      this.checking.setAttribute("aria-label", `Check ${task.id}, ${task.title}`);
      buttons.append(this.checking, this.verdict);
    }
    this.card.append(buttons);
    this.source = element("p", "source", "Source: ", element("code", "", task.source));
    this.box = element("article", "task", this.head, this.card, this.found, this.source);
    this.box.dataset.id = task.id;
    this.setCurrent(false);
    this.show(task);
  }

  /** Shows what a check found, or that there was none. What failed is said even while the task is not open.
      @param {{passed: boolean | null, evidence?: string[]}} found */
  show({ passed, evidence }) {
    this.passed = passed;
    this.mark.textContent = markOf(passed);
    this.mark.className = `mark ${verdictOf(passed)}`;
    this.mark.setAttribute("aria-label", verdictOf(passed));
    showVerdict(this.verdict, passed);
    this.found.replaceChildren(...(evidence ?? []).map((sentence) => element("li", "", sentence)));
    this.box.classList.toggle("is-failed", passed === false);
  }

  /** Opens or closes the entry; it does not change the state. */
  setCurrent(current) {
    if (current) {
      this.head.setAttribute("aria-current", "true");
    } else {
      this.head.removeAttribute("aria-current");
    }
    this.box.classList.toggle("current", current);
  }

  /** Shows the live evidence of the state, which is that of the open task. */
  showEvidence() {
    this.live.show(this.program.evidence());
  }

  /** Runs the task's check and shows its verdict. Returns whether it passed, or null without a verdict. */
  async check() {
    showVerdict(this.verdict, null, "checking …");
    this.checking.disabled = true;
    await painted();
    try {
      const result = await this.program.check(this.task.id);
      this.show(result);
      if (result.passed === null) {
        showVerdict(this.verdict, null, "has no check");
      }
    } catch (error) {
      this.show({ passed: null });
      notify(error.message, { topic: "command" });
    } finally {
      this.checking.disabled = false;
    }
    this.changed();
    return this.passed;
  }
}
