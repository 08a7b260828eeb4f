// What the program printed about hits: a list of reports, the newest first, as the program has it.
import { element } from "../base/elements.js";

export class HitsLog {
  /** How many reports and events the list has seen. */
  count = 0;
  list = element("ol", "log");
  #reports = new Map(); // by their numbers

  constructor() {
    this.list.setAttribute("aria-label", "What was printed, the newest first");
    this.list.tabIndex = 0; // so that it scrolls by keys
  }

  /** Adds what has been printed since, and takes away what the program keeps no more. */
  show({ count, log }) {
    for (const { report, text } of log) {
      if (report <= this.count) {
        continue;
      }
      if (!this.#reports.has(report)) {
        const item = element("li");
        item.dataset.report = report;
        this.#reports.set(report, item);
        this.list.prepend(item);
      }
      this.#reports.get(report).append(element("p", "", text));
    }
    this.count = count;
    const oldest = log[0]?.report ?? 0;
    for (const [report, item] of this.#reports) {
      if (report >= oldest) {
        break;
      }
      item.remove();
      this.#reports.delete(report);
    }
  }
}
