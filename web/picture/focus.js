// The keys work while the picture has the focus.

import { around, byId } from "../base/elements.js";

/** Follows the focus: a hint says when the keys do not work, a ring shows where Tab has come to. */
export function followFocus(canvas) {
  const hint = byId("focus-hint");
  let byTab = false;
  document.addEventListener("keydown", (event) => (byTab = event.key === "Tab"), true);
  document.addEventListener("pointerdown", () => (byTab = false), true);
  const follow = () => {
    const focused = document.activeElement === canvas;
    hint.hidden = focused;
    canvas.classList.toggle("ring", focused && byTab);
  };
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !event.defaultPrevented && document.body.classList.contains("ready")) {
      canvas.focus({ preventScroll: true });
    }
  });
  canvas.addEventListener("focus", follow);
  canvas.addEventListener("blur", follow);
  follow();

  // Buttons leave the focus to the picture when they are clicked, so that the keys go on working; what is
  // typed into takes it, and whoever comes to a button by Tab stays there.
  document.addEventListener("mousedown", (event) => {
    const target = around(event, "button, summary, a");
    if (target && document.activeElement === canvas) {
      event.preventDefault();
    }
  });
}
