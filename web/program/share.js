// The button that copies the address of what is shown.
import { copyText } from "../base/clipboard.js";
import { byId, element } from "../base/elements.js";
import { dismiss, notify } from "../base/notices.js";
import { addressOf } from "./address.js";

const COPIED_MS = 1800;

/** Joins the Share button. Where the page may not copy, the address is shown and selected instead. */
export function joinShareButton(program) {
  const button = byId("share");
  const label = button.textContent;
  let timer = 0;
  button.onclick = async () => {
    dismiss("share");
    const address = addressOf(program);
    const field = element("input");
    field.readOnly = true;
    field.value = address;
    field.setAttribute("aria-label", "The address of what is shown");
    if (!(await copyText(address))) {
      notify("The browser does not let this page copy. Copy the address from here:", { topic: "share", field });
      if (!(await copyText(address, field))) {
        return;
      }
      dismiss("share");
    }
    if (program.newest.tank === "own") {
      notify("The link shows a tank of your own files, and they are not in it: whoever opens it is asked for them.", {
        topic: "share",
      });
    }
    button.textContent = "Copied";
    button.classList.add("done");
    clearTimeout(timer);
    timer = setTimeout(() => {
      button.textContent = label;
      button.classList.remove("done");
    }, COPIED_MS);
  };
}
