// Short messages at the edge of the picture, each a sentence, until they are dismissed.

import { byId } from "./elements.js";

const box = byId("notices");
const shown = () => /** @type {HTMLElement[]} */ ([...box.children]);

/** Takes away the notices about a topic. */
export function dismiss(topic) {
  for (const notice of shown()) {
    if (notice.dataset.topic === topic) {
      notice.remove();
    }
  }
}

/** Shows a sentence. The same sentence is not shown twice.
    topic: what dismiss() finds it by. field: an element to show below the sentence.
    @param {string} sentence
    @param {{topic?: string, field?: HTMLElement | null}} options */
export function notify(sentence, { topic = "", field = null } = {}) {
  for (const other of shown()) {
    if (other.dataset.topic === topic && other.querySelector("p")?.textContent === sentence) {
      other.remove();
    }
  }
  const notice = document.createElement("div");
  notice.className = "panel notice";
  notice.dataset.topic = topic;
  const text = document.createElement("p");
  text.textContent = sentence;
  const close = document.createElement("button");
  close.type = "button";
  close.className = "quiet";
  close.textContent = "✕";
  close.setAttribute("aria-label", "Dismiss this message");
  close.onclick = () => notice.remove();
  notice.append(text, close);
  if (field) {
    notice.append(field);
  }
  box.append(notice);
}
