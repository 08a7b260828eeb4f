// The keys work while the picture has the focus; a hint says so when it has not.

/** Watches the focus of the canvas. */
export function followFocus(canvas, program) {
  const hint = document.getElementById("focus-hint");
  canvas.addEventListener("focus", () => (hint.hidden = true));
  canvas.addEventListener("blur", () => {
    program.command("release_all");
    hint.hidden = false;
  });
  canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
  // SDL keeps every key from the browser; Tab must still lead out of the picture.
  for (const type of ["keydown", "keyup"])
    canvas.addEventListener(type, (event) => event.key === "Tab" && event.stopImmediatePropagation(), { capture: true });
}
