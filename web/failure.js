// What is shown when the page cannot go on.

/** A failure that the reader can be told of: what happened, where, and what to do. */
export class LoadFailure extends Error {
  constructor(title, what, advice) {
    super(what);
    this.title = title;
    this.advice = advice;
  }
}

/** Shows a failure instead of the picture. The address, and the state in it, stays. */
export function fail(error, detail = "") {
  const box = document.getElementById("failure");
  const known = error instanceof LoadFailure;
  box.querySelector("h2").textContent = known ? error.title : "The program stopped";
  box.querySelector(".what").textContent = known ? error.message : "Something went wrong that it did not expect.";
  box.querySelector(".advice").textContent = known
    ? error.advice
    : "Load the page again: the address keeps your state. If it happens again, report it with the details below.";
  const details = known ? detail : `${error?.stack ?? error}\n${detail}`;
  box.querySelector("pre").textContent = details;
  box.querySelector("details").hidden = !details;
  box.querySelector("button").onclick = () => location.reload();
  box.hidden = false;
  document.getElementById("loading").hidden = true;
}
