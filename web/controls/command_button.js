// A button that does what a command's key does: for as long as it is pressed, or once.
import { button } from "../base/elements.js";

const TOUCH_DELAY_MS = 120; // by then a finger that scrolls has moved
const TAP_MS = 150; // how long a short tap, or a click without a pointer, holds

/** Makes `made` hold a command by pointer and keyboard. act: does a command, telling what goes wrong. */
function holdWhilePressed(made, name, act) {
  let held = false;
  let timer = 0;
  const hold = () => {
    clearTimeout(timer);
    timer = 0;
    if (!held) {
      act(name, 1);
    }
    held = true;
  };
  const release = () => {
    clearTimeout(timer);
    timer = 0;
    if (held) {
      act(name, 0);
    }
    held = false;
  };
  const tap = () => {
    hold();
    timer = setTimeout(release, TAP_MS);
  };

  made.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) {
      return;
    }
    if (event.pointerType !== "touch") {
      made.setPointerCapture(event.pointerId);
      hold();
    } else if (!timer) {
      timer = setTimeout(hold, TOUCH_DELAY_MS);
    }
  });
  made.addEventListener("pointerup", () => (timer && !held ? tap() : release()));
  for (const end of ["pointercancel", "lostpointercapture", "blur"]) {
    made.addEventListener(end, () => {
      // A tap ends by itself.
      if (!(held && timer)) {
        release();
      }
    });
  }
  made.addEventListener("touchmove", (event) => held && event.cancelable && event.preventDefault(), { passive: false });
  made.addEventListener("contextmenu", (event) => event.preventDefault()); // what a long touch asks for
  addEventListener("blur", release);

  const presses = (event) => event.code === "Enter" || event.code === "Space" || event.code === "NumpadEnter";
  made.addEventListener("keydown", (event) => {
    if (!presses(event)) {
      return;
    }
    event.preventDefault();
    if (!event.repeat) {
      hold();
    }
  });
  made.addEventListener("keyup", (event) => {
    if (!presses(event)) {
      return;
    }
    event.preventDefault(); // or Space would be a click as well
    release();
  });
  // A click that no pointer and no key made comes from a screen reader or a voice.
  made.addEventListener("click", (event) => event.detail === 0 && !held && tap());
}

const buttons = []; // all that were made

/** Lights the buttons of commands that are held, by whatever key or button. */
export function lightHeld(program) {
  let shown = "";
  program.listen(({ held }) => {
    if (held.join() === shown) {
      return;
    }
    shown = held.join();
    for (const one of buttons) {
      one.classList.toggle("held", held.includes(one.dataset.command));
    }
  });
}

/** Makes the button of a row of the table of commands. */
export function commandButton(command, className, content, act) {
  const made = button(className, content);
  made.dataset.command = command.name;
  buttons.push(made);
  if (command.kind === "hold") {
    holdWhilePressed(made, command.name, act);
  } else {
    made.addEventListener("click", () => act(command.name, 1));
  }
  return made;
}
