// How keys are written: by what is printed on the reader's own keyboard, where the browser tells.

/** Returns a function from a command to the labels of its keys. */
export async function keyLabels() {
  const layout = (await navigator.keyboard?.getLayoutMap?.().catch(() => null)) ?? null;
  return (command) =>
    command.keys.map((code, i) => {
      const printed = layout?.get(code);
      return printed ? printed.toUpperCase() : command.key_labels[i];
    });
}

/** Returns an element with a keycap for each label. */
export function keycaps(labels) {
  const caps = document.createElement("span");
  caps.className = "caps";
  for (const label of labels) {
    const cap = document.createElement("kbd");
    cap.textContent = label;
    caps.append(cap);
  }
  return caps;
}
