// Short messages at the edge of the picture.

const box = document.getElementById("notices");

/** Shows a sentence until it is dismissed. A topic replaces its last notice; null only removes that. */
export function notify(sentence, topic = "") {
  if (topic) box.querySelector(`[data-topic="${topic}"]`)?.remove();
  if (sentence === null) return null;
  const notice = document.createElement("div");
  notice.className = "notice panel";
  notice.dataset.topic = topic;
  const text = document.createElement("span");
  text.textContent = sentence;
  const close = document.createElement("button");
  close.type = "button";
  close.textContent = "✕";
  close.setAttribute("aria-label", "Dismiss");
  close.onclick = () => notice.remove();
  notice.append(text, close);
  box.append(notice);
  return notice;
}
