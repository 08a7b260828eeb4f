// The panels at the side: one is open at a time, and the page remembers which.

const STORE = "tanklab-panel";

function remembered() {
  try {
    return localStorage.getItem(STORE);
  } catch {
    return null; // Storage may be refused; then nothing is remembered.
  }
}

function remember(name) {
  try {
    localStorage.setItem(STORE, name ?? "");
  } catch {
    // As above.
  }
}

/** Joins the buttons to their panels and opens the one that was open last; at first the keys, where there is room. */
export async function joinPanels() {
  const buttons = [...document.querySelectorAll("[data-panel]")];
  const open = (name) => {
    for (const button of buttons) {
      const isOpen = button.dataset.panel === name;
      button.setAttribute("aria-expanded", String(isOpen));
      document.getElementById(button.dataset.panel).hidden = !isOpen;
    }
  };
  for (const button of buttons) {
    button.onclick = () => {
      const name = button.getAttribute("aria-expanded") === "true" ? null : button.dataset.panel;
      open(name);
      remember(name);
    };
  }
  const last = remembered();
  open(last === null ? (innerWidth >= 1000 ? "keys" : null) : last);
}
