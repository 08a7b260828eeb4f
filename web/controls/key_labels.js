// What keys are called: what is printed on the reader's own keyboard where the browser tells, else the
// program's label, which is that of a US keyboard. The keys themselves are places, the same on every keyboard.
import { element } from "../base/elements.js";

/** Returns the browser's map from a key's code to what it prints, or null where it does not tell. */
export async function readKeyboardLayout() {
  try {
    return (await navigator.keyboard?.getLayoutMap?.()) ?? null;
  } catch {
    return null; // not allowed, in a frame of another site
  }
}

/** Returns the labels of a command's keys, for a layout that may be null. */
export function keyLabels(command, layout) {
  return command.keys.map((code, i) => {
    const printed = /^(Key|Digit|Minus|Equal)/.test(code) ? layout?.get(code) : null;
    const upper = printed?.toUpperCase();
    return upper?.length === 1 ? upper : (printed ?? command.key_labels[i]);
  });
}

/** Returns an element with a keycap for each label. */
export function keycaps(labels) {
  return element("span", "keycaps", ...labels.map((label) => element("kbd", "", label)));
}
