// Headings that fold what is below them, and stay folded on the next visit.
import { element } from "./elements.js";
import { recall, remember } from "./storage.js";

/** Returns the values of a table by their group, in the table's order, as a Map. */
export function byGroup(rows) {
  const groups = new Map();
  for (const row of rows) groups.set(row.group, [...(groups.get(row.group) ?? []), row]);
  return groups;
}

/** Returns an element with a heading and content that it folds. name: what it is remembered by. */
export function foldedGroup(title, name, content) {
  const group = element("details", "group", element("summary", "", element("h2", "", title)), ...content);
  group.open = recall(`folded.${name}`) !== "yes";
  group.addEventListener("toggle", () => remember(`folded.${name}`, group.open ? "no" : "yes"));
  return group;
}
