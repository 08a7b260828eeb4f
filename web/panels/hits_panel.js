// What is penetrated: as it is now, level by level, and what was printed.
import { byId, element } from "../base/elements.js";
import { commandButton } from "../controls/command_button.js";
import { segmentsControl } from "../controls/controls.js";
import { keycaps, keyLabels } from "../controls/key_labels.js";
import { HitsLog } from "./hits_log.js";
import { announcer, showReport } from "./hits_report.js";

const PAUSE_MS = 80; // between two looks at what is hit

/** Fills the panel; it follows the state. */
export function showHits({ program, layout, act }) {
  const panel = byId("hits");
  const commands = new Map(program.commands().map((command) => [command.name, command]));
  const probe = segmentsControl(commands.get("probe"), act);
  const now = element("div", "now");
  const log = new HitsLog();
  const print = commands.get("print_report");
  const printing = commandButton(print, "chip", [keycaps(keyLabels(print, layout).slice(0, 1)), "Print again"], act);
  printing.setAttribute("aria-label", print.title);
  const announce = announcer(byId("hits-said"));
  panel.append(
    element("h2", "", "Tested against the spheres"),
    ...probe.elements.slice(1),
    now,
    element("div", "heading", element("h2", "", "Printed"), printing),
    log.list,
  );

  let shown = "";
  let printed = -1; // how much had been when the report was looked at last
  const update = (status) => {
    // What is said changes with what is printed only; the numbers that are shown change more often.
    if (!status || (panel.hidden && status.printed === printed)) {
      return;
    }
    printed = status.printed;
    const report = program.report();
    announce(report);
    if (panel.hidden) {
      return;
    }
    probe.show(status.probe);
    const text = JSON.stringify(report);
    if (text !== shown) {
      showReport(now, report);
    }
    shown = text;
    if (log.count !== printed) {
      log.show(program.hits());
    }
  };
  program.listen(update, PAUSE_MS);
  panel.addEventListener("shown", () => update(program.newest));
}
