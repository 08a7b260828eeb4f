// Finding elements, and making them.

/** Returns the element of index.html that has an id.
    @param {string} id */
export const byId = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** Returns the nearest element that a selector matches and an event happened in, or null.
    @param {Event} event
    @param {string} selector */
export const around = (event, selector) => (event.target instanceof Element ? event.target.closest(selector) : null);

/** Makes an element with a class, and content: texts and elements. */
export function element(name, className = "", ...content) {
  const made = document.createElement(name);
  if (className) {
    made.className = className;
  }
  made.append(...content);
  return made;
}

/** Makes a button; a press of it calls action, if there is one.
    @param {(() => unknown) | null} action */
export function button(className, content, action = null) {
  const made = element("button", className, ...[content].flat());
  made.type = "button";
  made.onclick = action;
  return made;
}
