// The list of keys, made from the program's table of commands. Each row is a button, too.
import { commandButton } from "./command_button.js";
import { element } from "./elements.js";
import { byGroup, foldedGroup } from "./groups.js";
import { keycaps, keyLabels } from "./key_labels.js";

/** Fills the panel; rows whose commands are held are lit. */
export function showKeys({ program, layout, act }) {
  const panel = document.getElementById("keys");
  const row = (command) =>
    commandButton(command, "row", [element("span", "", command.title), keycaps(keyLabels(command, layout))], act);
  const withKeys = program.commands().filter((command) => command.keys.length > 0);
  for (const [title, commands] of byGroup(withKeys)) panel.append(foldedGroup(title, `keys.${title}`, commands.map(row)));
  panel.append(element("p", "note", "Drag the picture to go round the tank; turn the wheel, or use two fingers, to go nearer or further away."));

  const rows = [...panel.querySelectorAll("[data-command]")];
  let shown = "";
  program.listen(({ held }) => {
    if (held.join() === shown) return;
    shown = held.join();
    for (const one of rows) one.classList.toggle("held", held.includes(one.dataset.command));
  });
}
