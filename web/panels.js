// The panels: one is open at a time, or none, and the page remembers which.
import { recall, remember } from "./storage.js";

const ROOM_FOR_A_PANEL = 1100; // CSS pixels: below, a panel that opens by itself would be in the way

/** Joins the buttons to their panels and opens the one that was open last.
    bare: none may open. task: the address is about a task, so the tasks are what people come for. */
export function joinPanels(canvas, { bare, task }) {
  const buttons = [...document.querySelectorAll("[data-panel]")];
  const show = (name) => {
    for (const button of buttons) {
      const panel = document.getElementById(button.dataset.panel);
      const open = button.dataset.panel === name;
      if (!open && panel.contains(document.activeElement)) canvas.focus({ preventScroll: true });
      button.setAttribute("aria-expanded", String(open));
      panel.hidden = !open;
    }
    document.body.classList.toggle("with-panel", buttons.some((button) => button.dataset.panel === name));
  };
  const choose = (name) => {
    show(name);
    remember("panel", name);
  };
  for (const button of buttons)
    button.onclick = () => choose(button.getAttribute("aria-expanded") === "true" ? "" : button.dataset.panel);
  document.querySelector("aside").addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !event.defaultPrevented) choose("");
  });
  if (bare) return;
  show(task ? "tasks" : (recall("panel") ?? (innerWidth >= ROOM_FOR_A_PANEL ? "keys" : "")));
}
