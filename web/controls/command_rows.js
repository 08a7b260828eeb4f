// Rows of commands with their keys. Two commands that move the same values to and fro share a row.
import { element } from "../base/elements.js";
import { commandButton } from "./command_button.js";
import { keycaps, keyLabels } from "./key_labels.js";

const isPair = (one, other) =>
  one?.kind === "hold" &&
  other?.kind === "hold" &&
  one.fields?.length > 0 &&
  one.fields.join() === other.fields?.join();

/** Returns a title with minus signs, which no line ends behind. */
const withMinus = (title) => title.replace(/-(?=[A-Z])/g, "\u2212");

/** Joins two titles that differ in the middle: "Raise / lower the gun", "Go nearer / further away". */
export function joinedTitle(one, other) {
  const [a, b] = [withMinus(one).split(" "), withMinus(other).split(" ")];
  const shorter = Math.min(a.length, b.length);
  let start = 0;
  while (start < shorter - 1 && a[start] === b[start]) {
    ++start;
  }
  let end = 0;
  while (end < shorter - start - 1 && a[a.length - 1 - end] === b[b.length - 1 - end]) {
    ++end;
  }
  const middle = (words) => words.slice(start, words.length - end).join(" ");
  const second = start === 0 ? middle(b)[0].toLowerCase() + middle(b).slice(1) : middle(b);
  return [...a.slice(0, start), `${middle(a)}\u00a0/`, second, ...a.slice(a.length - end)].join(" ");
}

function pairRow(pair, { layout, act }) {
  const buttons = pair.map((command) => {
    const made = commandButton(command, "keycap", [keycaps(keyLabels(command, layout).slice(0, 1))], act);
    made.setAttribute("aria-label", command.title);
    made.title = command.title;
    return made;
  });
  // What other keys there are comes after the first ones, of which each is a button.
  const others = pair.flatMap((command) => keyLabels(command, layout).slice(1));
  const made = element(
    "div",
    "row pair",
    element("span", "", joinedTitle(pair[0].title, pair[1].title)),
    element("span", "pads", ...buttons),
  );
  if (others.length > 0) {
    made.append(element("span", "others", "also ", keycaps(others)));
  }
  return made;
}

function singleRow(command, { layout, act }) {
  return commandButton(command, "row", [element("span", "", command.title), keycaps(keyLabels(command, layout))], act);
}

/** Returns the rows of some commands. parts: {layout, act} */
export function commandRows(commands, parts) {
  const rows = [];
  for (let i = 0; i < commands.length; ++i) {
    rows.push(
      isPair(commands[i], commands[i + 1])
        ? pairRow([commands[i], commands[++i]], parts)
        : singleRow(commands[i], parts),
    );
  }
  return rows;
}
