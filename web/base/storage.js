// What the page remembers from one visit to the next. Browsers may refuse it; then nothing is remembered.

export function recall(name) {
  try {
    return localStorage.getItem(`tanklab.${name}`);
  } catch {
    return null;
  }
}

export function remember(name, value) {
  try {
    localStorage.setItem(`tanklab.${name}`, value);
  } catch {
    // As above.
  }
}
