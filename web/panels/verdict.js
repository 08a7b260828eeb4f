// How the verdict of a check is shown.
import { element } from "../base/elements.js";

/** Returns "passed", "failed" or "" for what a check gave. */
export const verdictOf = (passed) => (passed === true ? "passed" : passed === false ? "failed" : "");

const MARKS = { passed: "✓", failed: "✗", "": "" };

/** Returns the mark of a verdict. */
export const markOf = (passed) => MARKS[verdictOf(passed)];

/** Makes a place for a verdict in words, which is read out when it changes. */
export function verdictPlace() {
  const place = element("span", "verdict");
  place.setAttribute("role", "status");
  return place;
}

/** Writes a verdict in words, or another text before there is one. */
export function showVerdict(place, passed, text = "") {
  const verdict = verdictOf(passed);
  place.className = `verdict ${verdict}`;
  place.textContent = verdict ? `${markOf(passed)} ${verdict}` : text;
}
