// The list of keys, made from the program's table of commands. Rows and keys here are buttons, too.
import { byId, element } from "../base/elements.js";
import { commandRows } from "../controls/command_rows.js";
import { byGroup, foldedGroup } from "../controls/groups.js";
import { keycaps } from "../controls/key_labels.js";

// What the pointer does is no command of the table: it depends on what it points at.
const POINTER = [
  ["Fire from the eye through the pointer", "Click"],
  ["Move the point, or an end of the line", "Drag it"],
  ["Go round the tank", "Drag elsewhere"],
  ["Go nearer or further away", "Wheel, two fingers"],
];

/** Fills the panel. */
export function showKeys(parts) {
  const panel = byId("keys");
  const withKeys = parts.program.commands().filter((command) => command.keys.length > 0);
  panel.append(
    element(
      "p",
      "note",
      "The keys work while the picture has the focus: Esc leads from here to it. Rows and keys of this list are buttons, too.",
    ),
  );
  const pointer = POINTER.map(([what, how]) => element("p", "row", element("span", "", what), keycaps([how])));
  panel.append(foldedGroup("Pointer on the picture", "keys.Pointer", pointer));
  for (const [title, commands] of byGroup(withKeys)) {
    const rows = commandRows(commands, parts);
    if (rows.length === 1) {
      panel.append(rows[0]); // which says what a heading would
    } else {
      panel.append(foldedGroup(title, `keys.${title}`, rows));
    }
  }
}
