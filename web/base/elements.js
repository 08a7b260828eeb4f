// Making elements.

/** Makes an element with a class, and content: texts and elements. */
export function element(name, className = "", ...content) {
  const made = document.createElement(name);
  if (className) {
    made.className = className;
  }
  made.append(...content);
  return made;
}

/** Makes a button; a press of it calls action, if there is one. */
export function button(className, content, action = null) {
  const made = element("button", className, ...[content].flat());
  made.type = "button";
  made.onclick = action;
  return made;
}
