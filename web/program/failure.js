// What is shown when the page cannot go on.
import { copyText } from "../base/clipboard.js";
import { byId } from "../base/elements.js";

/** A failure that people can be told of: what happened and where (the message), and what to do (the advice). */
export class LoadFailure extends Error {
  constructor(title, message, advice) {
    super(message);
    this.title = title;
    this.advice = advice;
  }
}

function detailsOf(error, printed) {
  const stack = String(error?.stack ?? "");
  const message = String(error?.message ?? error);
  const lines = stack.includes(message) ? [stack] : [message, stack];
  return [...lines, ...printed, location.href, navigator.userAgent].filter(Boolean).join("\n");
}

/** Shows a failure over the page; the first one stays. The address is left as it is, and with it the state.
    printed: what the program said before. */
export function showFailure(error, printed = []) {
  const box = byId("failure");
  if (!box.hidden) {
    return;
  }
  const part = (selector) => /** @type {any} */ (box.querySelector(selector)); // elements of many kinds
  const known = error instanceof LoadFailure;
  part("h2").textContent = known ? error.title : "The program stopped";
  part(".what").textContent = known ? error.message : "Tank Lab came upon a fault of its own and cannot go on.";
  part(".advice").textContent = known
    ? error.advice
    : "Reload the page: the address keeps what you see. If it stops again, report it with the details below.";
  part("pre").textContent = known ? "" : detailsOf(error, printed);
  part("details").hidden = known;
  part("#reload").onclick = () => location.reload();
  const copy = part("#copy-details");
  copy.hidden = known;
  copy.onclick = async () => {
    part("details").open = true;
    const done = await copyText(part("pre").textContent, part("pre"));
    copy.textContent = done ? "Copied" : "Selected: press Ctrl+C";
  };

  byId("loading").hidden = true;
  for (const other of document.querySelectorAll("body > :not(#failure)")) {
    other.setAttribute("inert", "");
  }
  box.hidden = false;
  part("#reload").focus();
}
