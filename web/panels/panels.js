// The panels: one at the right side, or none, and the page remembers which. In a wide window what is hit has a
// place of its own at the left; in a narrow one it is a panel like the others.
import { byId } from "../base/elements.js";
import { recall, remember } from "../base/storage.js";

const ROOM_FOR_A_PANEL = 1100; // CSS pixels: below, a panel that opens by itself would be in the way
const WIDE = matchMedia("(min-width: 1000px)"); // as in style.css

/** Joins the buttons to their panels and opens those that were open last.
    bare: none may open. task: the address is about a task, so the tasks are what people come for. */
export function joinPanels({ canvas, program, bare, task }) {
  /** @type {NodeListOf<HTMLElement>} */
  const buttons = document.querySelectorAll("[data-panel]");
  let chosen = task ? "tasks" : (recall("panel") ?? (innerWidth >= ROOM_FOR_A_PANEL ? "keys" : ""));
  let hits = recall("hits"); // "yes", "no", or null: once something is tested
  let wasTested = false; // since the task was opened: a panel does not close under the hand that chose "None" in it

  const isOpen = (name) => {
    if (name !== "hits" || !WIDE.matches) {
      return name === chosen;
    }
    return hits ? hits === "yes" : wasTested;
  };
  const show = () => {
    for (const button of buttons) {
      const panel = byId(String(button.dataset.panel));
      const open = !bare && isOpen(panel.id);
      if (!open && panel.contains(document.activeElement)) {
        canvas.focus({ preventScroll: true });
      }
      button.setAttribute("aria-expanded", String(open));
      if (panel.hidden === !open) {
        continue;
      }
      panel.hidden = !open;
      if (open) {
        panel.dispatchEvent(new Event("shown"));
      }
    }
    const shown = (name) => !byId(name).hidden;
    const left = WIDE.matches && shown("hits");
    document.body.classList.toggle("panel-left", left);
    document.body.classList.toggle(
      "panel-right",
      [...buttons].some((button) => shown(button.dataset.panel) && !(left && button.dataset.panel === "hits")),
    );
  };
  const choose = (name) => {
    if (name === "hits" && WIDE.matches) {
      hits = isOpen("hits") ? "no" : "yes";
      remember("hits", hits);
    } else {
      chosen = isOpen(name) ? "" : name;
      remember("panel", chosen);
    }
    show();
  };
  for (const button of buttons) {
    button.onclick = () => choose(button.dataset.panel);
  }
  WIDE.addEventListener("change", show);

  // Who opens a task wants to read it, and who tests something wants to see what is hit.
  let shownTask;
  program.listen((status) => {
    const id = status.task ?? status.figure;
    const opened = id !== shownTask && shownTask !== undefined && id !== null;
    const tested = status.probe !== "none" || (wasTested && !opened);
    if (!opened && tested === wasTested && shownTask !== undefined) {
      return;
    }
    shownTask = id;
    wasTested = tested;
    if (opened) {
      chosen = "tasks";
    }
    show();
  });
  show();
}
