// Headings that fold what is below them, and stay so on the next visit.
import { element } from "../base/elements.js";
import { recall, remember } from "../base/storage.js";

/** Returns the values of a table by their group, in the table's order, as a Map. */
export function byGroup(rows) {
  const groups = new Map();
  for (const row of rows) {
    groups.set(row.group, [...(groups.get(row.group) ?? []), row]);
  }
  return groups;
}

/** Returns an element with a heading and content that it folds. name: what it is remembered by.
    open: whether it is so at first. */
export function foldedGroup(title, name, content, { open = true } = {}) {
  const group = element("details", "group", element("summary", "", element("h2", "", title)), ...content);
  group.open = (recall(`folded.${name}`) ?? (open ? "no" : "yes")) !== "yes";
  // Not on "toggle", which comes also when it was no person that folded it.
  group.firstChild.addEventListener("click", () => remember(`folded.${name}`, group.open ? "yes" : "no"));
  return group;
}
