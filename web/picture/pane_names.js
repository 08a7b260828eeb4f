// The names of the four views that share the picture, in the places where src/app/view/frame.cpp puts them.

import { byId } from "../base/elements.js";

/** Shows the names while there are four, and keeps the picture beside the panels then. */
export function namePanes(program) {
  const names = byId("pane-names");
  program.listen((status) => {
    names.hidden = status.view !== "four";
    document.body.classList.toggle("four", !names.hidden);
  }, 0);
}
