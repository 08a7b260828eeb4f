// Copying, also where the browser does not let a page use the clipboard.

/** Copies a text. Where that is refused, selects `element`, which shows the text, to be copied by hand.
    Returns whether the text is in the clipboard.
    @param {string} text
    @param {HTMLElement | null} element */
export async function copyText(text, element = null) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // Not a secure address (a file, plain http), or not allowed.
  }
  if (!element) {
    return false;
  }
  if (element instanceof HTMLInputElement) {
    element.focus();
    element.select();
  } else {
    getSelection()?.selectAllChildren(element);
  }
  try {
    return document.execCommand("copy");
  } catch {
    return false;
  }
}
